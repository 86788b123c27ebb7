#include "sweep/segments/seen_in_space.h"

#include "geometry/mesh/facet_plane.h"

namespace sightline::inline sweep {

SeenInSpace::SeenInSpace(const ProjectedScene& scene, const std::vector<SwapEdge>& swap_edges)
    : scene_(scene), swap_edges_(swap_edges) {
  const Camera& camera = scene.camera;
  eye_ = has_perspective() ? in_words(camera.origin) : cross(in_words(camera.right), in_words(camera.up));
}

SeenInSpace::Plane SeenInSpace::plane_of(FacetId facet) const {
  return plane_through(plane_corners(scene_.mesh(), facet));
}

SeenInSpace::Plane SeenInSpace::plane_through(const std::array<VertexId, 3>& corners) const {
  const auto position = [&](std::size_t i) { return in_words(scene_.mesh().position(corners[i])); };
  const DoubleWordVector first = position(0);
  const DoubleWordVector to_second = position(1) - first;
  const DoubleWordVector to_third = position(2) - first;
  return {cross(to_second, to_third), first, 0};
}

std::optional<SeenInSpace::Plane> SeenInSpace::plane_through_eye(EdgeId e) const {
  if (e.index() >= scene_.edge_count()) return plane_of_swap(swap_edges_[e.index() - scene_.edge_count()]);
  const auto ends = ends_of(e);
  if (!ends) return std::nullopt;
  const DoubleWordVector first = in_words((*ends)[0]);
  const DoubleWordVector along = in_words((*ends)[1]) - first;
  return Plane{cross(direction_to(first), along), first, 0};
}

// With F and G the forms of both planes, and their values at the eye, F(P) G(eye) - G(P) F(eye) is zero there and where they
// meet.
SeenInSpace::Plane SeenInSpace::plane_of_swap(const SwapEdge& swap) const {
  const Plane f = plane_through(depth_plane_corners(scene_.mesh(), swap.surfaces[0]));
  const Plane g = plane_through(depth_plane_corners(scene_.mesh(), swap.surfaces[1]));
  const DoubleWord f_at_eye = at_eye(f);
  const DoubleWord g_at_eye = at_eye(g);
  return {f.normal * g_at_eye - g.normal * f_at_eye, f.corner, -(g.at(f.corner) * f_at_eye)};
}

DoubleWord SeenInSpace::at_eye(const Plane& plane) const {
  return has_perspective() ? plane.at(eye_) : dot(plane.normal, eye_);
}

DoubleWordVector SeenInSpace::direction_to(const DoubleWordVector& p) const {
  if (has_perspective()) return p - eye_;
  return eye_;
}

std::optional<SeenInSpace::Ends> SeenInSpace::ends_of(EdgeId e) const {
  if (e.index() >= scene_.edge_count()) return std::nullopt;
  const auto vertex_at = [this](PointId p) { return scene_.unrounded.sources[p.index()].vertex; };
  return ends_of(vertex_at(scene_.edge(e).top), vertex_at(scene_.edge(e).bottom));
}

std::optional<SeenInSpace::Ends> SeenInSpace::ends_of(MeshEdgeId edge) const {
  const auto& [from, to] = scene_.mesh().edges[edge.index()];
  return ends_of(from, to);
}

std::optional<SeenInSpace::Ends> SeenInSpace::ends_of(VertexId a, VertexId b) const {
  if (!is_of_input(a) || !is_of_input(b)) return std::nullopt;
  return Ends{scene_.mesh().position(a), scene_.mesh().position(b)};
}

std::optional<DoubleWordVector> SeenInSpace::meeting(const Ends& ends, EdgeId e) const {
  const auto plane = plane_through_eye(e);
  if (!plane) return std::nullopt;
  const DoubleWordVector from = in_words(ends[0]);
  const DoubleWordVector along = in_words(ends[1]) - from;
  const DoubleWord at_from = plane->at(from);
  const DoubleWord share = at_from / -dot(plane->normal, along);
  return DoubleWordVector(from + along * share);
}

std::optional<DoubleWordVector> SeenInSpace::crossing(EdgeId a, EdgeId b) const {
  if (const auto ends = ends_of(a)) return meeting(*ends, b);
  if (const auto ends = ends_of(b)) return meeting(*ends, a);
  return std::nullopt;
}

std::optional<DoubleWordVector> SeenInSpace::vertex(PointId p) const {
  const VertexId vertex = scene_.unrounded.sources[p.index()].vertex;
  if (!is_of_input(vertex)) return std::nullopt;
  return in_words(scene_.mesh().position(vertex));
}

// The rows of the camera give X and Y, its direction W.
DoubleWord SeenInSpace::coordinate(const Vector3& row, const DoubleWordVector& p) const {
  const DoubleWordVector from_origin = p - in_words(scene_.camera.origin);
  const DoubleWord scaled = dot(in_words(row), from_origin);
  return has_perspective() ? scaled / dot(in_words(scene_.camera.forward), from_origin) : scaled;
}

DoubleWord SeenInSpace::height_of(const DoubleWordVector& p) const { return coordinate(scene_.camera.up, p); }

// One radius for both, that is no number as soon as one of them is none.
CertifiedPlace SeenInSpace::place_of(const DoubleWordVector& p) const {
  const DoubleWord x = coordinate(scene_.camera.right, p);
  const DoubleWord y = height_of(p);
  const auto reach = [](const DoubleWord& of) { return Bounded::widened(std::abs(of.low) + of.radius); };
  return {x.high, y.high, reach(x) + reach(y)};
}

std::optional<Point2> SeenInSpace::rounded_place_of(const DoubleWordVector& p) const {
  const auto x = certain_rounding(coordinate(scene_.camera.right, p));
  const auto y = certain_rounding(height_of(p));
  if (!x || !y) return std::nullopt;
  return Point2{*x, *y};
}

}  // namespace sightline::inline sweep
