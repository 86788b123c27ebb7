// Where what is not rounded in the image is in space, by numbers with bounds.
//
// In:  an unrounded scene, and swap edges, whose ids follow those of the scene's edges; there may be more of them later.
// Out: of an edge of the image the plane through the eye that it is seen as; of a place a point that is seen there; nothing where
//      clipping or cutting made what it takes: a vertex of the input is a double, exactly.
// Method: a scene's edge has two vertices. The plane of a swap edge is the one of the pencil of two facets' planes that has the
//      eye. Such a plane meets a line in space where its forms at two points of it say.
// Complexity: O(1).
// Source: docs/unrounded.md.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/numbers/double_word.h"
#include "sweep/segments/swap_line.h"

namespace sightline::inline sweep {

class SeenInSpace {
 public:
  // Both outlive it.
  SeenInSpace(const ProjectedScene& scene, const std::vector<SwapEdge>& swap_edges);

  // The points P where normal . (P - corner) + offset = 0.
  struct Plane {
    DoubleWordVector normal;
    DoubleWordVector corner;
    DoubleWord offset;

    [[nodiscard]] DoubleWord at(const DoubleWordVector& p) const {
      return dot(normal, DoubleWordVector(p - corner)) + offset;
    }
  };
  using Ends = std::array<Point3, 2>;

  [[nodiscard]] Plane plane_of(FacetId facet) const;
  [[nodiscard]] std::optional<Plane> plane_through_eye(EdgeId e) const;
  // Returns the direction in which the eye sees a point.
  [[nodiscard]] DoubleWordVector direction_to(const DoubleWordVector& p) const;

  [[nodiscard]] std::optional<Ends> ends_of(MeshEdgeId edge) const;
  // Returns where the line through both ends is seen to meet an edge of the image.
  [[nodiscard]] std::optional<DoubleWordVector> meeting(const Ends& ends, EdgeId e) const;
  // Returns a point of one edge that is seen on the other.
  [[nodiscard]] std::optional<DoubleWordVector> crossing(EdgeId a, EdgeId b) const;
  [[nodiscard]] std::optional<DoubleWordVector> vertex(PointId p) const;
  // Returns the place in the image where a point is seen.
  [[nodiscard]] CertifiedPlace place_of(const DoubleWordVector& p) const;
  [[nodiscard]] DoubleWord height_of(const DoubleWordVector& p) const;
  // Returns nothing where the bounds leave a bit of the place open.
  [[nodiscard]] std::optional<Point2> rounded_place_of(const DoubleWordVector& p) const;

 private:
  [[nodiscard]] bool has_perspective() const { return scene_.camera.projection == Projection::perspective; }
  [[nodiscard]] DoubleWord coordinate(const Vector3& row, const DoubleWordVector& p) const;
  [[nodiscard]] std::optional<Ends> ends_of(VertexId a, VertexId b) const;
  [[nodiscard]] std::optional<Ends> ends_of(EdgeId e) const;
  [[nodiscard]] bool is_of_input(VertexId v) const {
    return v.valid() && v.index() < scene_.mesh().input_vertex_count();
  }
  [[nodiscard]] Plane plane_through(const std::array<VertexId, 3>& corners) const;
  [[nodiscard]] Plane plane_of_swap(const SwapEdge& swap) const;
  [[nodiscard]] DoubleWord at_eye(const Plane& plane) const;

  const ProjectedScene& scene_;
  const std::vector<SwapEdge>& swap_edges_;
  DoubleWordVector eye_;  // of a pinhole; the direction of view otherwise
};

}  // namespace sightline::inline sweep
