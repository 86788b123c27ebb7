#include "reconstruct/labelling/rounded_facet.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "reconstruct/labelling/facet_border.h"

namespace sightline::inline reconstruct {
namespace {

// Returns the corners of the rounded polygon at which the facet itself turns. Rounding may bend a straight side, within
// the grid.
std::vector<ImagePoint> turning_points(const Mesh& mesh, const ProjectedScene& scene, FacetId facet) {
  const auto polygon = scene.polygon(facet);
  const auto edges = mesh.edges_of(facet);
  const std::vector<std::uint32_t> sides = straight_sides(mesh, mesh.corners(facet));
  const auto side_after = [&](const ClippedCorner& corner) -> std::optional<std::uint32_t> {
    if (!corner.edge_after.valid()) return std::nullopt;
    return sides[static_cast<std::size_t>(std::ranges::find(edges, corner.edge_after) - edges.begin())];
  };
  std::vector<ImagePoint> points;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto side = side_after(polygon[i]);
    if (side && side == side_after(polygon[i == 0 ? polygon.size() - 1 : i - 1])) continue;
    const ImagePoint& point = scene.point(polygon[i].point);
    if (points.empty() || points.back() != point) points.push_back(point);
  }
  while (points.size() > 1 && points.front() == points.back()) points.pop_back();
  return points;
}

}  // namespace

bool is_proper(const Mesh& mesh, const ProjectedScene& scene, FacetId facet) {
  const Sign turn = scene.facing[facet.index()] == Facing::back ? -1 : 1;
  const auto polygon = scene.polygon(facet);
  if (polygon.size() == 3 && mesh.corners(facet).size() == 3) {
    return orientation(scene.point(polygon[0].point), scene.point(polygon[1].point), scene.point(polygon[2].point)) ==
           turn;
  }
  const std::vector<ImagePoint> p = turning_points(mesh, scene, facet);
  bool turns = false;
  int descents = 0;  // how often the border begins to run down the sweep order: once around a convex polygon
  for (std::size_t i = 0; i < p.size() && p.size() > 2; ++i) {
    const ImagePoint& b = p[(i + 1) % p.size()];
    const ImagePoint& c = p[(i + 2) % p.size()];
    const Sign o = orientation(p[i], b, c) * turn;
    if (o < 0) return false;
    turns = turns || o > 0;
    descents += sweeps_before(b, p[i]) && sweeps_before(b, c) ? 1 : 0;
  }
  return turns && descents == 1;
}

}  // namespace sightline::inline reconstruct
