#include "bench/scenes/generated_scenes.h"

#include <cmath>
#include <numbers>

#include "bench/scenes/scene_parts.h"

namespace sightline::bench {
namespace {

Point3 folded_sphere_point(double latitude, double longitude) {
  const double radius = 1 + 0.25 * std::sin(7 * latitude) * std::sin(5 * longitude);
  return as_in_a_file({radius * std::sin(latitude) * std::cos(longitude), radius * std::cos(latitude),
                       radius * std::sin(latitude) * std::sin(longitude)});
}

}  // namespace

// The sphere has rings of latitude between two poles; these are 2 rows * columns triangles, with twice as many columns
// as rows.
Mesh folded_sphere(std::size_t triangles) {
  const auto rows = static_cast<std::size_t>(std::sqrt(static_cast<double>(triangles) / 4));
  const std::size_t columns = 2 * rows;
  std::vector<Point3> vertices{{0, 1, 0}, {0, -1, 0}};
  for (std::size_t r = 1; r < rows; ++r) {
    for (std::size_t c = 0; c < columns; ++c) {
      vertices.push_back(
          folded_sphere_point(std::numbers::pi * static_cast<double>(r) / static_cast<double>(rows),
                              2 * std::numbers::pi * static_cast<double>(c) / static_cast<double>(columns)));
    }
  }
  const auto at = [columns](std::size_t r, std::size_t c) { return 2 + (r - 1) * columns + c % columns; };
  PolygonList faces;
  for (std::size_t c = 0; c < columns; ++c) {
    add_triangle(faces, 0, at(1, c + 1), at(1, c));
    add_triangle(faces, 1, at(rows - 1, c), at(rows - 1, c + 1));
    for (std::size_t r = 1; r + 1 < rows; ++r) {
      add_triangle(faces, at(r, c), at(r, c + 1), at(r + 1, c));
      add_triangle(faces, at(r, c + 1), at(r + 1, c + 1), at(r + 1, c));
    }
  }
  return build_mesh(std::move(vertices), std::move(faces));
}

Mesh terrain(std::size_t triangles) {
  const auto cells = static_cast<std::size_t>(std::sqrt(static_cast<double>(triangles) / 2));
  std::vector<Point3> vertices;
  for (std::size_t r = 0; r <= cells; ++r) {
    for (std::size_t c = 0; c <= cells; ++c) {
      const double x = 2 * static_cast<double>(c) / static_cast<double>(cells) - 1;
      const double z = 2 * static_cast<double>(r) / static_cast<double>(cells) - 1;
      const double y = 0.15 * std::sin(9 * x) * std::cos(7 * z) + 0.03 * std::sin(41 * x + 3 * z);
      vertices.push_back(as_in_a_file({x, y, z}));
    }
  }
  PolygonList faces;
  for (std::size_t r = 0; r < cells; ++r) {
    for (std::size_t c = 0; c < cells; ++c) add_cell(faces, r * (cells + 1) + c, cells + 1);
  }
  return build_mesh(std::move(vertices), std::move(faces));
}

Camera overview() { return perspective_camera("overview", {{1.5, 1.2, 3.0}, {0, 0, 0}, {0, 1, 0}, 1, {}, {}}, 45); }

Camera grazing_view() {
  return perspective_camera("grazing", {{0.3, 0.5, 2.2}, {0, 0, 0}, {0, 1, 0}, 1.6, {}, {}}, 50);
}

// The eye is beside the axis, so that vertices of grids one behind the other do not fall on each other.
Camera view_into_box() {
  return perspective_camera("into the box", {{0.0513, 0.0287, 4}, {0, 0, 0}, {0, 1, 0}, 1, {}, {}}, 38);
}

Camera view_from_above() { return perspective_camera("above", {{0.1, 8, 0.2}, {0, 0, 0}, {0, 0, -1}, 1, {}, {}}, 20); }

}  // namespace sightline::bench
