// The legend: a switch per kind that the surface has, with its colour, its pattern, and how many triangles are of it.
import { patterns } from "./kinds.js";
import { element } from "./tables.js";

// As the shader draws them, light on dark colours and dark on light ones.
function background({ colour, pattern }, isLight) {
  const mark = isLight ? "rgb(0 0 0 / 32%)" : "rgb(255 255 255 / 38%)";
  const images = {
    [patterns.stripes]: `repeating-linear-gradient(45deg, ${mark} 0 3px, transparent 3px 6px)`,
    [patterns.dots]: `radial-gradient(${mark} 30%, transparent 32%) 0 0 / 6px 6px`,
    [patterns.bars]: `repeating-linear-gradient(0deg, ${mark} 0 2px, transparent 2px 6px)`,
    [patterns.checks]: `repeating-conic-gradient(${mark} 0 25%, transparent 0 50%) 0 0 / 8px 8px`,
  };
  return pattern in images ? `${images[pattern]}, ${colour}` : colour;
}

function isLightColour(colour) {
  const [r, g, b] = [1, 3, 5].map((begin) => parseInt(colour.slice(begin, begin + 2), 16));
  return 0.3 * r + 0.59 * g + 0.11 * b > 115;
}

function entry(kind, number, count, onSwitch) {
  const label = element("label");
  const box = element("input", "", { type: "checkbox", "data-kind": kind.id });
  box.checked = true;
  box.addEventListener("change", () => onSwitch(number, box.checked));
  const swatch = element("span", "", { class: "swatch", "aria-hidden": "true" });
  swatch.style.background = background(kind, isLightColour(kind.colour));
  label.append(box, swatch, element("span", kind.name, { class: "kind" }));
  label.append(element("span", count.toLocaleString("en"), { class: "count" }));
  return label;
}

// triangleKinds: a kind per triangle. onSwitch(kind, isShown).
export function fillLegend(fieldset, kinds, triangleKinds, onSwitch) {
  const counts = new Uint32Array(kinds.length);
  for (const kind of triangleKinds) ++counts[kind];
  const entries = kinds.map((kind, number) => ({ kind, number })).filter(({ number }) => counts[number] > 0);
  const order = (number) => (number === 3 ? -1 : number >= 5 ? 0 : 1);
  entries.sort((a, b) => order(a.number) - order(b.number) || a.number - b.number);
  const title = fieldset.querySelector("legend");
  fieldset.replaceChildren(title, ...entries.map(({ kind, number }) => entry(kind, number, counts[number], onSwitch)));
}
