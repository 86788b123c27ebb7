// Rigs: cameras at regular places, each called for its place in the rig.
//
// In:  how many, where, around what; directions may have any length but zero. Out: their views. The same input gives
// the same cameras, bit for bit, on every machine whose sine and cosine are the same; quarters of a turn are exact.
//   ring    around an axis through the centre, evenly, all looking at the centre; the first one where `start` points, the others
//           counter-clockwise about the axis. `height`: how far the ring is moved along the axis. ring-01 and so on
//   sphere  about evenly over a sphere, on a spiral from one end of the axis to the other (Fibonacci's lattice): sphere-01
//   grid    in a rectangle around the centre that is perpendicular to the view towards the target, row by row from the top left; all
//           look in the same direction: grid-01-01 is row 1, column 1
// up is the axis, of a grid what is given. Errors: CameraError: a direction of length zero.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "geometry/projection/camera.h"

namespace sightline::cli {

struct RigCamera {
  std::string name;
  ViewPoint view;
};

struct Ring {
  std::size_t number = 1;
  Point3 center = Point3::Zero();
  double radius = 1;
  double height = 0;
  Vector3 axis{0, 1, 0};
  std::optional<Vector3> start;  // else the one of z, x, y that is the least along the axis
};

struct Sphere {
  std::size_t number = 1;
  Point3 center = Point3::Zero();
  double radius = 1;
  Vector3 axis{0, 1, 0};
};

struct Grid {
  std::size_t columns = 1;
  std::size_t rows = 1;
  std::array<double, 2> size{};  // of the rectangle
  Point3 center = Point3::Zero();
  Point3 target = Point3::Zero();
  Vector3 up{0, 1, 0};
};

[[nodiscard]] std::vector<RigCamera> cameras_of(const Ring& ring);
[[nodiscard]] std::vector<RigCamera> cameras_of(const Sphere& sphere);
[[nodiscard]] std::vector<RigCamera> cameras_of(const Grid& grid);

}  // namespace sightline::cli
