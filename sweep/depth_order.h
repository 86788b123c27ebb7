// Which of two facets is in front, exactly, on the input's own coordinates: depth is never rounded.
//
// In:  two facets that overlap somewhere in the image and are not edge-on.
// Out: whether the first is nearer to the eye there.
// Holds: facets that do not interpenetrate have one order wherever they overlap, since both are convex and planar; so
// the answer does not depend on the place. nearer(f, g) != nearer(g, f). Coplanar facets: the lower face index is in
// front.
// Method: if all of one facet is on one side of the other's plane, that side decides. Otherwise they straddle each
// other's planes, and a place where they overlap is found: a corner of one within the other, or edges of both that
// cross, seen from the eye. Such a place shows the order by one orient3d. Places that show both orders prove that the
// facets interpenetrate: a conflict, which is recorded. Facets that overlap in the rounded image only (narrower than
// the grid) show no place; the lower facet index is in front.
// Departure from Fang's appendix B, which compares depths at the sweep point: that needs the rounded point lifted, and
// cannot be exact.
#pragma once

#include <array>
#include <vector>

#include "geometry/mesh.h"
#include "geometry/predicates.h"
#include "geometry/projected_scene.h"

namespace sightline {

class DepthOrder {
 public:
  DepthOrder(const Mesh& mesh, const ProjectedScene& scene);

  [[nodiscard]] bool nearer(FacetId f, FacetId g);

  // Pairs of facets that were seen to interpenetrate, smaller id first, in order of discovery, repeated.
  [[nodiscard]] const std::vector<std::array<FacetId, 2>>& conflicts() const { return conflicts_; }
  [[nodiscard]] const predicates::Counts& counts() const { return counts_; }
  [[nodiscard]] std::uint64_t comparisons() const { return comparisons_; }

 private:
  // How many places show the first facet in front, and how many behind.
  struct Evidence {
    int front = 0;
    int behind = 0;
    void add(Sign towards_eye) {
      front += towards_eye > 0 ? 1 : 0;
      behind += towards_eye < 0 ? 1 : 0;
    }
  };

  [[nodiscard]] Evidence corners_against_plane(FacetId f, FacetId g);
  [[nodiscard]] Evidence overlap_evidence(FacetId f, FacetId g);
  [[nodiscard]] bool covers(FacetId f, VertexId v);
  void add_edge_crossings(FacetId f, FacetId g, Evidence& evidence);
  [[nodiscard]] Sign side_towards_eye(FacetId plane, VertexId v);
  [[nodiscard]] Sign seen_orientation(VertexId a, VertexId b, VertexId c);
  [[nodiscard]] bool lower_is_nearer(FacetId f, FacetId g);

  const Mesh& mesh_;
  HomogeneousPoint eye_;
  std::vector<std::array<VertexId, 3>> planes_;  // three corners, so turned that the eye sees them counter-clockwise
  const std::vector<Facing>& facing_;
  std::vector<std::array<FacetId, 2>> conflicts_;
  predicates::Counts counts_;
  std::uint64_t comparisons_ = 0;
};

}  // namespace sightline
