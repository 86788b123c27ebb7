// The projected scene: what the sweep works on.
//
// In:  a mesh, a camera, which sides count.
// Out: image points (rounded once to the grid, exactly: the nearest grid point of the exact projection; or, where that is
//      asked for, not at all), the edges between them with the facets on their two sides, and per facet its polygon in the
//      image after clipping.
// Holds (validate(scene) checks it):
//   - points are distinct and in sweep order, so that a smaller PointId is swept earlier; where they are not rounded, the
//     places are;
//   - edges are distinct, top before bottom, sorted by (top, bottom); edges that fall on each other are one edge with
//     all their sides;
//   - for each facet, the winding over its sides adds up to zero at every point: its boundary is closed;
//   - only facets with FacetStatus::in_view have sides.
// Complexity: O(n log n).
// Errors: none; a mesh that builds and a camera that is made can be projected. Only in float and double, where the
// points are not the nearest ones: ArithmeticError.
// Source: Fang 1993, sections 5.2.2-5.2.3 and table 5.1 (window edge coordinates, Sutherland-Hodgman clipping).
// Departures: the clipping is exact, and no near plane is needed: |X| <= W and |Y| <= W leave only the eye itself at
// W = 0, and a facet through the eye is edge-on, hence invisible.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "geometry/mesh/cut_mesh.h"
#include "geometry/numbers/arithmetic.h"
#include "geometry/numbers/export.h"
#include "geometry/numbers/ids.h"
#include "geometry/numbers/image_point.h"
#include "geometry/projection/camera.h"
#include "geometry/projection/exact_place.h"

namespace sightline::inline geometry {

// The facing says which side of the facet's plane the eye is on, exactly.
enum class FacetFacing : std::uint8_t { front, back, edge_on };

// The status says what becomes of a facet. A status that is not listed here does not exist.
enum class FacetStatus : std::uint8_t {
  in_view,      // swept: some of it lies in the view volume
  out_of_view,  // none of it lies in the view volume, or it only touches its border
  edge_on,  // the eye is in its plane, or, of a facet that is snapped to another one's, between both: it shows no area
  culled,   // back-facing, and the scene shows front sides only
};

// The sides say whether back-facing facets are seen and in the way (both) or neither (front).
enum class Sides : std::uint8_t { front, both };

// Crossing the edge from left to right adds `winding` to the facet's winding number; the facet is there where it is not
// 0.
struct EdgeSide {
  FacetId facet;
  std::int32_t winding = 0;
  MeshEdgeId mesh_edge;  // invalid: a cut by the view volume's border
};

struct SceneEdge {
  PointId top;
  PointId bottom;
  std::uint32_t first_side = 0;  // its sides: [first_side, the next edge's first_side)
};

// A corner of a facet's polygon in the view volume is a vertex, or was made by clipping.
struct ClippedCorner {
  PointId point;
  VertexId vertex;        // invalid: made by clipping
  MadeCornerId made;      // invalid: a vertex
  MeshEdgeId edge_after;  // of the edge to the next corner; invalid: along the view volume's border
};

// Clipping made this corner where it cut a facet's border.
struct MadeCorner {
  Point3 position = Point3::Zero();  // in input coordinates
  double weight = 1;                 // its W of the camera
  MeshEdgeId on_edge;                // invalid: inside the facet
  FacetId facet;                     // whose corner it is
  std::uint32_t corner = 0;          // its number among polygon_corners
};

// The points of a scene whose points are not rounded (Arithmetic::unrounded).
struct UnroundedPoints {
  // A point is where a vertex is, or a corner that clipping made.
  struct Source {
    VertexId vertex;
    MadeCornerId made;
    friend bool operator==(const Source&, const Source&) = default;
  };
  std::vector<CertifiedPlace> places;                   // per point
  std::vector<Source> sources;                          // per point
  std::shared_ptr<const std::vector<ExactPlace>> made;  // per made corner of what was projected
};

struct ProjectedScene {
  std::shared_ptr<const CutMesh> surface;  // what was projected; a scene keeps it alive
  Camera camera;
  Sides sides_shown = Sides::both;
  Arithmetic arithmetic = Arithmetic::exact;  // in which vertices were projected, and the stages that follow decide
  int grid_bits = default_grid_bits;

  // Some edges are lines seen in mirrors (reflect/merged_scene.h), and have no sides.
  bool has_mirrored_lines = false;

  std::vector<ImagePoint> points;
  UnroundedPoints unrounded;     // empty on the grid; else `points` has these places on it, in the order of the places
  std::vector<SceneEdge> edges;  // one more than there are edges: the last one only ends the sides
  std::vector<EdgeSide> sides;

  std::vector<FacetFacing> facing;           // per facet
  std::vector<FacetStatus> status;           // per facet
  std::vector<std::uint32_t> polygon_begin;  // per facet and one more, into polygon_corners
  std::vector<ClippedCorner> polygon_corners;
  std::vector<MadeCorner> made_corners;
  std::vector<double> vertex_weights;  // per vertex in the view volume its W of the camera (1 where orthographic)

  // Precondition: the scene was made by `project`.
  [[nodiscard]] const CutMesh& mesh() const { return *surface; }
  [[nodiscard]] std::size_t edge_count() const { return edges.empty() ? 0 : edges.size() - 1; }
  [[nodiscard]] const SceneEdge& edge(EdgeId e) const { return edges[e.index()]; }
  [[nodiscard]] const ImagePoint& point(PointId p) const { return points[p.index()]; }
  [[nodiscard]] bool is_unrounded() const { return arithmetic == Arithmetic::unrounded; }
  [[nodiscard]] std::span<const EdgeSide> sides_of(EdgeId e) const {
    const auto first = edges[e.index()].first_side;
    return std::span(sides).subspan(first, edges[e.index() + 1].first_side - first);
  }
  // The polygon has the orientation of the facet's corners; it is empty unless the status is in_view.
  [[nodiscard]] std::span<const ClippedCorner> polygon(FacetId f) const {
    const auto first = polygon_begin[f.index()];
    return std::span(polygon_corners).subspan(first, polygon_begin[f.index() + 1] - first);
  }
  // Precondition: clipping made it.
  [[nodiscard]] const MadeCorner& made(const ClippedCorner& corner) const { return made_corners[corner.made.index()]; }
  // Returns the mesh edge on which clipping made the corner; invalid where there is none.
  [[nodiscard]] MeshEdgeId cut_edge(const ClippedCorner& corner) const {
    return corner.made.valid() ? made(corner).on_edge : MeshEdgeId{};
  }
};

// Returns a corner in input coordinates; the vertex's own where it is one.
[[nodiscard]] inline const Point3& position_of(const ProjectedScene& scene, const ClippedCorner& corner) {
  return corner.vertex.valid() ? scene.mesh().position(corner.vertex) : scene.made(corner).position;
}

// Returns a corner's W of the camera: its perspective weight.
[[nodiscard]] inline double weight_of(const ProjectedScene& scene, const ClippedCorner& corner) {
  return corner.vertex.valid() ? scene.vertex_weights[corner.vertex.index()] : scene.made(corner).weight;
}

[[nodiscard]] SIGHTLINE_EXPORT ProjectedScene project(std::shared_ptr<const CutMesh> mesh, const Camera& camera,
                                                      Sides sides, const Precision& precision = {});

// The same for a mesh that the scene takes for itself; it is copied unless it is moved.
[[nodiscard]] SIGHTLINE_EXPORT ProjectedScene project(CutMesh mesh, const Camera& camera, Sides sides,
                                                      const Precision& precision = {});

// Returns what of the above does not hold, one line each, with the ids; nothing for a valid scene.
[[nodiscard]] SIGHTLINE_EXPORT std::vector<std::string> validate(const ProjectedScene& scene);

}  // namespace sightline::inline geometry
