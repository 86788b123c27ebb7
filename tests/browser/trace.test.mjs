// The page of `sightline trace` is tested in a browser: Fang's tables row by row, every way to step, "What next?",
// keyboard, phone, contrast, colours, names.
import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { difference, eyes, seenBy } from "./colour_science.mjs";
import { assertContrast, assertNoSidewaysScrolling } from "./legible.mjs";
import { desktop, phone, runSightline, startBrowser, temporaryFolder, withPage } from "./page_case.mjs";

const table52 = [
  ["O", "o", "1, 2", "", ""],
  ["E", "o", "1, 2", "e", "3, 4"],
  ["F", "o, f", "1, 2, 5", "e", "3, 4"],
  ["A", "o, f", "1, 2, 5", "e, a", "3, 4, 6"],
  ["D", "o, f, d'", "1, 2, 5, 8", "e, a, d", "3, 4, 6, 7"],
  ["G", "o, f, d', g", "1, 2, 5, 8, 9, 10", "e, a, d", "3, 4, 6, 7"],
  ["C", "o, f, d', g, c'", "1, 2, 5, 8, 9, 10, 12", "e, a, d, c", "3, 4, 6, 7, 11"],
  ["P", "o, f, d', g, c', p", "1, 2, 5, 8, 9, 10, 12, 13", "e, a, d, c", "3, 4, 6, 7, 11"],
  ["H", "o, f, d', g, c', p, h", "1, 2, 5, 8, 9, 10, 12, 13", "e, a, d, c", "3, 4, 6, 7, 11"],
  ["I", "o, f, d', g, c', p, h, i", "1, 2, 5, 8, 9, 10, 12, 13, 14", "e, a, d, c", "3, 4, 6, 7, 11"],
  ["B", "o, f, d', g, c', p, h, i", "1, 2, 5, 8, 9, 10, 12, 13, 14", "e, a, d, c, b", "3, 4, 6, 7, 11"],
  ["Q", "o, f, d', g, c', p, h, i, q", "1, 2, 5, 8, 9, 10, 12, 13, 14", "e, a, d, c, b", "3, 4, 6, 7, 11"],
];
const table54 = ["o f", "q o", "e a", "d e", "f d'", "a b", "c d", "d' c'", "g p", "h g", "b c", "c' i", "p h", "i q"];

const folder = temporaryFolder();
let browser;
before(async () => (browser = await startBrowser()));
after(() => browser.close());

function traced(name, ...scene) {
  const file = join(folder, `${name}.html`);
  runSightline("trace", ...scene, "-o", file);
  return file;
}

const example = (name) => traced(name, "--example", name);
const isReady = () => document.getElementById("place").textContent !== "";

// Opens the page at a step, by its link.
function onStep(file, step, test, viewport = desktop) {
  return withPage(browser, file, { viewport, ready: isReady }, async (page) => {
    await page.goto(`${page.url().split("#")[0]}#step=${step}`);
    await page.waitForFunction((s) => document.getElementById("place").textContent.startsWith(`Step ${s} `), step);
    await test(page);
  });
}

const captions = (page) => page.locator("#drawing figcaption").allInnerTexts();
const placeOf = (page) => page.locator("#place").innerText();
const pointOf = (page) => page.locator("#sentence .headline b").innerText();
const rowsOf = (page, section) =>
  page.locator(`#${section} tbody tr`).evaluateAll((rows) =>
    rows.map((row) => [...row.cells].map((cell) => cell.textContent)));

test("each row of table 5.2 as the sweep goes by", async () => {
  await onStep(example("fang"), 0, async (page) => {
    for (let step = 1; step <= table52.length; ++step) {
      await page.click("#forward");
      assert.deepEqual(await rowsOf(page, "polygons"), table52.slice(0, step));
      assert.equal(await pointOf(page), table52[step - 1][0]);
    }
  });
});

test("each row of table 5.4 at the end, open ends before", async () => {
  await onStep(example("fang"), 1, async (page) => {
    assert.deepEqual(await rowsOf(page, "segments"), [["1", "OPQ", "o", "?"], ["2", "OPQ", "?", "o"]]);
    await page.click("#last");
    const rows = await rowsOf(page, "segments");
    assert.deepEqual(rows.map(([number, , start, end]) => `${number}: ${start} ${end}`),
      table54.map((ends, i) => `${i + 1}: ${ends}`));
    const rings = await page.locator("#rings li .names").allInnerTexts();
    assert.deepEqual(rings.sort(), ["e a b c d", "g p h", "o f d' c' i q"]);
  });
});

test("the active edge list has its node lists, the event queue what comes next", async () => {
  await onStep(example("fang"), 6, async (page) => {
    assert.deepEqual(await rowsOf(page, "active"), [["OP", "–", "9", "OPQ"], ["AB", "10", "6", "ABCDE, OPQ"],
      ["DC", "7", "8", "OPQ"], ["OQ", "2", "–", "nothing"]]);
    assert.deepEqual(await page.locator("#queue li b").allInnerTexts(), ["C", "P", "B", "Q"]);
  });
});

test("buttons, keys, slider and link lead to the same steps", async () => {
  await onStep(example("fang"), 5, async (page) => {
    assert.equal(await pointOf(page), "D");
    const after = async (act, place) => { await act(); assert.equal(await placeOf(page), `Step ${place} of 12`); };
    await after(() => page.keyboard.press("ArrowRight"), 6);
    await after(() => page.keyboard.press("ArrowLeft"), 5);
    await after(() => page.keyboard.press("End"), 12);
    await after(() => page.keyboard.press("Home"), 0);
    await after(() => page.locator("#slider").fill("9"), 9);
    await after(() => page.click("#back"), 8);
    await after(() => page.evaluate(() => { location.hash = "#step=3"; }).then(() => page.waitForTimeout(100)), 3);
    assert.equal(new URL(page.url()).hash, "#step=3");
    await after(() => page.click("#first"), 0);
    await after(() => page.click("#last"), 12);
  });
});

test("play goes on by itself and stops at the end", async () => {
  await onStep(example("fang"), 10, async (page) => {
    await page.selectOption("#pace", "500");
    await page.locator("#scene-heading").click();
    await page.keyboard.press(" ");
    assert.equal(await page.locator("#play").innerText(), "Pause");
    await page.waitForFunction(() => document.getElementById("place").textContent === "Step 12 of 12");
    await page.waitForFunction(() => document.getElementById("play").textContent === "Play");
  });
});

test("What next? hides the next step until its point is picked, and says why", async () => {
  await onStep(example("fang"), 5, async (page) => {
    await page.check("#quiz-mode");
    assert.equal(await page.locator("#forward").isDisabled(), true);
    await page.keyboard.press("End");
    assert.equal(await placeOf(page), "Step 5 of 12");
    assert.equal(await page.locator("#queue li b").count(), 0);
    assert.deepEqual(await page.locator("#quiz button").allInnerTexts(), ["AB × OP", "B", "C", "P"]);
    await page.click("#quiz button:text-is('C')");
    assert.match(await page.locator("#quiz .verdict").innerText(), /^Not C: .*higher/);
    assert.equal(await placeOf(page), "Step 5 of 12");
    await page.click("#quiz button:text-is('AB × OP')");
    assert.match(await page.locator("#quiz .right").innerText(), /^Right: G is next, since it is the highest/);
    assert.equal(await placeOf(page), "Step 6 of 12");
  });
});

test("what is pointed at in one view is lit in the others", async () => {
  await onStep(example("fang"), 6, async (page) => {
    await page.locator("#active tbody tr").nth(1).locator(".edge").hover();
    assert.ok((await page.locator("#drawing .edge-line.lit").count()) > 0);
    assert.ok((await page.locator("#segments tr.lit").count()) > 0);
    await page.locator("#rings-heading").hover();
    assert.equal(await page.locator(".lit").count(), 0);
    await page.locator("#segments tr.item").first().focus();
    assert.ok((await page.locator("#drawing .segment-line.lit").count()) > 0);
  });
});

test("the predicates behind a step have operands, sign, and what decided", async () => {
  await onStep(example("fang"), 3, async (page) => {
    await page.click("#predicates summary");
    const first = await page.locator("#predicates li").first().innerText();
    assert.match(first, /order F comes before A: higher\. Sign −, decided by integers/);
    assert.ok((await page.locator("#predicates .operands td").count()) > 4);
  });
});

test("float beside exact: the first step at which they differ, and wrong signs", async () => {
  await onStep(example("float-wrong"), 0, async (page) => {
    await page.click("#difference a");
    await page.waitForFunction(() => /^Step [1-9]/.test(document.getElementById("place").textContent));
    assert.match(await page.locator("#difference .says").innerText(), /^exact at step/);
    assert.ok((await page.locator("#predicates .is-wrong").count()) > 0);
    assert.deepEqual(await captions(page), ["float", "exact"]);
    await page.check("#sweeps input >> nth=1");
    assert.match((await captions(page)).join(), /^exact,float/);
    assert.match(await page.locator("#difference .says").innerText(), /^float at step/);
    assert.equal(await page.locator("#predicates .is-wrong").count(), 0);
    await page.click("#last");
    assert.deepEqual(await captions(page), ["exact", "float"]);
    assert.equal(await page.locator("#drawing figure:nth-child(2) [data-keys]").count(), 0);
  });
});

test("the keyboard alone reaches everything and steps through", async () => {
  await onStep(example("fang"), 4, async (page) => {
    const reached = new Set();
    for (let i = 0; i < 24; ++i) {
      await page.keyboard.press("Tab");
      reached.add(await page.evaluate(() => {
        const focused = document.activeElement;
        return focused.id || focused.closest("section")?.id || focused.tagName;
      }));
    }
    for (const id of ["first", "back", "forward", "last", "play", "pace", "quiz-mode", "slider", "predicates", "queue",
      "active", "polygons", "segments"]) assert.ok(reached.has(id) || (id === "predicates" && reached.has("step")), id);
    await page.locator("#queue .item").first().focus();
    await page.keyboard.press("ArrowDown");
    assert.equal(await page.evaluate(() => document.activeElement.matches("#queue .item:nth-child(2)")), true);
  });
});

for (const [name, viewport] of Object.entries({ desktop, phone })) {
  test(`on a ${name} nothing is wider than the window, and texts have the contrast of WCAG AA`, async () => {
    await onStep(example("hole"), 7, async (page) => {
      await page.click("#predicates summary");
      await assertNoSidewaysScrolling(page);
      await assertContrast(page, 100);
      await page.check("#quiz-mode");
      await assertContrast(page, 100);
    }, viewport);
  });
}

test("on a desktop the page needs no scrolling at all", async () => {
  await onStep(example("float-wrong"), 12, async (page) => {
    const high = await page.evaluate(() => document.documentElement.scrollHeight);
    assert.ok(high <= desktop.height, `${high}`);
  });
});

// Returns, in the page, the backgrounds of names of faces.
function chipColours() {
  const probe = document.body.appendChild(document.createElement("span"));
  const colours = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => {
    probe.className = `chip face-${i}`;
    return getComputedStyle(probe).backgroundColor.match(/\d+/g).map((c) => c / 255);
  });
  probe.remove();
  return colours;
}

test("the colours of faces differ by 20 in L*a*b* to every eye, and each comes with a name", async () => {
  await onStep(example("many-through-one"), 20, async (page) => {
    const colours = await page.evaluate(chipColours);
    for (const [name, eye] of Object.entries(eyes)) {
      colours.forEach((a, i) => colours.slice(0, i).forEach((b, j) => {
        const apart = difference(seenBy(eye, a), seenBy(eye, b));
        assert.ok(apart >= 20, `${name}: ${i} and ${j}: ${apart.toFixed(1)}`);
      }));
    }
    for (const text of await page.locator(".chip").allInnerTexts()) assert.match(text, /^[A-Z]{3}$/);
  });
});

test("a hostile name stays text", async () => {
  const name = "<img src=x onerror=document.title='run'><script>document.title='run'<\u2215script>.toml";
  writeFileSync(join(folder, "one.obj"), "v 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 2 3\n");
  writeFileSync(join(folder, name), '[mesh]\nfile = "one.obj"\n[[camera]]\nname = "view"\neye = [1, 1, 9]\n' +
    "target = [1, 1, 0]\nup = [0, 1, 0]\northographic_height = 9.0\n");
  await onStep(traced("hostile", join(folder, name)), 1, async (page) => {
    assert.ok((await page.locator("#title").innerText()).endsWith(name));
    assert.ok((await page.title()).includes(name));
    assert.equal(await page.locator("img").count(), 0);
    assert.equal(await page.locator("script").count(), 2);
  });
});
