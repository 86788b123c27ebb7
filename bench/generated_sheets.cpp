#include <algorithm>
#include <cmath>
#include <utility>

#include "bench/generated_scenes.h"
#include "bench/scene_parts.h"

namespace sightline::bench {
namespace {

constexpr double sheet_distance = 1.0 / 32;

// Waves of a third of the distance, whose phase differs from sheet to sheet.
void add_vertices(std::vector<Point3>& vertices, std::size_t cells, std::size_t sheet) {
  const auto place = [cells](std::size_t i) { return 2 * static_cast<double>(i) / static_cast<double>(cells) - 1; };
  const auto behind = static_cast<double>(sheet);
  for (std::size_t r = 0; r <= cells; ++r) {
    for (std::size_t c = 0; c <= cells; ++c) {
      const double x = place(c);
      const double y = -place(r);
      const double wave = std::sin(5 * x + behind) * std::cos(4 * y + 2 * behind);
      vertices.push_back(as_in_a_file({x, y, 1 - sheet_distance * (behind + wave / 3)}));
    }
  }
}

}  // namespace

Mesh sheets(std::size_t triangles, std::size_t count, FrontSheet front) {
  const double cells_of_one = static_cast<double>(triangles) / static_cast<double>(2 * count);
  const auto cells = std::max(std::size_t{1}, static_cast<std::size_t>(std::sqrt(cells_of_one)));
  std::vector<Point3> vertices;
  PolygonList faces;
  Random random(triangles);
  for (std::size_t sheet = 0; sheet < count; ++sheet) {
    const std::size_t first = vertices.size();
    add_vertices(vertices, cells, sheet);
    for (std::size_t cell = 0; cell < cells * cells; ++cell) {
      const bool is_hole = front == FrontSheet::leaves && sheet == 0 && random.unit() < 0.5;
      if (!is_hole) add_cell(faces, first + cell / cells * (cells + 1) + cell % cells, cells + 1);
    }
  }
  return build_mesh(std::move(vertices), std::move(faces));
}

}  // namespace sightline::bench
