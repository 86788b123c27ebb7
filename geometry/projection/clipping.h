// Homogeneous clipping, exact.
//
// In:  a facet and a camera.
// Out: the facet's polygon in the view volume as exact homogeneous points, in the facet's orientation.
// Holds: the polygon is convex, with at least three corners that are not all on one line, or empty; a corner on a
// mesh edge is the same exact point whichever facet of that edge it is computed from.
// Precondition: the facet is not edge-on.
// Complexity: six passes over the corners, in integers of any size; meant for the few facets that cross the view
// volume's border.
// Source: Fang 1993, 5.2.3 and table 5.1: window edge coordinates (WEC) and Sutherland-Hodgman.
// Departures: integers instead of equation 5.7 in floating point; points on a bound count as inside, but a facet that
// has nothing strictly inside is out of view.
#pragma once

#include <memory>
#include <vector>

#include "geometry/mesh/cut_mesh.h"
#include "geometry/numbers/image_point.h"
#include "geometry/projection/camera.h"

namespace sightline::inline geometry {

// An exact corner is a point in the camera's homogeneous coordinates and in the input's, over one common positive
// factor of its own: X = x / one, W = w / one, ..., position = (px, py, pz) / one.
struct ExactCorner {
  BigInteger x, y, w, depth;
  BigInteger px, py, pz, one;
  VertexId vertex;        // invalid: made by clipping
  MeshEdgeId edge_after;  // of the edge to the next corner; invalid: along the view volume's border
  MeshEdgeId on_edge;     // the mesh edge that was cut here; invalid: a vertex, or inside the facet

  [[nodiscard]] Point3 position() const;
  [[nodiscard]] double weight() const;  // W
};

[[nodiscard]] std::vector<ExactCorner> clip(const CutMesh& mesh, const Camera& camera, FacetId facet);

// Returns the grid point nearest to the projection of an exact corner, ties away from the window's centre line.
[[nodiscard]] ImagePoint round_to_grid(const ExactCorner& corner, int grid_bits);

// Returns the corner of a facet that one vertex makes, unclipped.
[[nodiscard]] ExactCorner exact_corner(const Point3& vertex, const Camera& camera);
[[nodiscard]] ExactCorner exact_corner(const CutMesh& mesh, VertexId vertex, const Camera& camera);

class CommonScale;

// The same for many vertices: the camera's numbers become integers once, or again where a vertex needs a finer unit. So the
// factor of a corner depends on what was asked before. Not for several threads at once.
class ExactCorners {
 public:
  explicit ExactCorners(const Camera& camera);  // outlives it
  ExactCorners(const ExactCorners&) = delete;
  ExactCorners& operator=(const ExactCorners&) = delete;
  ~ExactCorners();

  [[nodiscard]] ExactCorner of(const CutMesh& mesh, VertexId vertex);

 private:
  const Camera& camera_;
  std::unique_ptr<CommonScale> scale_;
};

// Returns the window edge coordinates of the left, right, bottom, top, near and far bound, each up to a positive
// factor: they are negative outside. A bound that the camera does not have is satisfied.
constexpr std::size_t bound_count = 6;
[[nodiscard]] std::vector<BigInteger> window_edge_coordinates(const Camera& camera, const ExactCorner& corner);

}  // namespace sightline::inline geometry
