// The labelled surface: the whole input surface, refined so that every triangle is wholly one thing.
//
// In:  mesh, projected scene, visible segments and polygons, and what reflects panels.
// Out: LabelledMesh.
// Holds (validate(labelled, scene) checks it):
//   - the first vertices are the input's, bit for bit and in order;
//   - the triangles of a face have its orientation, but for some that are narrower than the grid in the image, where
//     rounding has bent what was straight; together they have its area;
//   - conforming: what splits an edge splits it for all faces on it, so that a mesh edge with two faces yields segments
//     with two triangles each; closed in, closed out;
//   - skipped faces have no triangle.
// Complexity: O(n log n) plus a constrained Delaunay triangulation per face that is seen in part.
// Errors: InternalError; in float and double ArithmeticError instead, also where `validate` complains of the segments
// or polygons.
// Source: Koucky 2014, 3.8 (retriangulation, no points that only a hidden part needs).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "geometry/mesh/cut_mesh.h"
#include "geometry/numbers/export.h"
#include "geometry/projection/projected_scene.h"
#include "reconstruct/polygons/visible_polygons.h"
#include "sweep/segments/visible_segments.h"

namespace sightline::inline reconstruct {

// A label that is not listed here does not exist; the values are those of the files.
enum class Label : std::uint8_t {
  back_facing = 0,  // its face is seen from behind, or edge-on
  out_of_view = 1,  // outside the view volume
  hidden = 2,       // in the view volume, facing the camera, behind something else (or below resolution)
  visible = 3,
};
[[nodiscard]] SIGHTLINE_EXPORT const char* to_string(Label label);

struct LabelledTriangle {
  std::array<VertexId, 3> corners;  // into LabelledMesh::vertices
  FaceId face;
  FacetId surface;  // the one it lies on (surface_of in facet_plane.h); one for all cameras without a lens
  Label label = Label::hidden;
  bool seen = false;             // the camera sees it: label visible, or of a back-facing face that nothing hides
  std::uint64_t reflecting = 0;  // bit p: it mirrors panel p into the camera
};

// Each panel has the borders of what reflects it, above resolution (reflect/reflections.h): directed segments within
// visible polygons, each on a surface that its `facet` names. They meet in end points only. There are at most 64
// panels.
using PanelBorders = std::vector<std::vector<VisibleSegment>>;
constexpr std::size_t most_panels = 64;

struct LabelledMesh {
  std::vector<Point3> vertices;
  std::vector<LabelledTriangle> triangles;  // by face, then by surface
};

[[nodiscard]] SIGHTLINE_EXPORT LabelledMesh label_mesh(const ProjectedScene& scene, const VisibleSegments& segments,
                                                       const VisiblePolygons& polygons,
                                                       const PanelBorders& panels = {});

// Returns what of the above does not hold, one line each, with the ids; nothing for a valid value.
[[nodiscard]] SIGHTLINE_EXPORT std::vector<std::string> validate(const LabelledMesh& labelled,
                                                                 const ProjectedScene& scene);

}  // namespace sightline::inline reconstruct
