// The panels beside the scene: event queue, active edge list, Fang's tables 5.2 and 5.4, closed rings.
import { byId, element } from "./dom.js";
import { edgeChip, faceChip, segmentChip, withFirstReachable } from "./linking.js";

const mostColumns = 3;
const mostRows = 60;
const mostSegments = 200;

const panelOf = (id) => byId(id).querySelector(".panel");

function show(id, ...content) {
  panelOf(id).replaceChildren(...content);
  withFirstReachable(panelOf(id));
}

// Within the panel: the page itself stays where it is.
function scrollTo(id, what) {
  const row = panelOf(id).querySelector(what);
  if (row) panelOf(id).scrollTop = row.offsetTop - panelOf(id).clientHeight / 2;
}

const spaced = (nodes) => nodes.flatMap((node, i) => (i === 0 ? [node] : [", ", node]));

const table = (heads, rows) =>
  element("table", {},
    element("thead", {}, element("tr", {}, heads.map((head) => element("th", { scope: "col" }, head)))),
    element("tbody", {}, rows));

const keysOfPlace = (place) => (place.vertex !== null ? `point-${place.vertex}` : "crossing-" + place.crossings[0].join("-"));

function queueItem(sweep, place) {
  const kind = place.vertex === null ? "crossing" : "vertex";
  return element("li", { class: "item", "data-keys": keysOfPlace(place) },
    element("b", {}, sweep.placeName(place)), " ", element("small", {}, kind));
}

export function showQueue(sweep, step, hidden) {
  if (hidden) return show("queue", element("li", { class: "none" }, "Not shown while you choose."));
  const queue = sweep.steps[step].queue;
  show("queue", ...(queue.length ? queue.map((place) => queueItem(sweep, place))
    : [element("li", { class: "none" }, "Empty: the sweep is done.")]));
}

function activeRow(sweep, bundle, fresh) {
  const faces = bundle.nodes.map((facet) => faceChip(sweep, sweep.faceOfFacet.get(facet)));
  const segments = [bundle.left_segment, bundle.right_segment].map((number) => (number ? segmentChip(number) : "–"));
  const keys = [...bundle.edges.map((edge) => `edge-${edge}`)].join(" ");
  return element("tr", { class: fresh ? "item fresh" : "item", "data-keys": keys },
    element("td", {}, spaced(bundle.edges.map((edge) => edgeChip(sweep, edge)))),
    element("td", {}, segments[0]), element("td", {}, segments[1]),
    element("td", {}, faces.length ? spaced(faces) : element("span", { class: "none" }, "nothing")));
}

export function showActive(sweep, step) {
  const { position, inserted } = sweep.steps[step].active;
  const rows = sweep.lists[step].map((bundle, i) =>
    activeRow(sweep, bundle, step > 0 && i >= position && i < position + inserted.length));
  show("active", rows.length ? table(["Edges", "Left", "Right", "Faces to the right, shallowest first"], rows)
    : element("p", { class: "none" }, "Empty."));
  scrollTo("active", ".fresh");
}

function cellsOf(sweep, step, surface) {
  return [element("td", { class: "names" }, sweep.verticesUntil(step, surface).join(", ")),
    element("td", {}, spaced(sweep.segmentsUntil(step, surface).map(segmentChip)))];
}

// Table 5.2: a row for each sweep point.
function progressiveTable(sweep, step, surfaces) {
  const heads = surfaces.map((surface) => element("th", { colspan: 2, scope: "colgroup" },
    faceChip(sweep, sweep.faceOfSurface(surface))));
  const kinds = surfaces.flatMap(() => ["2D vertices", "Segments"]).map((text) => element("th", { scope: "col" }, text));
  const rows = sweep.steps.slice(1, step + 1).map((s, i) =>
    element("tr", { class: i + 1 === step ? "item current" : "item", "data-keys": `step-${i + 1}` },
      element("th", { scope: "row" }, s.name), surfaces.flatMap((surface) => cellsOf(sweep, i + 1, surface))));
  return element("table", { class: "progressive" },
    element("thead", {}, element("tr", {}, element("th", { rowspan: 2, scope: "col" }, "Point"), heads),
      element("tr", {}, kinds)),
    element("tbody", {}, rows));
}

function tableByPolygon(sweep, step, surfaces) {
  return table(["Face", "2D vertices", "Segments"], surfaces.map((surface) => {
    const face = sweep.faceOfSurface(surface);
    return element("tr", { class: "item", "data-keys": `face-${face}` },
      element("td", {}, faceChip(sweep, face)), cellsOf(sweep, step, surface));
  }));
}

export function showPolygons(sweep, step) {
  const all = sweep.surfacesUntil(sweep.last);
  const surfaces = sweep.surfacesUntil(step);
  if (surfaces.length === 0) return show("polygons", element("p", { class: "none" }, "None yet."));
  const progressive = all.length <= mostColumns && sweep.last <= mostRows;
  show("polygons", progressive ? progressiveTable(sweep, step, all) : tableByPolygon(sweep, step, surfaces));
  scrollTo("polygons", ".current");
}

function segmentRow(sweep, number, step) {
  const segment = sweep.segments[number - 1];
  const closed = segment.closed !== null && segment.closed <= step;
  const end = (name, atLowerEnd) => (atLowerEnd && !closed ? "?" : name);
  const fresh = segment.opened === step || (closed && segment.closed === step);
  return element("tr", { class: fresh ? "item fresh" : "item", "data-keys": `segment-${number} edge-${segment.edge}` },
    element("th", { scope: "row" }, String(number)),
    element("td", {}, faceChip(sweep, sweep.faceOfSurface(segment.surface))),
    element("td", { class: "names" }, end(segment.start, segment.upwards)),
    element("td", { class: "names" }, end(segment.end, !segment.upwards)));
}

// Table 5.4.
export function showSegments(sweep, step) {
  const opened = sweep.segments.filter((segment) => segment.opened <= step).length;
  const first = Math.max(opened - mostSegments, 0);
  const rows = [];
  for (let number = first + 1; number <= opened; ++number) rows.push(segmentRow(sweep, number, step));
  const note = first > 0 ? [element("p", { class: "none" }, `The first ${first} are not listed.`)] : [];
  show("segments", ...note, rows.length ? table(["No.", "Face", "Start", "End"], rows)
    : element("p", { class: "none" }, "None yet."));
  scrollTo("segments", ".fresh:last-child");
}

function ringItem(sweep, ring, fresh) {
  const names = ring.segments.map((number) => sweep.segments[number - 1].start).join(" ");
  const keys = [`face-${sweep.faceOfSurface(ring.surface)}`, ...ring.segments.map((n) => `segment-${n}`)].join(" ");
  return element("li", { class: fresh ? "item fresh" : "item", "data-keys": keys },
    faceChip(sweep, sweep.faceOfSurface(ring.surface)), ring.hole ? " hole: " : " ring: ",
    element("span", { class: "names" }, names), " ", element("small", {}, "segments "),
    spaced(ring.segments.map(segmentChip)));
}

export function showRings(sweep, step) {
  const rings = sweep.ringsUntil(step);
  const fresh = sweep.steps[step].rings.length;
  show("rings", ...(rings.length ? rings.map((ring, i) => ringItem(sweep, ring, i >= rings.length - fresh))
    : [element("li", { class: "none" }, "None yet.")]));
}
