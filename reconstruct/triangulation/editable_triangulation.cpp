#include "reconstruct/triangulation/editable_triangulation.h"

namespace sightline::inline reconstruct {

TriangleId EditableTriangulation::add_triangle(PlanarPointId a, PlanarPointId b, PlanarPointId c) {
  const TriangleId t(triangle_count());
  origin.insert(origin.end(), {a, b, c});
  twin.resize(origin.size());
  constrained.resize(origin.size());
  return t;
}

void EditableTriangulation::link(HalfEdgeId g, HalfEdgeId h) {
  twin[g.index()] = h;
  if (h.valid()) twin[h.index()] = g;
}

void EditableTriangulation::replace(HalfEdgeId old, HalfEdgeId by) {
  link(by, twin_of(old));
  constrained[by.index()] = constrained[old.index()];
  HalfEdgeId& known = outgoing[from(by).index()];
  if (known == old) known = by;
}

void EditableTriangulation::flip(HalfEdgeId h) {
  const HalfEdgeId g = twin_of(h);
  HalfEdgeId& from_a = outgoing[from(h).index()];
  HalfEdgeId& from_c = outgoing[from(g).index()];
  if (from_a == h) from_a = next(g);
  if (from_c == g) from_c = next(h);
  origin[h.index()] = apex(g);
  origin[g.index()] = apex(h);
  replace(previous(g), h);
  replace(previous(h), g);
  link(previous(g), previous(h));
  constrained[previous(g).index()] = constrained[previous(h).index()] = 0;
}

void EditableTriangulation::move_last(const std::vector<TriangleId>& slots) {
  const std::size_t kept = triangle_count() - slots.size();
  for (std::size_t i = 0; i < 3 * slots.size(); ++i) {
    const HalfEdgeId old(3 * kept + i);
    const HalfEdgeId by = half_edge(slots[i / 3], i % 3);
    origin[by.index()] = from(old);
    replace(old, by);
  }
  origin.resize(3 * kept);
  twin.resize(3 * kept);
  constrained.resize(3 * kept);
  // A half-edge inside the former triangles may have been the outgoing one. (On the hull none was: replace kept it.)
  for (std::size_t i = 0; i < 3 * slots.size(); ++i) {
    const HalfEdgeId h = half_edge(slots[i / 3], i % 3);
    HalfEdgeId& known = outgoing[from(h).index()];
    if (from(known) != from(h)) known = h;
  }
}

void EditableTriangulation::constrain(HalfEdgeId h) {
  constrained[h.index()] = 1;
  if (twin_of(h).valid()) constrained[twin_of(h).index()] = 1;
}

HalfEdgeId EditableTriangulation::edge_between(PlanarPointId p, PlanarPointId q) const {
  const HalfEdgeId h = find_outgoing(p, [&](HalfEdgeId g) { return to(g) == q || apex(g) == q; });
  if (!h.valid()) return h;
  if (to(h) == q) return h;
  return twin_of(previous(h)).valid() ? twin_of(previous(h)) : previous(h);
}

}  // namespace sightline::inline reconstruct
