#include "peers/scene/in_front.h"

#include <algorithm>
#include <cmath>

#include "geometry/mesh/facet_plane.h"

namespace sightline::peers {
namespace {

bool lie_in_one_plane(const CutMesh& mesh, FacetId a, FacetId b) {
  const auto corners = plane_corners(mesh, b);
  return std::all_of(corners.begin(), corners.end(), [&](VertexId v) {
    return side_of_plane(mesh, a, {mesh.position(v), 1}) == 0;
  });
}

// Returns how much farther away a is than b, where that is most or least.
double largest_difference(const DepthPlane& a, const DepthPlane& b, const ConvexRing& overlap) {
  double largest = 0;
  for (const Point2& p : overlap) {
    const double difference = a.at(p.x, p.y) - b.at(p.x, p.y);
    if (std::abs(difference) > std::abs(largest)) largest = difference;
  }
  return largest;
}

}  // namespace

bool is_in_front(const FlatPolygon& a, const FlatPolygon& b, const ConvexRing& overlap, const CutMesh& mesh) {
  const double farther = largest_difference(a.plane, b.plane, overlap);
  if (farther == 0 || lie_in_one_plane(mesh, a.facet, b.facet))
    return is_in_front_in_plane(a, b) || (!is_in_front_in_plane(b, a) && a.facet < b.facet);
  return farther < 0;
}

}  // namespace sightline::peers
