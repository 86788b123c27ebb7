#include "reflect/world/flush_panels.h"

#include <algorithm>

#include "reflect/world/uncut_facets.h"

namespace sightline::inline reflect {

namespace {

std::vector<Point3> positions(const CutMesh& mesh, std::span<const VertexId> corners) {
  std::vector<Point3> result;
  for (const VertexId v : corners) result.push_back(mesh.position(v));
  return result;
}

// Returns how a convex polygon lies on a panel, all of whose facets count together.
std::optional<Coincidence> coincidence_with(const CutMesh& panel, std::span<const Point3> polygon, double distance) {
  std::optional<Coincidence> together;
  for (std::size_t f = 0; f < panel.facet_count(); ++f) {
    const auto part = coincidence_of(positions(panel, panel.corners(FacetId(f))), polygon, distance);
    if (!part) continue;
    if (!together) together.emplace();
    together->distance = std::max(together->distance, part->distance);
    together->overlap += part->overlap;
  }
  return together;
}

std::optional<Coincidence> coincidence_with(const CutMesh& panel, const CutMesh& other, double distance) {
  std::optional<Coincidence> together;
  for (std::size_t f = 0; f < other.facet_count(); ++f) {
    const auto part = coincidence_with(panel, positions(other, other.corners(FacetId(f))), distance);
    if (!part) continue;
    if (!together) together.emplace();
    together->distance = std::max(together->distance, part->distance);
    together->overlap += part->overlap;
  }
  return together;
}

}  // namespace

Flush find_flush(const CutMesh& surface, const Obstacles& obstacles, std::span<const CutMesh> panels, std::size_t panel,
                 double distance) {
  Flush flush;
  const CutMesh& mesh = panels[panel];
  const Box around = box_of(mesh, mesh.faces[0]);
  const Box widened{around.low.array() - distance, around.high.array() + distance};
  std::vector<UncutFacetId> near = obstacles.in([&](const Box& box) { return overlap(box, widened); });
  std::ranges::sort(near);
  for (const UncutFacetId facet : near) {
    const auto found = coincidence_with(mesh, positions(surface, surface.uncut_corners(facet)), distance);
    if (found) flush.facets.push_back({*found, facet});
  }
  for (std::size_t other = 0; other < panels.size(); ++other) {
    if (other == panel) continue;
    if (const auto found = coincidence_with(mesh, panels[other], distance)) flush.panels.push_back({*found, other});
  }
  return flush;
}

}  // namespace sightline::inline reflect
