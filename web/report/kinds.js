// What a triangle is, as the page shows it: its label, seen from behind, or the panel that it mirrors. Each kind has a
// colour, and a pattern for those who do not tell the colours apart (the tests hold the colours to that, too).

export const labels = ["back-facing", "out of view", "hidden", "visible"];
export const firstPanelKind = 5;

const seenFromBehind = 4;

// pattern: the number that the shader and the swatches know it by.
export const patterns = { plain: 0, stripes: 1, dots: 2, bars: 3, checks: 4 };

const labelKinds = [
  { id: "back-facing", name: "back-facing", colour: "#87857c", pattern: patterns.bars },
  { id: "out-of-view", name: "out of view", colour: "#e6e2d6", pattern: patterns.dots },
  { id: "hidden", name: "hidden", colour: "#741b1a", pattern: patterns.stripes },
  { id: "visible", name: "visible", colour: "#5aa9e6", pattern: patterns.plain },
  { id: "seen-from-behind", name: "seen from behind", colour: "#08af42", pattern: patterns.checks },
];

// Again from the first one where there are more panels.
export const panelColours = ["#ffd21f", "#75266c", "#ffffa9", "#1f028b"];

// The kinds of a scene with these panels, by number.
export function kindsOf(panelNames) {
  const panels = panelNames.map((name, number) => ({
    id: `panel-${number}`,
    name: `mirrors ${name}`,
    colour: panelColours[number % panelColours.length],
    pattern: 1 + (number % panelColours.length),
  }));
  return [...labelKinds, ...panels];
}

// state, low, high: of the triangle (cli/view_block.h); low and high are the halves of its panels. The first panel counts.
export function kindOf(state, low, high) {
  if (low !== 0) return firstPanelKind + 31 - Math.clz32(low & -low);
  if (high !== 0) return firstPanelKind + 63 - Math.clz32(high & -high);
  const label = state & 3;
  return (state & 4) !== 0 && label === 0 ? seenFromBehind : label;
}

export function channels(colour) {
  return [1, 3, 5].map((begin) => parseInt(colour.slice(begin, begin + 2), 16) / 255);
}
