// A sweep to be stepped through. The state: which sweep is shown, at which step, and how far a viewer who guesses has come.
import { jsonBlock } from "../shared/page_data.js";
import { byId, element } from "./dom.js";
import { linkViews } from "./linking.js";
import { showQuiz } from "./quiz.js";
import { showScene } from "./scene_view.js";
import { showStep } from "./step_text.js";
import { firstDifference, Sweep } from "./sweep.js";
import { showActive, showPolygons, showQueue, showRings, showSegments } from "./tables.js";

const state = { sweeps: [], shown: 0, step: 0, quiz: false, reached: 0, timer: null };
const sweep = () => state.sweeps[state.shown];
const other = () => (state.sweeps.length < 2 ? null : state.sweeps[1 - state.shown]);
const farthest = () => (state.quiz ? Math.min(state.reached, sweep().last) : sweep().last);

function showControls() {
  byId("slider").max = sweep().last;
  byId("slider").value = state.step;
  byId("slider").setAttribute("aria-valuetext", `step ${state.step} of ${sweep().last}`);
  byId("place").textContent = `Step ${state.step} of ${sweep().last}`;
  for (const id of ["first", "back"]) byId(id).disabled = state.step === 0;
  for (const id of ["forward", "last"]) byId(id).disabled = state.step >= farthest();
  byId("play").disabled = state.quiz;
  byId("play").textContent = state.timer === null ? "Play" : "Pause";
}

function showDifference() {
  if (state.sweeps.length < 2) return;
  const [a, b] = state.sweeps;
  const step = firstDifference(a, b);
  byId("difference").hidden = false;
  if (step === null) {
    byId("difference").replaceChildren(`${a.arithmetic} and ${b.arithmetic} say the same at every step.`);
    return;
  }
  const link = element("a", { href: `#step=${step}` }, `step ${step}`);
  const beside = state.step < step ? [] : [element("p", { class: "says" }, element("b", {}, other().arithmetic),
    ` at step ${state.step}: ${other().steps[state.step]?.says ?? "the sweep has ended."}`)];
  byId("difference").replaceChildren(element("p", {}, `${a.arithmetic} and ${b.arithmetic} first differ at `, link, "."), ...beside);
}

function showAll() {
  const guesses = state.quiz && state.step === state.reached;
  byId("quiz").hidden = true;
  const candidates = guesses ? showQuiz(sweep(), state.step, answered) : [];
  showControls();
  showDifference();
  showScene(sweep(), state.step, candidates, other());
  showStep(sweep(), state.step);
  showQueue(sweep(), state.step, guesses);
  for (const show of [showActive, showPolygons, showSegments, showRings]) show(sweep(), state.step);
}

function go(step) {
  state.step = Math.max(0, Math.min(step, farthest()));
  history.replaceState(null, "", `#step=${state.step}`);
  showAll();
}

function answered(step, why) {
  state.reached = step;
  go(step);
  byId("quiz").prepend(element("p", { class: "verdict right", role: "status" }, why));
  byId("quiz").querySelector("button")?.focus();
}

function stop() {
  clearInterval(state.timer);
  state.timer = null;
}

function play() {
  if (state.timer !== null) stop();
  else {
    if (state.step >= farthest()) state.step = 0;
    state.timer = setInterval(() => {
      if (state.step >= farthest()) stop();
      go(state.step + 1);
    }, Number(byId("pace").value));
  }
  showControls();
}

// Keys that a control uses itself are left to it.
function isForControl(event) {
  if (event.altKey || event.ctrlKey || event.metaKey) return true;
  const tag = event.target.tagName;
  if (tag === "SELECT" || (tag === "INPUT" && event.target.type !== "checkbox")) return true;
  return event.key === " " && ["BUTTON", "SUMMARY", "INPUT", "A"].includes(tag);
}

function onKey(event) {
  if (isForControl(event)) return;
  const steps = { ArrowRight: () => go(state.step + 1), ArrowLeft: () => go(state.step - 1), Home: () => go(0),
    End: () => go(farthest()), " ": () => !state.quiz && play() };
  if (!steps[event.key]) return;
  event.preventDefault();
  if (event.key !== " ") stop();
  steps[event.key]();
}

function stepOfLink() {
  const found = /^#step=(\d+)$/.exec(location.hash);
  return found ? Number(found[1]) : null;
}

function setQuiz(on) {
  stop();
  state.quiz = on;
  state.reached = state.step;
  showAll();
}

function offerSweeps() {
  if (state.sweeps.length < 2) return;
  byId("sweeps").hidden = false;
  state.sweeps.forEach((s, i) => {
    const choice = element("input", { type: "radio", name: "sweep", checked: i === 0 });
    choice.addEventListener("change", () => { state.shown = i; go(state.step); });
    byId("sweeps").append(element("label", {}, choice, ` ${s.arithmetic}`));
  });
}

function connect() {
  const moves = { first: () => go(0), back: () => go(state.step - 1), forward: () => go(state.step + 1), last: () => go(farthest()) };
  for (const [id, move] of Object.entries(moves)) byId(id).addEventListener("click", () => { stop(); move(); });
  byId("play").addEventListener("click", play);
  byId("pace").addEventListener("change", () => { if (state.timer !== null) { stop(); play(); } });
  byId("slider").addEventListener("input", () => { stop(); go(Number(byId("slider").value)); });
  byId("quiz-mode").addEventListener("change", (event) => setQuiz(event.target.checked));
  document.addEventListener("keydown", onKey);
  window.addEventListener("hashchange", () => go(stepOfLink() ?? state.step));
  linkViews();
}

function begin(log) {
  document.title = `${log.title} – sightline trace`;
  byId("title").textContent = log.title;
  byId("what").textContent = log.what || `The sweep of camera ${log.camera}.`;
  state.sweeps = log.sweeps.map((s) => new Sweep(s, log.aspect));
  offerSweeps();
  connect();
  go(stepOfLink() ?? 0);
}

jsonBlock(0).then(begin);
