// The colours of the labels are told apart by every eye; where there is one hue only, by brightness.
import assert from "node:assert/strict";
import { test } from "node:test";
import { channels, kindsOf, panelColours } from "../../web/report/kinds.js";
import { difference, eyes, seenBy } from "./colour_science.mjs";

const kinds = kindsOf(panelColours.map((_, number) => `panel ${number}`));

for (const [name, eye] of Object.entries(eyes)) {
  test(`labels and panels differ by 30 in L*a*b* to the eye: ${name}`, () => {
    kinds.forEach((a, i) => {
      for (const b of kinds.slice(0, i)) {
        const apart = difference(seenBy(eye, channels(a.colour)), seenBy(eye, channels(b.colour)));
        assert.ok(apart >= 30, `${a.id} and ${b.id}: ${apart.toFixed(1)}`);
      }
    });
  });
}

test("the simulation is one: red and green of one brightness are the same to the colour-blind, and blue and yellow are not", () => {
  const apart = (eye, a, b) => difference(seenBy(eyes[eye], channels(a)), seenBy(eyes[eye], channels(b)));
  assert.ok(apart("usual", "#b05050", "#508050") > 40);
  assert.ok(apart("deuteranopia", "#b05050", "#6f7a50") < 15);
  assert.ok(apart("deuteranopia", "#3050c0", "#c0b030") > 80);
});

test("kinds of labels have patterns of their own", () => {
  const patterns = kinds.slice(0, 5).map(({ pattern }) => pattern);
  assert.equal(new Set(patterns).size, 5);
});
