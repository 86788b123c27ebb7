// Which of two pieces is in front, where the facets they were cut from passed through each other.
//
// In:  pieces of two uncut facets that cross (Mesh::cuts).
// Out: whether the first is nearer to the eye wherever they overlap.
// Holds: a piece was cut wherever the other uncut facet passes through it, so the order is one and the same in all of the
// overlap. Pieces that overlap in the rounded image only (narrower than the grid): the lower facet index is in front.
// Method: where a piece lies on one side of the other's plane, that side decides: mostly so, since it was cut along
// that plane. Else the part of one that the eye sees within the other, which the other does not pass through.
// Complexity: O(k) heights over a plane for k corners, else O(k^2); in integers of any size. Each pair is decided once.
#pragma once

#include <map>
#include <vector>

#include "geometry/cutting/facet_cutter.h"
#include "geometry/mesh/cut_mesh.h"
#include "geometry/numbers/predicates.h"
#include "geometry/projection/projected_scene.h"

namespace sightline::inline sweep {

class PieceOrder {
 public:
  PieceOrder(const ProjectedScene& scene);

  // Returns whether two uncut facets cross.
  [[nodiscard]] bool applies_to(UncutFacetId a, UncutFacetId b) const;

  // Precondition: f < g.
  [[nodiscard]] bool lower_is_nearer(FacetId f, FacetId g);

 private:
  [[nodiscard]] Sign order(FacetId f, FacetId g);
  [[nodiscard]] const ExactPlane& plane_towards_eye(UncutFacetId uncut);
  [[nodiscard]] CutPolygon seen_within(CutPolygon polygon, FacetId frame) const;
  [[nodiscard]] ExactPlane plane_through_eye(const ExactPosition& p, const ExactPosition& q) const;

  const CutMesh& mesh_;
  HomogeneousPoint eye_;
  const std::vector<FacetFacing>& facing_;
  std::vector<std::uint8_t> crosses_;  // per uncut facet: 1 where it crosses any
  std::map<UncutFacetId, ExactPlane> planes_;
  std::map<std::array<FacetId, 2>, bool> known_;
};

}  // namespace sightline::inline sweep
