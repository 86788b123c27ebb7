#include "sweep/plain/piece_order.h"

#include <algorithm>

#include "geometry/mesh/facet_plane.h"

namespace sightline::inline sweep {
namespace {

// Returns the side on which all of a polygon lies; 0 where it is on both, or in the plane.
Sign common_side(const CutPolygon& polygon, const ExactPlane& plane) {
  Sign side = 0;
  for (const CutCorner& corner : polygon) {
    const Sign of_corner = plane.side(corner.position);
    if (of_corner == -side && of_corner != 0) return 0;
    if (of_corner != 0) side = of_corner;
  }
  return side;
}

}  // namespace

PieceOrder::PieceOrder(const ProjectedScene& scene)
    : mesh_(scene.mesh()),
      eye_(scene.camera.eye),
      facing_(scene.facing),
      crosses_(scene.mesh().cuts.uncut_facets.size(), 0) {
  for (const auto& [a, b] : mesh_.cuts.crossing) crosses_[a.index()] = crosses_[b.index()] = 1;
}

bool PieceOrder::applies_to(UncutFacetId a, UncutFacetId b) const {
  if (crosses_[a.index()] == 0 || crosses_[b.index()] == 0) return false;
  return std::ranges::binary_search(mesh_.cuts.crossing, std::array{std::min(a, b), std::max(a, b)});
}

bool PieceOrder::lower_is_nearer(FacetId f, FacetId g) {
  const auto [place, is_new] = known_.try_emplace({f, g}, true);
  if (is_new) place->second = order(f, g) >= 0;
  return place->second;
}

// Returns +1 where f is nearer.
Sign PieceOrder::order(FacetId f, FacetId g) {
  const CutPolygon f_polygon = facet_polygon(mesh_, f);
  const ExactPlane& g_plane = plane_towards_eye(mesh_.uncut_facet(g));
  const Sign side_of_f = common_side(f_polygon, g_plane);
  if (side_of_f != 0) return side_of_f;
  const Sign side_of_g = common_side(facet_polygon(mesh_, g), plane_towards_eye(mesh_.uncut_facet(f)));
  if (side_of_g != 0) return -side_of_g;
  return common_side(seen_within(f_polygon, g), g_plane);
}

// The eye is in front of the plane.
const ExactPlane& PieceOrder::plane_towards_eye(UncutFacetId uncut) {
  const auto [place, is_new] = planes_.try_emplace(uncut);
  if (is_new) {
    const FacetId facet = mesh_.first_piece(uncut);
    const auto [a, b, c] = plane_corners(mesh_, facet);
    const ExactPlane plane =
        plane_through(exact_position(mesh_, a), exact_position(mesh_, b), exact_position(mesh_, c));
    place->second = facing_[facet.index()] == FacetFacing::back ? plane.turned() : plane;
  }
  return place->second;
}

// Returns what of the polygon the eye sees within the frame, whichever of the two is nearer.
CutPolygon PieceOrder::seen_within(CutPolygon polygon, FacetId frame) const {
  const CutPolygon corners = facet_polygon(mesh_, frame);
  const bool turned = facing_[frame.index()] == FacetFacing::back;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const ExactPlane plane = plane_through_eye(corners[i].position, corners[(i + 1) % corners.size()].position);
    polygon = part_in_front(polygon, turned ? plane.turned() : plane);
  }
  return polygon;
}

// The eye sees p, q and what is in front turn counter-clockwise.
ExactPlane PieceOrder::plane_through_eye(const ExactPosition& p, const ExactPosition& q) const {
  return eye_.w == 0 ? plane_towards(p, q, eye_.xyz).turned() : plane_through(p, q, exact_position(eye_.xyz)).turned();
}

}  // namespace sightline::inline sweep
