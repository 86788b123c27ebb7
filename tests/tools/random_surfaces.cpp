#include "tests/tools/random_surfaces.h"

#include <array>

#include "oracle/lattice/lattice.h"

namespace sightline::tests {
namespace {

using lattice::Dice;

struct Faces {
  std::vector<Point3> vertices;
  PolygonList list;
};

struct Sheet {
  int cells = 1;  // along each side
  int height = 0;
  int waves = 0;    // 0: flat
  int missing = 0;  // of a hundred squares
};

void add_square(Faces& faces, std::size_t corner, std::size_t row, bool whole) {
  const std::array<VertexId, 4> around{VertexId(corner), VertexId(corner + 1), VertexId(corner + row + 1),
                                       VertexId(corner + row)};
  if (whole) return faces.list.push_back(around);
  faces.list.push_back(std::array{around[0], around[1], around[2]});
  faces.list.push_back(std::array{around[0], around[2], around[3]});
}

// Each sheet is 32 units wide, whatever its cells are.
void add_sheet(Faces& faces, const Sheet& sheet, Dice& dice) {
  const std::size_t first = faces.vertices.size();
  const auto row = static_cast<std::size_t>(sheet.cells) + 1;
  const int size = 32 / sheet.cells;
  for (int y = 0; y <= sheet.cells; ++y) {
    for (int x = 0; x <= sheet.cells; ++x) {
      const int height = sheet.height + dice.between(0, sheet.waves);
      faces.vertices.push_back({x * size - 16.0, y * size - 16.0, static_cast<double>(height)});
    }
  }
  const bool whole = sheet.waves == 0 && dice.one_in(2);
  for (std::size_t y = 0; y + 1 < row; ++y) {
    for (std::size_t x = 0; x + 1 < row; ++x) {
      if (dice.between(1, 100) > sheet.missing) add_square(faces, first + y * row + x, row, whole);
    }
  }
}

void add_large_triangle(Faces& faces, Dice& dice) {
  std::array<VertexId, 3> corners;
  for (VertexId& corner : corners) {
    corner = VertexId(faces.vertices.size());
    const auto place = [&dice](int most) { return static_cast<double>(dice.between(-most, most)); };
    faces.vertices.push_back({place(32), place(32), place(16)});
  }
  faces.list.push_back(corners);
}

Camera camera_above(Dice& dice) {
  ViewPoint view;
  view.eye = {static_cast<double>(dice.between(-8, 8)), static_cast<double>(dice.between(-8, 8)), 64};
  view.target = {0, 0, 0};
  return dice.one_in(2) ? orthographic_camera("above", view, 40) : perspective_camera("above", view, 36);
}

}  // namespace

RandomSurfaces random_surfaces(std::uint64_t seed) {
  Dice dice(seed);
  Faces faces;
  const int sheets = dice.between(2, 4);
  for (int i = 0; i < sheets; ++i) {
    const int waves = dice.one_in(3) ? 0 : dice.between(1, 4);
    const int missing = dice.one_in(2) ? 0 : dice.between(1, 60);
    add_sheet(faces, {1 << dice.between(1, 4), 6 * i - 12, waves, missing}, dice);
  }
  if (dice.one_in(3)) add_large_triangle(faces, dice);
  return {build_mesh(std::move(faces.vertices), std::move(faces.list)), camera_above(dice)};
}

RandomSurfaces crowded_surfaces(std::uint64_t seed) {
  Dice dice(seed);
  Faces faces;
  const int sheets = dice.between(2, 3);
  const auto cells = static_cast<std::size_t>(1 << dice.between(2, 4));
  const double size = 32.0 / static_cast<double>(cells);
  const auto hundredths = [&dice](int most) { return dice.between(-most, most) * 0.01; };
  std::vector<Point3> places;
  for (std::size_t i = 0; i < (cells + 1) * (cells + 1); ++i)
    places.push_back({static_cast<double>(i % (cells + 1)) * size - 16 + hundredths(40),
                      static_cast<double>(i / (cells + 1)) * size - 16 + hundredths(40), hundredths(400)});
  const int spread = dice.between(1, 40);
  for (int sheet = 0; sheet < sheets; ++sheet) {
    const std::size_t first = faces.vertices.size();
    const int waves = dice.between(0, 400);
    for (const Point3& p : places)
      faces.vertices.push_back(
          {p.x() + hundredths(spread), p.y() + hundredths(spread), p.z() + 3.0 * sheet + hundredths(waves)});
    for (std::size_t i = 0; i < cells * cells; ++i)
      add_square(faces, first + i / cells * (cells + 1) + i % cells, cells + 1, false);
  }
  return {build_mesh(std::move(faces.vertices), std::move(faces.list)), camera_above(dice)};
}

}  // namespace sightline::tests
