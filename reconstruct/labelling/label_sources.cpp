#include "reconstruct/labelling/label_sources.h"

#include <algorithm>

namespace sightline::inline reconstruct {
namespace {

// Returns the mesh's vertices, with room for the points on its edges.
std::vector<Point3> vertices_with_room(const ProjectedScene& scene, const VisibleSegments& segments) {
  const CutMesh& mesh = scene.mesh();
  std::vector<Point3> vertices;
  vertices.reserve(mesh.vertices.size() + scene.made_corners.size() + segments.splits.size());
  vertices.assign(mesh.vertices.begin(), mesh.vertices.end());
  return vertices;
}

}  // namespace

// In the body the names are the parameters'.
LabelSources::LabelSources(const ProjectedScene& scene, const VisibleSegments& segments,
                           const VisiblePolygons& polygons, const PanelBorders& panels)
    : mesh(scene.mesh()),
      scene(scene),
      segments(segments),
      polygons(polygons),
      points(scene, segments),
      vertices(vertices_with_room(scene, segments)),
      edge_points(scene, segments, points, vertices) {
  const auto is_of_edge = [](const EdgeSplit& split) { return split.mesh_edge.valid(); };
  border_splits.assign(std::ranges::partition_point(segments.splits, is_of_edge), segments.splits.end());
  std::ranges::sort(border_splits, {}, &EdgeSplit::facet);
  for (std::size_t panel = 0; panel < panels.size(); ++panel) {
    for (const VisibleSegment& segment : panels[panel]) reflecting.push_back({segment, panel});
  }
  std::ranges::stable_sort(reflecting, {}, [](const ReflectingSegment& r) { return r.segment.facet; });
}

std::span<const EdgeSplit> LabelSources::border_splits_of(FacetId f) const {
  const auto first = std::ranges::lower_bound(border_splits, f, {}, &EdgeSplit::facet);
  return {first, std::ranges::upper_bound(border_splits, f, {}, &EdgeSplit::facet)};
}

std::span<const ReflectingSegment> LabelSources::reflecting_on(FacetId surface) const {
  const auto facet = [](const ReflectingSegment& r) { return r.segment.facet; };
  const auto first = std::ranges::lower_bound(reflecting, surface, {}, facet);
  return {first, std::ranges::upper_bound(reflecting, surface, {}, facet)};
}

}  // namespace sightline::inline reconstruct
