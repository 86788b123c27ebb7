// The checks of constrained_delaunay.h are here, one function each.
#include <algorithm>

#include "reconstruct/triangulation/constrained_delaunay.h"

namespace sightline::inline reconstruct {

namespace {

struct Check {
  const HalfEdgeTriangulation& mesh;
  const PlanarPoints& points;
  std::span<const Constraint> constraints;
  std::vector<std::string>& problems;

  template <class Tag>
  void report(const char* what, Id<Tag> id) const {
    problems.push_back(std::string(what) + " " + std::to_string(id.index()));
  }
  template <class Function>
  void for_each_half_edge(Function function) const {
    for (std::size_t i = 0; i < mesh.origin.size(); ++i) function(HalfEdgeId(i));
  }
};

Constraint undirected(PlanarPointId p, PlanarPointId q) { return {std::min(p, q), std::max(p, q)}; }

bool sizes_match(const Check& check) {
  const HalfEdgeTriangulation& mesh = check.mesh;
  bool good = mesh.origin.size() % 3 == 0 && mesh.twin.size() == mesh.origin.size() &&
              mesh.constrained.size() == mesh.origin.size();
  for (const PlanarPointId p : mesh.origin) good = good && p.index() < check.points.size();
  for (const HalfEdgeId h : mesh.twin) good = good && (!h.valid() || h.index() < mesh.twin.size());
  if (!good) check.problems.push_back("array sizes or indices out of range");
  return good;
}

void check_collinear(const Check& check) {
  for (std::size_t i = 2; i < check.points.size(); ++i) {
    const PlanarPointId p(i);
    if (check.points.orient(PlanarPointId(0), PlanarPointId(1), p) != 0)
      check.report("no triangles in spite of point", p);
  }
}

void check_orientation(const Check& check) {
  for (std::size_t t = 0; t < check.mesh.triangle_count(); ++t) {
    const auto [a, b, c] = check.mesh.corners(TriangleId(t));
    if (check.points.orient(a, b, c) <= 0) check.report("not counter-clockwise: triangle", TriangleId(t));
  }
}

void check_twins(const Check& check) {
  const HalfEdgeTriangulation& mesh = check.mesh;
  check.for_each_half_edge([&](HalfEdgeId h) {
    const HalfEdgeId g = mesh.twin_of(h);
    if (!g.valid()) return;
    if (mesh.twin_of(g) != h) check.report("twin not symmetric: half-edge", h);
    if (mesh.from(g) != mesh.to(h) || mesh.to(g) != mesh.from(h)) check.report("twin with other ends: half-edge", h);
    if (mesh.is_constrained(g) != mesh.is_constrained(h)) check.report("twin not constrained alike: half-edge", h);
  });
}

void check_corners(const Check& check) {
  std::vector<std::uint8_t> used(check.points.size());
  for (const PlanarPointId p : check.mesh.origin) used[p.index()] = 1;
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (used[i] == 0) check.report("no corner of a triangle: point", PlanarPointId(i));
  }
}

// Returns, per point, the one after it on the boundary; invalid inside.
std::vector<PlanarPointId> boundary(const Check& check) {
  std::vector<PlanarPointId> following(check.points.size());
  check.for_each_half_edge([&](HalfEdgeId h) {
    if (check.mesh.twin_of(h).valid()) return;
    PlanarPointId& after = following[check.mesh.from(h).index()];
    if (after.valid()) check.report("boundary branches at point", check.mesh.from(h));
    after = check.mesh.to(h);
  });
  return following;
}

// A closed polygon that turns left only, and whose numbers have one minimum, goes round once: the numbers are the order
// along one direction. Several such polygons have several minima.
void check_boundary(const Check& check) {
  const std::vector<PlanarPointId> following = boundary(check);
  std::size_t edges = 0;
  std::size_t minima = 0;
  for (std::size_t i = 0; i < following.size(); ++i) {
    const PlanarPointId v = following[i];
    if (!v.valid()) continue;
    ++edges;
    const PlanarPointId w = following[v.index()];
    if (!w.valid() || check.points.orient(PlanarPointId(i), v, w) < 0) check.report("boundary not convex at point", v);
    if (v < PlanarPointId(i) && v < w) ++minima;
  }
  if (minima != 1) check.problems.push_back("boundary is not one polygon that turns once");
  if (check.mesh.triangle_count() + 2 + edges != 2 * check.points.size()) {
    check.problems.push_back("the number of triangles does not fit the numbers of points and boundary edges");
  }
}

void check_constraints(const Check& check) {
  std::vector<Constraint> wanted;
  for (const auto& [p, q] : check.constraints) wanted.push_back(undirected(p, q));
  std::vector<Constraint> found;
  check.for_each_half_edge([&](HalfEdgeId h) {
    if (check.mesh.is_constrained(h)) found.push_back(undirected(check.mesh.from(h), check.mesh.to(h)));
  });
  for (std::vector<Constraint>* list : {&wanted, &found}) {
    std::sort(list->begin(), list->end());
    list->erase(std::unique(list->begin(), list->end()), list->end());
  }
  if (wanted != found) check.problems.push_back("the constrained edges are not the constraints");
}

void check_improved(const Check& check) {
  check.for_each_half_edge([&](HalfEdgeId h) {
    if (is_improvable(check.mesh, check.points, h)) check.report("can be improved: half-edge", h);
  });
}

}  // namespace

std::vector<std::string> validate(const HalfEdgeTriangulation& triangulation, const PlanarPoints& points,
                                  std::span<const Constraint> constraints) {
  std::vector<std::string> problems;
  const Check check{triangulation, points, constraints, problems};
  if (!sizes_match(check)) return problems;
  if (triangulation.triangle_count() == 0) {
    check_collinear(check);
    return problems;
  }
  check_orientation(check);
  check_twins(check);
  check_corners(check);
  check_boundary(check);
  check_constraints(check);
  check_improved(check);
  return problems;
}

}  // namespace sightline::inline reconstruct
