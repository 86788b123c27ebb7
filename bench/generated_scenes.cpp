#include "bench/generated_scenes.h"

#include <cmath>
#include <numbers>

namespace sightline::bench {
namespace {

void add_triangle(PolygonList& faces, std::size_t a, std::size_t b, std::size_t c) {
  const std::array corners{VertexId(a), VertexId(b), VertexId(c)};
  faces.push_back(corners);
}

Point3 folded_sphere_point(double latitude, double longitude) {
  const double radius = 1 + 0.25 * std::sin(7 * latitude) * std::sin(5 * longitude);
  return {radius * std::sin(latitude) * std::cos(longitude), radius * std::cos(latitude),
          radius * std::sin(latitude) * std::sin(longitude)};
}

// A square of cells * cells cells, each of two triangles; its points are place(x, y) with x and y from -1 to 1.
template <typename Place>
void add_grid(std::vector<Point3>& vertices, PolygonList& faces, std::size_t cells, Place place) {
  const std::size_t first = vertices.size();
  const auto coordinate = [cells](std::size_t i) {
    return 2 * static_cast<double>(i) / static_cast<double>(cells) - 1;
  };
  for (std::size_t r = 0; r <= cells; ++r) {
    for (std::size_t c = 0; c <= cells; ++c) vertices.push_back(place(coordinate(c), coordinate(r)));
  }
  for (std::size_t r = 0; r < cells; ++r) {
    for (std::size_t c = 0; c < cells; ++c) {
      const std::size_t corner = first + r * (cells + 1) + c;
      add_triangle(faces, corner, corner + cells + 1, corner + 1);
      add_triangle(faces, corner + 1, corner + cells + 1, corner + cells + 2);
    }
  }
}

std::size_t cells_of_grid(std::size_t triangles) {
  return static_cast<std::size_t>(std::sqrt(static_cast<double>(triangles) / 2));
}

}  // namespace

// Rings of latitude between two poles; 2 rows * columns triangles, twice as many columns as rows.
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
  std::vector<Point3> vertices;
  PolygonList faces;
  add_grid(vertices, faces, cells_of_grid(triangles), [](double x, double z) {
    return Point3{x, 0.15 * std::sin(9 * x) * std::cos(7 * z) + 0.03 * std::sin(41 * x + 3 * z), z};
  });
  return build_mesh(std::move(vertices), std::move(faces));
}

Mesh sheets(std::size_t triangles, std::size_t count) {
  std::vector<Point3> vertices;
  PolygonList faces;
  for (std::size_t i = 0; i < count; ++i) {
    const double depth = static_cast<double>(i) / static_cast<double>(count);
    add_grid(vertices, faces, cells_of_grid(triangles / count), [depth](double x, double y) {
      return Point3{x, -y, -depth};
    });
  }
  return build_mesh(std::move(vertices), std::move(faces));
}

Camera overview() { return perspective_camera("overview", {{1.5, 1.2, 3.0}, {0, 0, 0}, {0, 1, 0}, 1, {}, {}}, 45); }

Camera grazing_view() {
  return perspective_camera("grazing", {{0.3, 0.5, 2.2}, {0, 0, 0}, {0, 1, 0}, 1.6, {}, {}}, 50);
}

Camera view_from_above() { return perspective_camera("above", {{0.1, 8, 0.2}, {0, 0, 0}, {0, 0, -1}, 1, {}, {}}, 20); }

Camera view_from_the_front() {
  return perspective_camera("front", {{0.3, 0.2, 3.0}, {0, 0, 0}, {0, 1, 0}, 1, {}, {}}, 45);
}

}  // namespace sightline::bench
