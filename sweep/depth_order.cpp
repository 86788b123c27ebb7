#include "sweep/depth_order.h"

#include <algorithm>

#include "geometry/facet_plane.h"

namespace sightline {

DepthOrder::DepthOrder(const Mesh& mesh, const ProjectedScene& scene)
    : mesh_(mesh), eye_(scene.camera.eye), facing_(scene.facing) {
  planes_.reserve(mesh.facet_count());
  for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
    planes_.push_back(plane_corners(mesh, FacetId(f)));
    if (facing_[f] == Facing::back) std::swap(planes_.back()[1], planes_.back()[2]);
  }
}

bool DepthOrder::nearer(FacetId f, FacetId g) {
  ++comparisons_;
  return f < g ? lower_is_nearer(f, g) : !lower_is_nearer(g, f);
}

// f has the lower facet index, and with it the lower or the same face index.
bool DepthOrder::lower_is_nearer(FacetId f, FacetId g) {
  const Evidence of_f = corners_against_plane(f, g);
  if (of_f.front == 0 && of_f.behind == 0) return true;
  if (of_f.front == 0 || of_f.behind == 0) return of_f.front > 0;
  const Evidence of_g = corners_against_plane(g, f);
  if (of_g.front == 0 || of_g.behind == 0) return of_g.behind > 0;
  const Evidence seen = overlap_evidence(f, g);
  if (seen.front > 0 && seen.behind > 0) conflicts_.push_back({f, g});
  return seen.front >= seen.behind;
}

// Stops as soon as f is known to straddle the plane.
DepthOrder::Evidence DepthOrder::corners_against_plane(FacetId f, FacetId g) {
  Evidence evidence;
  for (const VertexId v : mesh_.corners(f)) {
    evidence.add(side_towards_eye(g, v));
    if (evidence.front > 0 && evidence.behind > 0) break;
  }
  return evidence;
}

DepthOrder::Evidence DepthOrder::overlap_evidence(FacetId f, FacetId g) {
  Evidence evidence;
  for (const VertexId v : mesh_.corners(f)) {
    if (covers(g, v)) evidence.add(side_towards_eye(g, v));
  }
  for (const VertexId v : mesh_.corners(g)) {
    if (covers(f, v)) evidence.add(-side_towards_eye(f, v));
  }
  add_edge_crossings(f, g, evidence);
  return evidence;
}

// Whether the ray from the eye to v meets the facet, its border included.
bool DepthOrder::covers(FacetId f, VertexId v) {
  const auto corners = mesh_.corners(f);
  const Sign turn = facing_[f.index()] == Facing::back ? -1 : 1;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const VertexId next = corners[i + 1 == corners.size() ? 0 : i + 1];
    if (seen_orientation(corners[i], next, v) * turn < 0) return false;
  }
  return true;
}

// Two edges ab of f and cd of g cross, seen from the eye, where the four orientations below agree (the test for arcs on
// the sphere of directions; it excludes arcs that cross behind the eye). There cd is nearer than ab where d and the eye
// are on one side of the plane abc.
void DepthOrder::add_edge_crossings(FacetId f, FacetId g, Evidence& evidence) {
  const auto f_corners = mesh_.corners(f);
  const auto g_corners = mesh_.corners(g);
  for (std::size_t i = 0; i < f_corners.size(); ++i) {
    const VertexId a = f_corners[i];
    const VertexId b = f_corners[i + 1 == f_corners.size() ? 0 : i + 1];
    for (std::size_t j = 0; j < g_corners.size(); ++j) {
      const VertexId c = g_corners[j];
      const VertexId d = g_corners[j + 1 == g_corners.size() ? 0 : j + 1];
      const Sign abc = seen_orientation(a, b, c);
      if (abc == 0 || seen_orientation(a, b, d) != -abc) continue;
      if (seen_orientation(c, d, b) != abc || seen_orientation(c, d, a) != -abc) continue;
      evidence.add(-abc *
                   orient3d(mesh_.position(a), mesh_.position(b), mesh_.position(c), mesh_.position(d), &counts_));
    }
  }
}

// +1 where v is on the eye's side of the facet's plane. A corner of the facet is on the plane by index, without
// arithmetic.
Sign DepthOrder::side_towards_eye(FacetId plane, VertexId v) {
  const VertexId welded = mesh_.weld[v.index()];
  for (const VertexId corner : mesh_.corners(plane)) {
    if (mesh_.weld[corner.index()] == welded) return 0;
  }
  const auto& [a, b, c] = planes_[plane.index()];
  return orient3d(mesh_.position(a), mesh_.position(b), mesh_.position(c), mesh_.position(v), &counts_);
}

// +1 where the eye sees a, b, c counter-clockwise.
Sign DepthOrder::seen_orientation(VertexId a, VertexId b, VertexId c) {
  const auto welded = [this](VertexId v) { return mesh_.weld[v.index()]; };
  if (welded(a) == welded(c) || welded(b) == welded(c)) return 0;
  return orient3d(mesh_.position(a), mesh_.position(b), mesh_.position(c), eye_, &counts_);
}

}  // namespace sightline
