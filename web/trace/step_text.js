// What happened at the step and why, in words, and the predicates behind it.
import { byId, element } from "./dom.js";

const decidedBy = {
  integers: "integers, exact: the numbers are small enough",
  filter: "the filter: double, with a proven error bound",
  exact: "exact arithmetic: the filter could not decide",
  ranges: "ranges of depth that do not overlap",
  rule: "a rule, without arithmetic",
  float: "float, unfiltered",
  double: "double, unfiltered",
};

const units = { side: "grid units", direction: "grid units", order: "the window's units", depth: "input units" };

const signed = (sign) => (sign > 0 ? "+" : sign < 0 ? "−" : "0");

function operandRow(operand) {
  return element("tr", {}, element("th", { scope: "row" }, operand.name),
    operand.at.map((value) => element("td", {}, String(value))));
}

function predicateItem(predicate) {
  const wrong = predicate.exact_sign === null ? [] : [element("p", { class: "wrong" },
    `Exact arithmetic says ${signed(predicate.exact_sign)}: the sweep went by a wrong sign.`)];
  const operands = predicate.operands.length
    ? [element("table", { class: "operands" }, element("caption", {}, `${predicate.formula}, ${units[predicate.question]}`),
      element("tbody", {}, predicate.operands.map(operandRow)))] : [];
  return element("li", { class: predicate.exact_sign === null ? "" : "is-wrong" },
    element("b", {}, predicate.question), ` ${predicate.says}. Sign `, element("b", {}, signed(predicate.sign)),
    `, decided by ${decidedBy[predicate.decided_by]}.`, ...wrong, ...operands);
}

function showPredicates(step) {
  byId("predicates").hidden = step.predicates.length === 0;
  byId("predicates").querySelector("summary").textContent = `The predicates behind it (${step.predicates.length})`;
  byId("predicates").querySelector("ol").replaceChildren(...step.predicates.map(predicateItem));
}

const kindNames = { start: "before the sweep", top: "top vertex", side: "side vertex", bottom: "bottom vertex", crossing: "crossing" };

export function showStep(sweep, number) {
  const step = sweep.steps[number];
  const ended = number === sweep.last && sweep.broken
    ? [element("p", { class: "wrong" }, `Here the sweep ended early, in ${sweep.arithmetic} arithmetic: ${sweep.broken}.`)] : [];
  byId("sentence").replaceChildren(
    element("p", { class: "headline" }, element("b", {}, step.name || "Start"), " ", element("small", {}, kindNames[step.kind])),
    element("p", {}, step.says), ...ended);
  showPredicates(step);
}
