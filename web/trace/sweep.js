// A sweep of the log, with what can be looked up in it: names, the active edge list after each step, and the pieces of
// the image between two neighbours of that list.
//
// Steps are numbered from 1; step 0 is before the first sweep point.

const emptyStep = {
  kind: "start", name: "", says: "The sweep line is above everything. All vertices wait in the event queue; nothing is active yet.",
  y: Infinity, x: 0, vertex: null, crossings: [], ended: [], started: [], passed: [], closed: [], opened: [],
  vertices: [], appeared: [], vanished: [], rings: [], predicates: [],
  active: { position: 0, removed: 0, inserted: [] },
};

const isCapital = (name) => /^[A-Z]$/.test(name);

export class Sweep {
  constructor(log, aspect) {
    Object.assign(this, log);
    this.aspect = aspect;
    this.faceOfFacet = new Map(this.facets.map((facet) => [facet.facet, facet.face]));
    this.steps = [{ ...emptyStep, queue: this.firstVertices() }, ...log.steps];
    this.lists = [[]];
    for (const step of log.steps) this.lists.push(this.replaced(this.lists.at(-1), step.active));
    this.pieces = this.piecesOfImage();
  }

  get last() { return this.steps.length - 1; }

  firstVertices() {
    return this.points.slice(0, 8).map((point, i) => ({ vertex: i, x: point.x, y: point.y, crossings: [] }));
  }

  replaced(list, { position, removed, inserted }) {
    return [...list.slice(0, position), ...inserted, ...list.slice(position + removed)];
  }

  // Every span between two neighbours of the list, with its topmost face, from the step that made it to the one that
  // ended it.
  piecesOfImage() {
    const pieces = [];
    let open = [];
    for (let k = 1; k <= this.last; ++k) {
      const { position, removed, inserted } = this.steps[k].active;
      const begin = Math.max(position - 1, 0);
      const changed = open.slice(begin, position + removed);
      for (const piece of changed) if (piece) piece.to = k;
      const made = [];
      for (let i = begin; i < position + inserted.length; ++i) made.push(this.pieceRightOf(this.lists[k], i, k));
      open = [...open.slice(0, begin), ...made, ...open.slice(position + removed)];
      pieces.push(...made.filter((piece) => piece));
    }
    return pieces;
  }

  pieceRightOf(list, i, step) {
    if (i + 1 >= list.length || list[i].nodes.length === 0) return null;
    const face = this.faceOfFacet.get(list[i].nodes[0]);
    return { face, left: list[i].edges[0], right: list[i + 1].edges[0], from: step, to: Infinity };
  }

  pointName(id) { return this.points[id].name; }

  edgeName(id) {
    const [upper, lower] = [this.pointName(this.edges[id].upper), this.pointName(this.edges[id].lower)];
    return isCapital(upper) && isCapital(lower) ? upper + lower : `${upper}–${lower}`;
  }

  faceName(face) { return this.faces[face].name; }
  faceOfSurface(surface) { return this.faceOfFacet.get(surface); }

  placeName(place) {
    if (place.vertex !== null) return this.pointName(place.vertex);
    return place.crossings.map(([a, b]) => `${this.edgeName(a)} × ${this.edgeName(b)}`).join(", ");
  }

  // Surfaces that have got a segment up to the step, in the order in which they did.
  surfacesUntil(step) {
    const surfaces = new Set();
    for (const segment of this.segments) if (segment.opened <= step) surfaces.add(segment.surface);
    return [...surfaces];
  }

  verticesUntil(step, surface) {
    const names = [];
    for (let k = 1; k <= step; ++k) {
      for (const vertex of this.steps[k].vertices) if (vertex.surface === surface) names.push(vertex.name);
    }
    return names;
  }

  segmentsUntil(step, surface) {
    const numbers = [];
    this.segments.forEach((segment, i) => {
      if (segment.opened <= step && segment.surface === surface) numbers.push(i + 1);
    });
    return numbers;
  }

  ringsUntil(step) {
    return this.steps.slice(1, step + 1).flatMap((s) => s.rings).map((i) => this.rings[i]);
  }

  // Where an edge is at height y, in the window's units.
  xAt(edge, y) {
    const upper = this.points[this.edges[edge].upper];
    const lower = this.points[this.edges[edge].lower];
    if (upper.y === lower.y) return lower.x;
    return upper.x + ((upper.y - y) / (upper.y - lower.y)) * (lower.x - upper.x);
  }
}

// The first step at which two sweeps say different things; null where they do not.
export function firstDifference(a, b) {
  const said = (sweep, k) => {
    const step = sweep.steps[k];
    return step && JSON.stringify([step.kind, step.name, step.says,
      step.active.inserted.map((bundle) => bundle.nodes)]);
  };
  for (let k = 1; k <= Math.max(a.last, b.last); ++k) if (said(a, k) !== said(b, k)) return k;
  return null;
}
