#include "reconstruct/labelling/certain_lift.h"

#include <algorithm>

#include "geometry/mesh/facet_plane.h"

namespace sightline::inline reconstruct {
namespace {

// Returns the point with each coordinate rounded. Where all of the corners have a coordinate in common, it is the point's, too:
// no bound would prove a zero. A zero has no sign, as in integers.
template <std::size_t N>
std::optional<Point3> rounded(const DoubleWordVector& point, const std::array<Point3, N>& corners) {
  Point3 result;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double first = corners.front()[i];
    const bool is_common = std::ranges::all_of(corners, [&](const Point3& corner) { return corner[i] == first; });
    const std::optional<double> coordinate = is_common ? 0.0 + first : certain_rounding(point[i]);
    if (!coordinate) return std::nullopt;
    result[i] = *coordinate;
  }
  return result;
}

}  // namespace

// Of the two edges that cross, the one that is the image of this edge does not say where on it that is.
std::optional<Point3> CertainLift::to_edge(MeshEdgeId edge, PointId p) const {
  const Crossing* const crossing = points_.crossing(p);
  if (crossing == nullptr) return std::nullopt;
  const auto ends = space_.ends_of(edge);
  if (!ends) return std::nullopt;
  for (const EdgeId e : {crossing->a, crossing->b}) {
    const auto point = space_.meeting(*ends, e);
    const auto lifted = point ? rounded(*point, *ends) : std::nullopt;
    if (lifted) return lifted;
  }
  return std::nullopt;
}

std::optional<Point3> CertainLift::to_plane(FacetId facet, PointId p) const {
  const Crossing* const crossing = points_.crossing(p);
  const auto seen = crossing != nullptr ? space_.crossing(crossing->a, crossing->b) : space_.vertex(p);
  if (!seen) return std::nullopt;
  const SeenInSpace::Plane plane = space_.plane_of(facet);
  const DoubleWordVector along = space_.direction_to(*seen);
  const DoubleWord share = plane.at(*seen) / dot(plane.normal, along);
  const auto corners = plane_corners(mesh_, facet);
  return rounded(DoubleWordVector(*seen - along * share),
                 std::array{mesh_.position(corners[0]), mesh_.position(corners[1]), mesh_.position(corners[2])});
}

}  // namespace sightline::inline reconstruct
