#include "reconstruct/labelling/edge_points.h"

#include <algorithm>
#include <tuple>

#include "geometry/numbers/errors.h"
#include "reconstruct/labelling/lift.h"

namespace sightline::inline reconstruct {

EdgePoints::EdgePoints(const ProjectedScene& scene, const VisibleSegments& segments, const ImagePoints& points,
                       std::vector<Point3>& vertices)
    : slot_(scene.mesh().edges.size(), 0), begin_(scene.mesh().edges.size() + 1, 0) {
  auto found = candidates(scene, segments);
  find_in_view(scene, found);
  std::sort(found.begin(), found.end(), [&](const Candidate& a, const Candidate& b) {
    if (a.edge != b.edge) return a.edge < b.edge;
    if (a.point != b.point) return before_on_edge(a, b, points);
    const auto key = [](const Candidate& c) {
      const Point3 p = c.made != nullptr ? c.made->position : Point3::Zero();
      return std::tuple(c.made == nullptr, p.x(), p.y(), p.z());
    };
    return key(a) < key(b);
  });
  EdgeLift lift(points);
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (i > 0 && found[i].edge == found[i - 1].edge && found[i].point == found[i - 1].point) continue;
    points_.push_back({found[i].point, VertexId(vertices.size())});
    vertices.push_back(position(found[i], scene, points, lift));
    ++begin_[found[i].edge.index() + 1];
  }
  for (std::size_t e = 1; e < begin_.size(); ++e) begin_[e] += begin_[e - 1];
}

VertexId EdgePoints::vertex(MeshEdgeId edge, PointId p) const {
  for (const EdgePoint& candidate : on(edge)) {
    if (candidate.point == p) return candidate.vertex;
  }
  throw InternalError("mesh edge " + std::to_string(edge.value) + " is not split at point " + std::to_string(p.value));
}

void EdgePoints::find_in_view(const ProjectedScene& scene, const std::vector<Candidate>& found) {
  for (const Candidate& candidate : found) {
    std::uint32_t& slot = slot_[candidate.edge.index()];
    if (slot != 0) continue;
    in_view_.push_back(in_view_of(scene, candidate.edge, candidate.facet));
    slot = static_cast<std::uint32_t>(in_view_.size());
  }
}

// A facet runs along its edges from corner to corner; clipping keeps that direction. Nothing is in view of an edge that
// only touches the view volume.
EdgePoints::InView EdgePoints::in_view_of(const ProjectedScene& scene, MeshEdgeId edge, FacetId facet) {
  const CutMesh& mesh = scene.mesh();
  const auto polygon = scene.polygon(facet);
  const auto from = std::ranges::find(polygon, edge, &ClippedCorner::edge_after);
  if (from == polygon.end()) return {};
  const auto to = from + 1 == polygon.end() ? polygon.begin() : from + 1;
  const auto edges = mesh.edges_of(facet);
  const auto place = static_cast<std::size_t>(std::ranges::find(edges, edge) - edges.begin());
  const bool forward = mesh.weld[mesh.corners(facet)[place].index()] == mesh.edges[edge.index()][0];
  return forward ? InView{&*from, &*to} : InView{&*to, &*from};
}

std::vector<EdgePoints::Candidate> EdgePoints::candidates(const ProjectedScene& scene,
                                                          const VisibleSegments& segments) {
  std::vector<Candidate> found;
  for (const MadeCorner& made : scene.made_corners) {
    if (!made.on_edge.valid()) continue;
    found.push_back({made.on_edge, made.facet, scene.polygon_corners[made.corner].point, &made});
  }
  for (const EdgeSplit& split : segments.splits) {
    if (split.mesh_edge.valid()) found.push_back({split.mesh_edge, split.facet, split.point, nullptr});
  }
  return found;
}

// What is in view of an edge is one straight segment, and its points lie on it in sweep order or in the opposite order.
bool EdgePoints::before_on_edge(const Candidate& a, const Candidate& b, const ImagePoints& points) const {
  const InView& view = in_view(a.edge);
  const bool downwards = view.from == nullptr || points.sweeps_before(view.from->point, view.to->point);
  return downwards ? points.sweeps_before(a.point, b.point) : points.sweeps_before(b.point, a.point);
}

Point3 EdgePoints::position(const Candidate& c, const ProjectedScene& scene, const ImagePoints& points,
                            EdgeLift& lift) const {
  if (c.made != nullptr) return c.made->position;
  if (scene.is_unrounded()) return lift(c.edge, c.point);
  const InView& view = in_view(c.edge);
  return lift_on_edge(scene, points, *view.from, *view.to, c.point);
}

}  // namespace sightline::inline reconstruct
