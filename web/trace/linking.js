// What is pointed at, or has the focus, in one view is lit in all of them.
//
// Elements carry keys ("edge-3 face-1"); the first one says what they are.
import { element } from "./dom.js";

export const keysOfEdge = (edge) => `edge-${edge}`;

// A name of a face with its colour and, for those who do not see colours, itself.
export function faceChip(sweep, face) {
  return element("span", { class: `chip face-${face % 8}`, "data-keys": `face-${face}` }, sweep.faceName(face));
}

export function edgeChip(sweep, edge) {
  return element("span", { class: "edge", "data-keys": keysOfEdge(edge) }, sweep.edgeName(edge));
}

export function segmentChip(number) {
  return element("span", { class: "segment", "data-keys": `segment-${number}` }, String(number));
}

function light(key) {
  for (const lit of document.querySelectorAll(".lit")) lit.classList.remove("lit");
  if (!key) return;
  for (const found of document.querySelectorAll(`[data-keys~="${key}"]`)) found.classList.add("lit");
}

const keyOf = (target) => target.closest?.("[data-keys]")?.getAttribute("data-keys").split(" ")[0];

// In a panel one item can be reached by tab, the others by the arrows up and down.
function moveInPanel(event) {
  const item = event.target.closest(".item");
  if (!item || (event.key !== "ArrowUp" && event.key !== "ArrowDown")) return;
  const items = [...item.closest(".panel").querySelectorAll(".item")];
  const next = items[items.indexOf(item) + (event.key === "ArrowDown" ? 1 : -1)];
  event.preventDefault();
  if (!next) return;
  item.tabIndex = -1;
  next.tabIndex = 0;
  next.focus();
}

export function linkViews() {
  document.addEventListener("pointerover", (event) => light(keyOf(event.target)));
  document.addEventListener("focusin", (event) => light(keyOf(event.target)));
  document.addEventListener("focusout", () => light(null));
  document.addEventListener("keydown", moveInPanel);
}

export function withFirstReachable(panel) {
  panel.querySelectorAll(".item").forEach((item, i) => (item.tabIndex = i === 0 ? 0 : -1));
}
