#include "reconstruct/triangulation/constrained_delaunay.h"

#include <algorithm>
#include <utility>

#include "geometry/numbers/errors.h"
#include "reconstruct/triangulation/editable_triangulation.h"

namespace sightline::inline reconstruct {

namespace {

[[noreturn]] void reject(const char* cause, PlanarPointId p, PlanarPointId q) {
  throw ConstraintConflict("constrained_delaunay: constraint " + std::to_string(p.index()) + "-" +
                           std::to_string(q.index()) + " " + cause);
}

// The cavity is what a constraint crosses: the triangles, and their outer half-edges to the right of the constraint
// from its first to its second end, and to the left of it from its second to its first end.
struct Cavity {
  std::vector<TriangleId> triangles;
  std::vector<HalfEdgeId> right;
  std::vector<HalfEdgeId> left;
};

class Construction {
 public:
  explicit Construction(const PlanarPoints& points)
      : points_(points), mesh_(points.size()), hull_previous_(points.size()) {}

  void cover_hull();
  void insert(const Constraint& constraint);
  bool is_empty() const { return mesh_.triangle_count() == 0; }
  HalfEdgeTriangulation take() { return std::move(static_cast<HalfEdgeTriangulation&>(mesh_)); }

 private:
  Sign orient(PlanarPointId a, PlanarPointId b, PlanarPointId c) const { return points_.orient(a, b, c); }

  std::vector<PlanarPointId> leading_collinear() const;
  std::vector<PlanarPointId> visible_path(PlanarPointId apex) const;
  void fan(const std::vector<PlanarPointId>& path, PlanarPointId apex);

  HalfEdgeId entry(PlanarPointId p, PlanarPointId q) const;
  Cavity cavity(PlanarPointId p, PlanarPointId q) const;
  HalfEdgeId fill(const std::vector<HalfEdgeId>& chain);
  void clip_ear(std::vector<HalfEdgeId>& open, PlanarPointId tip);
  void force(PlanarPointId p, PlanarPointId q);

  void suspect(TriangleId t);
  void improve();

  const PlanarPoints& points_;
  EditableTriangulation mesh_;
  std::vector<PlanarPointId> hull_previous_;  // per hull vertex while the hull grows: the one before it, clockwise
  std::vector<HalfEdgeId> suspects_;          // edges that a flip may improve
};

void Construction::cover_hull() {
  const std::vector<PlanarPointId> line = leading_collinear();
  for (std::size_t i = 1; i < line.size(); ++i) hull_previous_[line[i].index()] = line[i - 1];
  if (line.size() == points_.size()) return;
  fan(line, PlanarPointId(line.size()));
  for (std::size_t i = line.size() + 1; i < points_.size(); ++i) fan(visible_path(PlanarPointId(i)), PlanarPointId(i));
}

// Returns the first points, as long as they are collinear, in the direction that has the next point on its left.
std::vector<PlanarPointId> Construction::leading_collinear() const {
  std::vector<PlanarPointId> line;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Sign side = i < 2 ? 0 : orient(PlanarPointId(0), PlanarPointId(1), PlanarPointId(i));
    if (side < 0) std::reverse(line.begin(), line.end());
    if (side != 0) break;
    line.push_back(PlanarPointId(i));
  }
  return line;
}

// Returns the hull vertices joined by the edges that `apex` sees, in the direction that has `apex` on its left.
std::vector<PlanarPointId> Construction::visible_path(PlanarPointId apex) const {
  const auto following = [&](PlanarPointId v) { return mesh_.to(mesh_.outgoing[v.index()]); };
  const auto preceding = [&](PlanarPointId v) { return hull_previous_[v.index()]; };
  PlanarPointId v(apex.index() - 1);
  while (orient(v, following(v), apex) < 0) v = following(v);
  std::vector<PlanarPointId> path{v};
  for (; orient(preceding(v), v, apex) < 0; v = preceding(v)) path.push_back(preceding(v));
  return path;
}

// Joins `apex` to each edge of the path, which is on the hull and has `apex` on its left.
void Construction::fan(const std::vector<PlanarPointId>& path, PlanarPointId apex) {
  HalfEdgeId open;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const TriangleId t = mesh_.add_triangle(path[i - 1], path[i], apex);
    const HalfEdgeId base = half_edge(t, 0);
    const HalfEdgeId behind = mesh_.outgoing[path[i].index()];
    mesh_.link(base, behind);
    if (!behind.valid()) mesh_.outgoing[path[i - 1].index()] = base;
    mesh_.link(half_edge(t, 2), open);
    if (!open.valid()) mesh_.outgoing[apex.index()] = half_edge(t, 2);
    open = half_edge(t, 1);
    suspect(t);
  }
  mesh_.outgoing[path.back().index()] = open;
  hull_previous_[apex.index()] = path.back();
  hull_previous_[path.front().index()] = apex;
  improve();
}

void Construction::insert(const Constraint& constraint) {
  const auto [p, q] = constraint;
  if (!mesh_.edge_between(p, q).valid()) force(p, q);
  mesh_.constrain(mesh_.edge_between(p, q));
  improve();
}

// Returns the half-edge through which the segment pq leaves the first triangle that it crosses.
HalfEdgeId Construction::entry(PlanarPointId p, PlanarPointId q) const {
  const HalfEdgeId h = mesh_.find_outgoing(
      p, [&](HalfEdgeId g) { return orient(p, mesh_.to(g), q) > 0 && orient(p, mesh_.apex(g), q) < 0; });
  if (!h.valid()) reject("runs through a point", p, q);
  return next(h);
}

Cavity Construction::cavity(PlanarPointId p, PlanarPointId q) const {
  HalfEdgeId crossed = entry(p, q);
  Cavity result{{triangle_of(crossed)}, {previous(crossed)}, {next(crossed)}};
  for (PlanarPointId apex = p; apex != q;) {
    if (mesh_.is_constrained(crossed)) reject("crosses a constraint", p, q);
    const HalfEdgeId across = mesh_.twin_of(crossed);
    apex = mesh_.apex(across);
    const Sign side = apex == q ? 0 : orient(p, q, apex);
    if (side == 0 && apex != q) reject("runs through a point", p, q);
    result.triangles.push_back(triangle_of(across));
    if (side <= 0) result.right.push_back(next(across));
    if (side >= 0) result.left.push_back(previous(across));
    crossed = side < 0 ? previous(across) : next(across);
  }
  std::reverse(result.left.begin(), result.left.end());
  return result;
}

// Triangulates the polygon between the chain and the straight line from its end to its start, which every vertex of the
// chain sees. Returns the half-edge on that line. The chain may visit an edge twice, once in each direction: then the
// half-edges of the chain are each other's twins, and replacing one after the other joins the triangles that are new.
HalfEdgeId Construction::fill(const std::vector<HalfEdgeId>& chain) {
  std::vector<HalfEdgeId> open;
  for (const HalfEdgeId h : chain) {
    const PlanarPointId tip = mesh_.to(h);
    open.push_back(h);
    while (open.size() > 1 && orient(mesh_.from(open[open.size() - 2]), mesh_.from(open.back()), tip) > 0) {
      clip_ear(open, tip);
    }
  }
  return mesh_.twin_of(open.front());
}

// Cuts off the triangle of the last two open half-edges. The first of them, no longer in use, then stands for the edge
// that remains to be covered.
void Construction::clip_ear(std::vector<HalfEdgeId>& open, PlanarPointId tip) {
  const HalfEdgeId last = open.back();
  open.pop_back();
  const TriangleId t = mesh_.add_triangle(mesh_.from(open.back()), mesh_.from(last), tip);
  mesh_.replace(open.back(), half_edge(t, 0));
  mesh_.replace(last, half_edge(t, 1));
  mesh_.link(open.back(), half_edge(t, 2));
  mesh_.constrained[open.back().index()] = 0;
}

// Makes pq, which is no edge yet, an edge.
void Construction::force(PlanarPointId p, PlanarPointId q) {
  const Cavity crossed = cavity(p, q);
  const HalfEdgeId right = fill(crossed.right);
  const HalfEdgeId left = fill(crossed.left);
  mesh_.link(right, left);
  mesh_.move_last(crossed.triangles);
  for (const TriangleId t : crossed.triangles) suspect(t);
}

void Construction::suspect(TriangleId t) {
  for (std::size_t side = 0; side < 3; ++side) suspects_.push_back(half_edge(t, side));
}

void Construction::improve() {
  std::size_t flips_left = points_.size() * (points_.size() - 1) / 2;
  while (!suspects_.empty()) {
    const HalfEdgeId h = suspects_.back();
    suspects_.pop_back();
    if (flips_left == 0 || !is_improvable(mesh_, points_, h)) continue;
    --flips_left;
    const HalfEdgeId g = mesh_.twin_of(h);
    mesh_.flip(h);
    suspects_.insert(suspects_.end(), {h, next(h), g, next(g)});
  }
}

}  // namespace

bool is_improvable(const HalfEdgeTriangulation& triangulation, const PlanarPoints& points, HalfEdgeId h) {
  const HalfEdgeId g = triangulation.twin_of(h);
  if (!g.valid() || triangulation.is_constrained(h)) return false;
  const PlanarPointId a = triangulation.from(h);
  const PlanarPointId b = triangulation.apex(g);
  const PlanarPointId c = triangulation.to(h);
  const PlanarPointId d = triangulation.apex(h);
  return points.flip_improves(a, b, c, d) && points.orient(b, c, d) > 0 && points.orient(d, a, b) > 0;
}

HalfEdgeTriangulation constrained_delaunay(const PlanarPoints& points, std::span<const Constraint> constraints) {
  Construction construction(points);
  construction.cover_hull();
  if (construction.is_empty()) return {};
  for (const Constraint& constraint : constraints) construction.insert(constraint);
  return construction.take();
}

}  // namespace sightline::inline reconstruct
