// Polygons of the image as sheets of paper over the window, and the camera that looks straight down on them: so the
// sweep of the surface finds what polygons cover together, or hide of each other.
//
// In:  polygons with corners on the grid, convex (but for rounding), each at some height.
// Out: a mesh with a face per triangle of their fans, in the order in which they were added. Its coordinates are the
//      grid's, so that projecting it by straight_down() on the same grid rounds nothing.
// Complexity: O(1) per triangle.
#pragma once

#include <vector>

#include "geometry/mesh/cut_mesh.h"
#include "geometry/numbers/image_point.h"
#include "geometry/projection/camera.h"

namespace sightline::inline reflect {

using ImagePolygon = std::vector<ImagePoint>;

class Sheets {
 public:
  explicit Sheets(int grid_bits) : grid_bits_(grid_bits) {}

  void add(const ImagePolygon& polygon, double height);

  [[nodiscard]] std::size_t count() const { return faces_.size(); }  // of triangles
  [[nodiscard]] CutMesh mesh() { return uncrossed(build_mesh(std::move(vertices_), std::move(faces_))); }

 private:
  VertexId corner(const ImagePoint& p, double height);

  int grid_bits_;
  std::vector<Point3> vertices_;
  PolygonList faces_;
};

// The camera looks straight down on the window: a point's image is its own x and y.
[[nodiscard]] Camera straight_down();

}  // namespace sightline::inline reflect
