#include <algorithm>
#include <cmath>
#include <utility>

#include "bench/scenes/generated_scenes.h"
#include "bench/scenes/scene_parts.h"

namespace sightline::bench {
namespace {

constexpr double sheet_distance = 1.0 / 32;

struct Grid {
  std::size_t rows = 1;
  std::size_t columns = 1;
};

// The grid is nearly square, with about so many cells.
Grid grid_of(double cells) {
  const double rows = std::max(1.0, std::floor(std::sqrt(cells)));
  return {static_cast<std::size_t>(rows), static_cast<std::size_t>(std::max(1.0, std::round(cells / rows)))};
}

// The place is in [-1, 1].
double place(std::size_t i, std::size_t of) { return 2 * static_cast<double>(i) / static_cast<double>(of) - 1; }

// The waves are a third of the distance high, and their phase differs from sheet to sheet.
void add_vertices(std::vector<Point3>& vertices, const Grid& grid, double behind) {
  for (std::size_t r = 0; r <= grid.rows; ++r) {
    for (std::size_t c = 0; c <= grid.columns; ++c) {
      const double x = place(c, grid.columns);
      const double y = -place(r, grid.rows);
      const double wave = std::sin(5 * x + behind) * std::cos(4 * y + 2 * behind);
      vertices.push_back(as_in_a_file({x, y, 1 - sheet_distance * (behind + wave / 3)}));
    }
  }
}

}  // namespace

Mesh sheets(std::size_t triangles, std::size_t count, FrontSheet front) {
  const Grid grid = grid_of(static_cast<double>(triangles) / static_cast<double>(2 * count));
  const std::size_t row = grid.columns + 1;
  std::vector<Point3> vertices;
  PolygonList faces;
  Random random(triangles);
  for (std::size_t sheet = 0; sheet < count; ++sheet) {
    const std::size_t first = vertices.size();
    add_vertices(vertices, grid, static_cast<double>(sheet));
    for (std::size_t cell = 0; cell < grid.rows * grid.columns; ++cell) {
      const bool is_hole = front == FrontSheet::leaves && sheet == 0 && random.unit() < 0.5;
      if (!is_hole) add_cell(faces, first + cell / grid.columns * row + cell % grid.columns, row);
    }
  }
  return build_mesh(std::move(vertices), std::move(faces));
}

}  // namespace sightline::bench
