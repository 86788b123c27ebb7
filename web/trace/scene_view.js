// The drawing: what is decided above the sweep line, the edges, the visible segments so far, and the points.
import { byId, drawn, element } from "./dom.js";

const size = 1000;
const mostNames = 60;
const offset = 5; // of a segment, to the side of its face

// From the window's units to the drawing's: what is in view, with a margin.
function viewOf(sweep) {
  const xs = sweep.points.map((p) => p.x * sweep.aspect);
  const ys = sweep.points.map((p) => p.y);
  const span = (values) => (values.length ? [Math.min(...values), Math.max(...values)] : [-1, 1]);
  const [left, right] = span(xs);
  const [low, high] = span(ys);
  const width = Math.max(right - left, (high - low) * 0.6, 1e-300);
  const height = Math.max(high - low, width * 0.6);
  const scale = size / (1.16 * width);
  return {
    width: size,
    height: height * 1.16 * scale,
    x: (x) => (x * sweep.aspect - (left + right) / 2) * scale + size / 2,
    y: (y) => ((low + high) / 2 - y) * scale + height * 0.58 * scale,
  };
}

const at = (view, x, y) => `${view.x(x).toFixed(2)} ${view.y(y).toFixed(2)}`;

function pathOfPiece(sweep, view, piece, step) {
  const top = sweep.steps[piece.from].y;
  const bottom = sweep.steps[Math.min(piece.to, step)].y;
  if (!(top > bottom)) return "";
  const corner = (edge, y) => at(view, sweep.xAt(edge, y), y);
  return `M${corner(piece.left, top)}L${corner(piece.right, top)}L${corner(piece.right, bottom)}L${corner(piece.left, bottom)}Z`;
}

function decidedRegions(sweep, view, step) {
  const paths = new Map();
  for (const piece of sweep.pieces) {
    if (piece.from > step) break;
    paths.set(piece.face, (paths.get(piece.face) ?? "") + pathOfPiece(sweep, view, piece, step));
  }
  return [...paths].sort(([a], [b]) => a - b).filter(([, path]) => path)
    .map(([face, d]) => drawn("path", { d, class: `region face-${face % 8}`, "data-keys": `face-${face}` }));
}

function straight(view, p, q, properties) {
  return drawn("line", { x1: view.x(p.x), y1: view.y(p.y), x2: view.x(q.x), y2: view.y(q.y), ...properties });
}

// Above the sweep line, where no visible segment covers it, an edge is hidden; below it waits.
function edgeLine(sweep, view, id, step, state) {
  const [p, q] = [sweep.points[sweep.edges[id].upper], sweep.points[sweep.edges[id].lower]];
  const drawnAs = (name) => ({ class: `edge-line ${name}`, "data-keys": `edge-${id}` });
  if (state !== "active") return [straight(view, p, q, drawnAs(state))];
  const y = sweep.steps[step].y;
  const here = { x: sweep.xAt(id, y), y };
  return [straight(view, p, here, drawnAs("swept")), straight(view, here, q, drawnAs("active"))];
}

function edgeLines(sweep, view, step) {
  const active = new Set(sweep.lists[step].flatMap((bundle) => bundle.edges));
  const ended = new Set(sweep.steps.slice(1, step + 1).flatMap((s) => s.ended));
  return sweep.edges.flatMap((_, id) =>
    edgeLine(sweep, view, id, step, active.has(id) ? "active" : ended.has(id) ? "swept" : "waiting"));
}

// From its start to its end, or, while it is open, to the sweep line.
function endsOfSegment(sweep, view, segment, step) {
  const closed = segment.closed !== null && segment.closed <= step;
  const [upper, lower] = [sweep.steps[segment.opened], sweep.steps[closed ? segment.closed : step]];
  const lowerX = closed ? lower.x : sweep.xAt(segment.edge, lower.y);
  const ends = [{ x: view.x(upper.x), y: view.y(upper.y) }, { x: view.x(lowerX), y: view.y(lower.y) }];
  return segment.upwards ? ends.reverse() : ends;
}

// Beside its edge, on the side of its face: that is on its left.
function segmentLine(sweep, view, number, step, numbered) {
  const segment = sweep.segments[number - 1];
  const [start, end] = endsOfSegment(sweep, view, segment, step);
  const length = Math.hypot(end.x - start.x, end.y - start.y);
  if (length < 1e-9) return [];
  const left = { x: (end.y - start.y) / length, y: -(end.x - start.x) / length };
  const face = sweep.faceOfSurface(segment.surface);
  const keys = { "data-keys": `segment-${number} edge-${segment.edge} face-${face}` };
  const line = drawn("line", { x1: start.x + left.x * offset, y1: start.y + left.y * offset, x2: end.x + left.x * offset,
    y2: end.y + left.y * offset, class: `segment-line face-${face % 8}`, "marker-end": "url(#arrow)", ...keys });
  if (!numbered || length < 50) return [line];
  const label = drawn("text", { x: (start.x + end.x) / 2 + left.x * 22, y: (start.y + end.y) / 2 + left.y * 22 + 7,
    class: `segment-number face-${face % 8}`, ...keys }, String(number));
  return [line, label];
}

function segmentLines(sweep, view, step) {
  const numbered = sweep.segments.length <= mostNames;
  return sweep.segments.flatMap((segment, i) =>
    segment.opened <= step ? segmentLine(sweep, view, i + 1, step, numbered) : []);
}

// Where a name does not cover what meets at the point: away from the middle of the scene.
function nameBeside(view, x, y, name, properties) {
  const away = [view.x(x) - view.width / 2, view.y(y) - view.height / 2];
  const length = Math.hypot(...away) || 1;
  return drawn("text", { x: view.x(x) + (away[0] / length) * 30, y: view.y(y) + (away[1] / length) * 30 + 11,
    class: "point-name", ...properties }, name);
}

function waitingPoints(sweep, view, step) {
  const named = sweep.points.length <= mostNames;
  const seen = new Set(sweep.steps.slice(1, step + 1).map((s) => s.vertex));
  return sweep.points.flatMap((p, i) => {
    if (seen.has(i)) return [];
    const dot = drawn("circle", { cx: view.x(p.x), cy: view.y(p.y), r: 6, class: "point waiting", "data-keys": `point-${i}` });
    return named ? [dot, nameBeside(view, p.x, p.y, p.name, { "data-keys": `point-${i}` })] : [dot];
  });
}

function passedPoints(sweep, view, step) {
  const named = sweep.last <= mostNames;
  return sweep.steps.slice(1, step + 1).flatMap((s, i) => {
    const keys = `step-${i + 1}${s.vertex === null ? "" : ` point-${s.vertex}`}`;
    const now = i + 1 === step;
    const dot = drawn("circle", { cx: view.x(s.x), cy: view.y(s.y), r: now ? 11 : 7,
      class: now ? "point now" : "point", "data-keys": keys });
    return named || now ? [dot, nameBeside(view, s.x, s.y, s.name, { "data-keys": keys })] : [dot];
  });
}

function sweepLine(sweep, view, step) {
  if (step === 0) return [];
  const y = view.y(sweep.steps[step].y);
  return [drawn("rect", { x: 0, y, width: view.width, height: Math.max(view.height - y, 0), class: "below" }),
    drawn("line", { x1: 0, y1: y, x2: view.width, y2: y, class: "sweep-line" })];
}

function faceLabels(sweep, view) {
  if (sweep.facets.length > 12) return [];
  const widest = new Map();
  for (const facet of sweep.facets) {
    if (!widest.has(facet.face)) widest.set(facet.face, facet.outline.map((p) => sweep.points[p]));
  }
  return [...widest].map(([face, outline]) => drawn("text", {
    x: view.x(outline.reduce((sum, p) => sum + p.x, 0) / outline.length),
    y: view.y(outline.reduce((sum, p) => sum + p.y, 0) / outline.length) + 9,
    class: "face-name", "data-keys": `face-${face}`,
  }, sweep.faceName(face)));
}

const arrow = () => drawn("defs", {}, drawn("marker", { id: "arrow", viewBox: "0 0 10 10", refX: 8, refY: 5,
  markerWidth: 4.5, markerHeight: 4.5, orient: "auto-start-reverse" }, drawn("path", { d: "M0 1L9 5L0 9Z" })));

function candidateRings(view, candidates) {
  return candidates.map(({ place, name, pick }) => {
    const ring = drawn("circle", { cx: view.x(place.x), cy: view.y(place.y), r: 22, class: "candidate" },
      drawn("title", {}, name));
    ring.addEventListener("click", pick);
    return ring;
  });
}

function drawing(sweep, step, candidates) {
  const view = viewOf(sweep);
  const label = step === 0 ? "The scene before the sweep" : `The scene at step ${step}, sweep point ${sweep.steps[step].name}`;
  return drawn("svg", { viewBox: `0 0 ${view.width} ${view.height.toFixed(1)}`, role: "img", "aria-label": label },
    ...decidedRegions(sweep, view, step), ...edgeLines(sweep, view, step), ...sweepLine(sweep, view, step),
    ...segmentLines(sweep, view, step), ...faceLabels(sweep, view), ...waitingPoints(sweep, view, step),
    ...passedPoints(sweep, view, step), ...candidateRings(view, candidates));
}

// Its points and edges have other numbers: nothing in it is linked with the other views.
function drawingBeside(sweep, step) {
  const svg = drawing(sweep, step, []);
  for (const linked of svg.querySelectorAll("[data-keys]")) linked.removeAttribute("data-keys");
  return svg;
}

function figure(caption, svg) {
  return element("figure", {}, element("figcaption", {}, caption), svg);
}

// beside: the sweep in the other arithmetic, at the same step or where it ended; null where there is one sweep only.
export function showScene(sweep, step, candidates, beside) {
  const svg = drawing(sweep, step, candidates);
  svg.prepend(arrow());
  if (beside === null) return byId("drawing").replaceChildren(svg);
  const last = Math.min(step, beside.last);
  const ended = last < step ? `, which ended at step ${last}` : "";
  return byId("drawing").replaceChildren(figure(sweep.arithmetic, svg),
    figure(`${beside.arithmetic}${ended}`, drawingBeside(beside, last)));
}
