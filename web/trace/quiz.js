// "What next?": the next step stays hidden until the viewer has picked its point among those that wait.
import { byId, element } from "./dom.js";

const mostCandidates = 4;

// In an order that tells nothing.
export function candidatesAt(sweep, step) {
  return sweep.steps[step].queue.slice(0, mostCandidates)
    .map((place, i) => ({ place, name: sweep.placeName(place), isNext: i === 0 }))
    .sort((a, b) => (a.name < b.name ? -1 : a.name > b.name ? 1 : 0));
}

function whyNot(sweep, place, next) {
  const other = place.y < next.y ? "another point that waits is higher" : "another point of the same height is further left";
  return `Not ${sweep.placeName(place)}: ${other}. The sweep goes from top to bottom, and left to right.`;
}

function whyRight(sweep, step) {
  const next = sweep.steps[step + 1];
  const rival = sweep.steps[step].queue[1];
  if (!rival) return `Right: nothing but ${next.name} waits.`;
  const reason = rival.y < next.y ? "it is the highest point that waits" : "of those at this height it is the leftmost";
  return `Right: ${next.name} is next, since ${reason}.`;
}

// answered(step, text): to be called after the right answer.
export function showQuiz(sweep, step, answered) {
  const box = byId("quiz");
  const candidates = candidatesAt(sweep, step);
  box.hidden = false;
  if (candidates.length === 0) {
    box.replaceChildren(element("p", {}, "Nothing is left in the queue: the sweep is done."));
    return [];
  }
  const verdict = element("p", { class: "verdict", role: "status" });
  const pick = (candidate) => {
    if (candidate.isNext) answered(step + 1, whyRight(sweep, step));
    else verdict.textContent = whyNot(sweep, candidate.place, sweep.steps[step].queue[0]);
  };
  const buttons = candidates.map((candidate) => {
    const button = element("button", { type: "button" }, candidate.name);
    button.addEventListener("click", () => pick(candidate));
    return button;
  });
  box.replaceChildren(element("p", {}, "Which sweep point comes next?"), element("div", { class: "buttons" }, buttons), verdict);
  return candidates.map((candidate) => ({ ...candidate, pick: () => pick(candidate) }));
}
