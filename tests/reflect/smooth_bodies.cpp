#include "tests/reflect/smooth_bodies.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace sightline::tests {
namespace {

constexpr double pi = std::numbers::pi;

// A sheet of rows x columns squares, halved; the columns close.
template <class Place, class Normal>
SmoothBody closed_sheet(int rows, int columns, Place place, Normal normal) {
  SmoothBody body;
  for (int r = 0; r <= rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      const double angle = 2 * pi * c / columns;
      body.vertices.push_back(place(r, angle));
      body.vertex_normals.push_back(normal(r, angle));
    }
  }
  const auto vertex = [&](int r, int c) { return VertexId(static_cast<std::size_t>(r * columns + c % columns)); };
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      body.faces.push_back(std::vector{vertex(r, c), vertex(r, c + 1), vertex(r + 1, c)});
      body.faces.push_back(std::vector{vertex(r, c + 1), vertex(r + 1, c + 1), vertex(r + 1, c)});
    }
  }
  return body;
}

}  // namespace

std::vector<Vector3> SmoothBody::normals() const {
  std::vector<Vector3> result;
  for (const VertexId v : faces.corners) result.push_back(vertex_normals[v.index()]);
  return result;
}

// Rows at the poles are points: the triangles there that have no area are skipped.
SmoothBody sphere(int n) {
  const auto place = [n](int r, double angle) -> Point3 {
    const double latitude = pi * r / n;
    const double radius = r == 0 || r == n ? 0 : std::sin(latitude);
    return {radius * std::cos(angle), radius * std::sin(angle), -std::cos(latitude)};
  };
  return closed_sheet(n, 2 * n, place, place);
}

SmoothBody cylinder(int sides) {
  return closed_sheet(
      1, sides,
      [](int r, double angle) -> Point3 {
        return {std::cos(angle), std::sin(angle), 2.0 * r - 1};
      },
      [](int /*r*/, double angle) -> Vector3 {
        return {std::cos(angle), std::sin(angle), 0};
      });
}

SmoothBody torus(int n) {
  const auto direction = [n](int r, double angle) -> Vector3 {
    const double around = -2 * pi * r / n;
    return {std::cos(around) * std::cos(angle), std::cos(around) * std::sin(angle), -std::sin(around)};
  };
  return closed_sheet(
      n, 2 * n,
      [&](int r, double angle) -> Point3 {
        return Vector3(std::cos(angle), std::sin(angle), 0) + 0.4 * direction(r % n, angle);
      },
      [&](int r, double angle) { return direction(r % n, angle); });
}

Pose random_pose(std::mt19937_64& random) {
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const Eigen::Quaterniond turn(coordinate(random), coordinate(random), coordinate(random), coordinate(random));
  return {turn.normalized().toRotationMatrix(), {coordinate(random), coordinate(random), coordinate(random)}};
}

SmoothBody moved(SmoothBody body, const Pose& pose) {
  for (Point3& p : body.vertices) p = pose(p);
  for (Vector3& n : body.vertex_normals) n = pose.turn * n;
  return body;
}

Camera moved(const ViewPoint& view, double fov_y_degrees, const Pose& pose) {
  ViewPoint result = view;
  result.eye = pose(view.eye);
  result.target = pose(view.target);
  result.up = pose.turn * view.up;
  return perspective_camera("moved", result, fov_y_degrees);
}

Panel moved(Panel panel, const Pose& pose) {
  for (Point3& p : panel.corners) p = pose(p);
  return panel;
}

}  // namespace sightline::tests
