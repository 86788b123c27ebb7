// The sources are what all surfaces are labelled from.
//
// In:  a view: projected scene, visible segments and polygons, and the borders of what reflects panels.
// Out: these, and what is common to all surfaces: the points of the image, the mesh's vertices, and the points on its edges
//      as vertices behind them. It is made once, and then only read, by any number of threads.
// Complexity: O(n log n).
#pragma once

#include <span>
#include <vector>

#include "geometry/mesh/cut_mesh.h"
#include "geometry/projection/projected_scene.h"
#include "reconstruct/labelling/edge_points.h"
#include "reconstruct/labelling/labelled_mesh.h"
#include "reconstruct/polygons/visible_polygons.h"

namespace sightline::inline reconstruct {

// This is a segment of the border of what reflects a panel, within a visible polygon.
struct ReflectingSegment {
  VisibleSegment segment;
  std::size_t panel = 0;
};

struct LabelSources {
  LabelSources(const ProjectedScene& scene, const VisibleSegments& segments, const VisiblePolygons& polygons,
               const PanelBorders& panels);

  const CutMesh& mesh;
  const ProjectedScene& scene;
  const VisibleSegments& segments;
  const VisiblePolygons& polygons;
  const ImagePoints points;
  std::vector<Point3> vertices;  // the mesh's, then the points on its edges
  const EdgePoints edge_points;
  std::vector<EdgeSplit> border_splits;       // along the view volume's border, by facet
  std::vector<ReflectingSegment> reflecting;  // by surface, then by panel

  [[nodiscard]] std::span<const EdgeSplit> border_splits_of(FacetId f) const;
  [[nodiscard]] std::span<const ReflectingSegment> reflecting_on(FacetId surface) const;
};

}  // namespace sightline::inline reconstruct
