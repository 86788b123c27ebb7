// The border of a facet as the labelled surface has it: its corners and all the points that split its edges.
//
// In:  what all surfaces are labelled from, or of it the mesh and the points on mesh edges.
// Out: borders in the facet's orientation, of the whole facet or of its part in view.
// Holds: no vertex twice in a row; two lines have the same side exactly where they are on one straight line.
#pragma once

#include <optional>
#include <vector>

#include "reconstruct/labelling/label_sources.h"
#include "reconstruct/triangulation/convex_triangles.h"

namespace sightline::inline reconstruct {

// This point is on the border of what is in view of a facet.
struct ViewBorderPoint {
  BorderPoint border;
  PointId image;
};

// Gives the vertex of a corner that clipping made inside the facet, and of a point that splits its border with the view
// volume.
class InnerVertices {
 public:
  virtual ~InnerVertices() = default;
  virtual VertexId vertex_at(PointId p, std::optional<Point3> position) = 0;
};

// Returns, per edge of a convex polygon, a number that edges on one straight line share.
[[nodiscard]] std::vector<std::uint32_t> straight_sides(const CutMesh& mesh, std::span<const VertexId> corners);

[[nodiscard]] std::vector<BorderPoint> facet_border(const CutMesh& mesh, const EdgePoints& edge_points, FacetId facet);

// Returns the border of a facet before it was cut along common lines, with all points that its edges have now.
[[nodiscard]] std::vector<BorderPoint> uncut_border(const CutMesh& mesh, const EdgePoints& edge_points,
                                                    UncutFacetId uncut);

// With splits_of_view_border, the sweep's splits along the view volume's border are points, too.
[[nodiscard]] std::vector<ViewBorderPoint> view_border(const LabelSources& from, FacetId facet,
                                                       std::span<const EdgeSplit> splits_of_view_border,
                                                       InnerVertices& inner);

// Returns the vertex of a corner of a clipped polygon.
[[nodiscard]] VertexId corner_vertex(const LabelSources& from, const ClippedCorner& corner, InnerVertices& inner);

// Returns the splits of the line from corner i to the next along the view volume's border, in that direction.
[[nodiscard]] std::vector<PointId> splits_between(const LabelSources& from, FacetId facet, std::size_t i,
                                                  std::span<const EdgeSplit> splits_of_view_border);

// Returns whether the rounded polygon of a facet in view is still convex and turns as the facet does. Where it does
// not, the facet is narrower than the grid. Straight sides that rounding bends, within the grid, do not count.
[[nodiscard]] bool is_proper(const ProjectedScene& scene, FacetId facet);

}  // namespace sightline::inline reconstruct
