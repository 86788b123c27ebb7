#include "sweep/plain/depth_order.h"

#include <algorithm>
#include <bit>

#include "geometry/mesh/facet_plane.h"
#include "geometry/projection/seen_orientation.h"
#include "geometry/projection/unfiltered.h"

namespace sightline::inline sweep {

DepthOrder::DepthOrder(const ProjectedScene& scene, std::span<const DepthRange> ranges)
    : mesh_(scene.mesh()),
      arithmetic_(scene.arithmetic),
      camera_(scene.camera),
      facing_(scene.facing),
      pieces_(scene),
      ranges_(ranges),
      snapped_(mesh_.snapped_to.empty() ? nullptr : std::make_unique<SnappedOrder>(scene)) {}

bool DepthOrder::is_turned(UncutFacetId u) const { return facing_[mesh_.first_piece(u).index()] == FacetFacing::back; }

DepthRelation DepthOrder::relation(FacetId f, FacetId g) {
  ++comparisons_;
  if (are_apart(f, g)) return {true, false};
  if (are_apart(g, f)) return {false, false};
  if (f < g) return relation_of_lower(f, g);
  const DepthRelation turned = relation_of_lower(g, f);
  return {!turned.nearer, turned.passes_through};
}

bool DepthOrder::pass_through(FacetId f, FacetId g) {
  ++comparisons_;
  if (are_apart(f, g) || are_apart(g, f)) return false;
  const auto [of_f, of_g] = std::minmax({mesh_.uncut_facet(f), mesh_.uncut_facet(g)});
  if (of_f == of_g || (mesh_.is_cut() && pieces_.applies_to(of_f, of_g))) return false;
  return known_relation(of_f, of_g).passes_through;
}

// Precondition: f has the lower facet index, and with it the lower or the same face index.
DepthRelation DepthOrder::relation_of_lower(FacetId f, FacetId g) {
  const UncutFacetId of_f = mesh_.uncut_facet(f);
  const UncutFacetId of_g = mesh_.uncut_facet(g);
  if (of_f == of_g) return {true, false};
  if (mesh_.is_cut() && pieces_.applies_to(of_f, of_g)) return {pieces_.lower_is_nearer(f, g), false};
  if (local_ == nullptr) return relation_of_uncut(of_f, of_g);
  const DepthRelation relation = known_relation(of_f, of_g);
  return relation.passes_through ? local_->relation_here(f, g) : relation;
}

// Precondition: as above. Where they pass through each other, somebody else says who is nearer.
DepthRelation DepthOrder::relation_of_uncut(UncutFacetId f, UncutFacetId g) {
  if (is_any_snapped(f, g)) return relation_of_snapped(f, g);
  const Evidence of_f = corners_against_plane(f, g);
  if (of_f.front == 0 && of_f.behind == 0) return relation_in_plane(f, g);
  if (of_f.front == 0 || of_f.behind == 0) return {of_f.front > 0, false};
  const Evidence of_g = corners_against_plane(g, f);
  if (of_g.front == 0 || of_g.behind == 0) return {of_g.behind > 0, false};
  return relation_where_seen(overlap_evidence(f, g));
}

// Precondition: as above. One of both is snapped.
DepthRelation DepthOrder::relation_of_snapped(UncutFacetId f, UncutFacetId g) {
  if (mesh_.plane_of(f) == mesh_.plane_of(g)) return relation_in_plane(f, g);
  const Evidence seen = overlap_evidence(f, g);
  return seen.front == 0 && seen.behind == 0 ? relation_in_plane(f, g) : relation_where_seen(seen);
}

DepthRelation DepthOrder::relation_where_seen(const Evidence& seen) const {
  return {seen.front >= seen.behind, local_ != nullptr && seen.front > 0 && seen.behind > 0};
}

// Precondition: as above. Of what is in one plane and turned alike the lower index is in front.
DepthRelation DepthOrder::relation_in_plane(UncutFacetId f, UncutFacetId g) const {
  return {!is_turned(f) || is_turned(g), false};
}

void DepthOrder::set_local_order(LocalOrder* local) {
  local_ = local;
  known_bits_ = std::min(most_known_bits, 4 + static_cast<int>(std::bit_width(mesh_.uncut_facet_count())));
  known_.resize(std::size_t{1} << known_bits_);
}

DepthRelation DepthOrder::known_relation(UncutFacetId f, UncutFacetId g) {
  const std::uint64_t pair = std::uint64_t{f.value} << 32 | g.value;
  Known& known = known_[(pair * 0x9E3779B97F4A7C15U) >> (64 - known_bits_)];
  if (known.pair != pair) known = {pair, relation_of_uncut(f, g)};
  return known.relation;
}

// Stops as soon as f is known to straddle the plane.
DepthOrder::Evidence DepthOrder::corners_against_plane(UncutFacetId f, UncutFacetId g) {
  Evidence evidence;
  for (const VertexId v : mesh_.uncut_corners(f)) {
    evidence.add(side_towards_eye(g, v));
    if (evidence.front > 0 && evidence.behind > 0) break;
  }
  return evidence;
}

DepthOrder::Evidence DepthOrder::overlap_evidence(UncutFacetId f, UncutFacetId g) {
  Evidence evidence;
  for (const VertexId v : mesh_.uncut_corners(f)) {
    if (covers(g, v)) evidence.add(nearer_at_corner(f, g, v));
  }
  for (const VertexId v : mesh_.uncut_corners(g)) {
    if (covers(f, v)) evidence.add(-nearer_at_corner(g, f, v));
  }
  add_edge_crossings(f, g, evidence);
  return evidence;
}

Sign DepthOrder::nearer_at_corner(UncutFacetId f, UncutFacetId g, VertexId v) {
  if (!is_any_snapped(f, g)) return side_towards_eye(g, v);
  return snapped_->nearer_at(mesh_.first_piece(f), mesh_.first_piece(g), v);
}

// Returns whether the ray from the eye to v meets the facet, its border included.
bool DepthOrder::covers(UncutFacetId f, VertexId v) {
  const auto around = mesh_.uncut_corners(f);
  const Sign turn = is_turned(f) ? -1 : 1;
  for (std::size_t i = 0; i < around.size(); ++i) {
    const VertexId next = around[i + 1 == around.size() ? 0 : i + 1];
    if (seen_orientation(around[i], next, v) * turn < 0) return false;
  }
  return true;
}

// Two edges ab of f and cd of g cross, seen from the eye, where the four orientations below agree (the test for arcs on
// the sphere of directions; it excludes arcs that cross behind the eye). There cd is nearer than ab where d and the eye
// are on one side of the plane abc.
void DepthOrder::add_edge_crossings(UncutFacetId f, UncutFacetId g, Evidence& evidence) {
  const auto f_corners = mesh_.uncut_corners(f);
  const auto g_corners = mesh_.uncut_corners(g);
  for (std::size_t i = 0; i < f_corners.size(); ++i) {
    const VertexId a = f_corners[i];
    const VertexId b = f_corners[i + 1 == f_corners.size() ? 0 : i + 1];
    for (std::size_t j = 0; j < g_corners.size(); ++j) {
      const VertexId c = g_corners[j];
      const VertexId d = g_corners[j + 1 == g_corners.size() ? 0 : j + 1];
      const Sign abc = seen_orientation(a, b, c);
      if (abc == 0 || seen_orientation(a, b, d) != -abc) continue;
      if (seen_orientation(c, d, b) != abc || seen_orientation(c, d, a) != -abc) continue;
      evidence.add(is_any_snapped(f, g)
                       ? snapped_->nearer_at_crossing(mesh_.first_piece(f), mesh_.first_piece(g), a, b, c, d)
                       : -abc * orientation(a, b, c, {mesh_.position(d), 1}));
    }
  }
}

// Returns +1 where v is on the eye's side of the facet's plane. A corner of the facet is on the plane by index, without
// arithmetic.
Sign DepthOrder::side_towards_eye(UncutFacetId plane, VertexId v) {
  const VertexId welded = mesh_.weld[v.index()];
  for (const VertexId corner : mesh_.uncut_corners(plane)) {
    if (mesh_.weld[corner.index()] == welded) return 0;
  }
  const auto [a, b, c] = plane_of(plane);
  return orientation(a, b, c, {mesh_.position(v), 1});
}

std::array<VertexId, 3> DepthOrder::plane_of(UncutFacetId w) const {
  std::array<VertexId, 3> plane = plane_corners(mesh_, mesh_.first_piece(w));
  if (is_turned(w)) std::swap(plane[1], plane[2]);
  return plane;
}

// Returns +1 where the eye sees a, b, c counter-clockwise.
Sign DepthOrder::seen_orientation(VertexId a, VertexId b, VertexId c) {
  const auto welded = [this](VertexId v) { return mesh_.weld[v.index()]; };
  if (welded(a) == welded(c) || welded(b) == welded(c)) return 0;
  const Point3& pa = mesh_.position(a);
  const Point3& pb = mesh_.position(b);
  const Point3& pc = mesh_.position(c);
  if (is_exact(arithmetic_)) return sightline::seen_orientation(camera_, pa, pb, pc, &counts_);
  return unfiltered::orient3d(arithmetic_, pa, pb, pc, camera_.eye);
}

// Returns orient3d in the scene's arithmetic.
Sign DepthOrder::orientation(VertexId a, VertexId b, VertexId c, const HomogeneousPoint& d) {
  const Point3& pa = mesh_.position(a);
  const Point3& pb = mesh_.position(b);
  const Point3& pc = mesh_.position(c);
  if (is_exact(arithmetic_)) return orient3d(pa, pb, pc, d, &counts_);
  return unfiltered::orient3d(arithmetic_, pa, pb, pc, d);
}

}  // namespace sightline::inline sweep
