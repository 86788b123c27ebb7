// The part of a surface in view, in triangles that are each wholly visible or wholly hidden, and reflect a panel wholly
// or not at all.
//
// In:  the borders of the surface's facets in view, its visible polygons, and what of them reflects panels.
// Out: triangles in the surface's orientation. A constrained Delaunay triangulation (in the surface's own plane) of
//      the border and the visible rings, whose structure is decided exactly in the image. A region between
//      constraints is visible where a ring has it on its left, outside where only the border has it on its right,
//      else hidden; so no point enters that neither the border nor a visible ring needs. Where several vertices of
//      the border fall on one image point, one stands for all in the triangulation, and triangles without area in the
//      image join it with the others.
// Errors: ConstraintConflict where the rounded border of a face with several facets crosses itself.
// Source: Koucky 2014, 3.8 (both triangulations in one: only points that visible parts need).
#pragma once

#include <array>
#include <span>
#include <vector>

#include "reconstruct/labelling/facet_border.h"
#include "reconstruct/labelling/label_sources.h"
#include "reconstruct/labelling/new_vertices.h"

namespace sightline::inline reconstruct {

struct SurfaceTriangle {
  std::array<VertexId, 3> corners;
  bool visible = false;
  std::uint64_t reflecting = 0;  // bit per panel
};

struct SurfaceInView {
  FacetId surface;
  bool back_facing = false;
  std::vector<std::vector<ViewBorderPoint>> borders;  // per facet in view
  std::vector<SegmentId> visible;                     // the segments of its visible polygons
  std::span<const ReflectingSegment> reflecting;
};

// `vertices` are those of the labelled surface.
[[nodiscard]] std::vector<SurfaceTriangle> surface_triangles(const LabelSources& from, const SurfaceInView& surface,
                                                             const NewVertices& vertices, InnerVertices& inner);

}  // namespace sightline::inline reconstruct
