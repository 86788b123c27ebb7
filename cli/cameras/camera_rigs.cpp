#include "cli/cameras/camera_rigs.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "cli/cameras/camera_record.h"
#include "geometry/numbers/errors.h"

namespace sightline::cli {

namespace {

struct Turn {
  double cosine, sine;
};

// The sine and cosine of part / whole turns, where part < whole.
Turn turn_of(std::size_t part, std::size_t whole) {
  const std::size_t quarters = 4 * part / whole;
  const auto rest = static_cast<double>(4 * part % whole) / static_cast<double>(whole);
  const double c = rest == 0 ? 1 : std::cos(rest * (std::numbers::pi / 2));
  const double s = rest == 0 ? 0 : std::sin(rest * (std::numbers::pi / 2));
  if (quarters == 0) return {c, s};
  if (quarters == 1) return {-s, c};
  return quarters == 2 ? Turn{-c, -s} : Turn{s, -c};
}

// Three directions of length 1 at right angles: `along`, and two across it.
struct AxisFrame {
  Vector3 along, first, second;
};

Vector3 least_along(const Vector3& axis) {
  int least = 2;
  for (const int i : {0, 1}) least = std::fabs(axis[i]) < std::fabs(axis[least]) ? i : least;
  return Vector3::Unit(least);
}

AxisFrame axis_frame(const Vector3& axis, const std::optional<Vector3>& start, const char* rig) {
  AxisFrame frame;
  frame.along = unit(axis);
  if (frame.along == Vector3::Zero())
    throw CameraError(fmt::format("the axis of the {} has length zero; give another", rig));
  const Vector3 towards = unit(start.value_or(least_along(frame.along)));
  frame.second = unit(frame.along.cross(towards));
  if (frame.second == Vector3::Zero())
    throw CameraError(fmt::format("the start of the {} is along its axis; choose another", rig));
  frame.first = unit(frame.second.cross(frame.along));
  return frame;
}

ViewPoint view_at(const Point3& eye, const Point3& target, const Vector3& up) {
  ViewPoint view;
  view.eye = eye;
  view.target = target;
  view.up = up;
  return view;
}

// The place of the i-th of n in a row of a length, from its middle.
double place_in_row(std::size_t i, std::size_t n, double length) {
  return n == 1 ? 0 : length * (static_cast<double>(i) / static_cast<double>(n - 1) - 0.5);
}

}  // namespace

std::vector<RigCamera> cameras_of(const Ring& ring) {
  const AxisFrame frame = axis_frame(ring.axis, ring.start, "ring");
  std::vector<RigCamera> cameras;
  for (std::size_t i = 0; i < ring.number; ++i) {
    const Turn turn = turn_of(i, ring.number);
    const Vector3 outwards = turn.cosine * frame.first + turn.sine * frame.second;
    const Point3 eye = ring.center + ring.height * frame.along + ring.radius * outwards;
    cameras.push_back({numbered("ring", i, ring.number), view_at(eye, ring.center, ring.axis)});
  }
  return cameras;
}

// Each has the same share of the sphere's height, and is turned from the one before by the golden angle.
std::vector<RigCamera> cameras_of(const Sphere& sphere) {
  const AxisFrame frame = axis_frame(sphere.axis, std::nullopt, "sphere");
  const double golden_angle = std::numbers::pi * (3 - std::sqrt(5.0));
  std::vector<RigCamera> cameras;
  for (std::size_t i = 0; i < sphere.number; ++i) {
    const double height = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(sphere.number);
    const double across = std::sqrt((1 - height) * (1 + height));
    const double angle = static_cast<double>(i) * golden_angle;
    const Vector3 outwards =
        height * frame.along + across * (std::cos(angle) * frame.first + std::sin(angle) * frame.second);
    cameras.push_back({numbered("sphere", i, sphere.number),
                       view_at(sphere.center + sphere.radius * outwards, sphere.center, sphere.axis)});
  }
  return cameras;
}

std::vector<RigCamera> cameras_of(const Grid& grid) {
  const Vector3 along = grid.target - grid.center;
  const Vector3 right = unit(unit(along).cross(unit(grid.up)));
  if (right == Vector3::Zero()) throw CameraError("the up of the grid is along its view; choose another up or target");
  const Vector3 down = unit(unit(along).cross(right));
  std::vector<RigCamera> cameras;
  for (std::size_t i = 0; i < grid.rows; ++i) {
    const std::string row = numbered("grid", i, grid.rows);
    for (std::size_t j = 0; j < grid.columns; ++j) {
      const Point3 eye = grid.center + place_in_row(j, grid.columns, grid.size[0]) * right +
                         place_in_row(i, grid.rows, grid.size[1]) * down;
      cameras.push_back({numbered(row, j, grid.columns), view_at(eye, grid.target, grid.up)});
      cameras.back().view.direction = along;
    }
  }
  return cameras;
}

}  // namespace sightline::cli
