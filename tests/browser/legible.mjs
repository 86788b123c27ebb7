// This tells whether a page can be read: contrast by WCAG 2.2, level AA, and no scrolling to the side.
import assert from "node:assert/strict";
import { contrast } from "./colour_science.mjs";

// Collects in the page each element with a text of its own, its colour, and the colours of what is behind it, nearest
// first.
function textsAndColours() {
  const texts = [];
  for (const element of document.querySelectorAll("body *")) {
    const text = [...element.childNodes].filter((node) => node.nodeType === 3).map((node) => node.data.trim()).join(" ").trim();
    if (text === "" || element.getClientRects().length === 0 || element.matches("script, option, .unseen")) continue;
    const behind = [];
    for (let at = element; at !== null; at = at.parentElement) behind.push(getComputedStyle(at).backgroundColor);
    const style = getComputedStyle(element);
    texts.push({ text: text.slice(0, 40), colour: style.color, behind, size: parseFloat(style.fontSize), weight: Number(style.fontWeight) });
  }
  return texts;
}

function parsed(css) {
  const [r, g, b, alpha = 1] = css.match(/[\d.]+/g).map(Number);
  return { colour: [r, g, b].map((c) => c / 255), alpha };
}

// Backgrounds are opaque or nothing at all; another kind would have to be mixed here.
function background(behind) {
  for (const { colour, alpha } of behind.map(parsed)) {
    assert.ok(alpha === 0 || alpha === 1, "a background that is half transparent");
    if (alpha === 1) return colour;
  }
  return [1, 1, 1];
}

export async function assertContrast(page, atLeast) {
  const texts = await page.evaluate(textsAndColours);
  assert.ok(texts.length >= atLeast, `only ${texts.length} texts`);
  for (const { text, colour, behind, size, weight } of texts) {
    const isLarge = size >= 24 || (size >= 18.66 && weight >= 700);
    const ratio = contrast(parsed(colour).colour, background(behind));
    assert.ok(ratio >= (isLarge ? 3 : 4.5), `"${text}": contrast ${ratio.toFixed(2)}`);
  }
}

export async function assertNoSidewaysScrolling(page) {
  const [scroll, client] = await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.clientWidth]);
  assert.ok(scroll <= client, `the page is ${scroll} wide, the window ${client}`);
}
