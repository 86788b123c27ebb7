// The parts of the fast engine, each by itself.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <random>
#include <set>

#include "geometry/common_lines.h"
#include "geometry/interpenetration.h"
#include "sweep/covers.h"
#include "sweep/depth_ranges.h"
#include "sweep/engine.h"
#include "sweep/large_covers.h"
#include "sweep/patches.h"

namespace sightline {
namespace {

constexpr unsigned seed = 20261126;

using Faces = std::vector<std::vector<std::uint32_t>>;

// Square sheets of cells x cells squares, each two triangles, parallel to the image: at these depths, with these half
// widths.
struct Sheet {
  double depth = 0;
  double half_width = 0;
  std::uint32_t cells = 1;
};

Mesh mesh_of(std::vector<Point3> vertices, const Faces& faces) {
  PolygonList list;
  for (const auto& face : faces) {
    std::vector<VertexId> corners;
    for (const std::uint32_t corner : face) corners.emplace_back(corner);
    list.push_back(corners);
  }
  Mesh mesh = build_mesh(std::move(vertices), std::move(list));
  const MeshContacts contacts = find_contacts(mesh);
  return cut_along_common_lines(std::move(mesh), contacts);
}

Mesh sheets(const std::vector<Sheet>& all) {
  std::vector<Point3> vertices;
  Faces faces;
  for (const auto& [depth, half, cells] : all) {
    const auto first = static_cast<std::uint32_t>(vertices.size());
    for (std::uint32_t row = 0; row <= cells; ++row) {
      for (std::uint32_t column = 0; column <= cells; ++column) {
        vertices.push_back({half * (2.0 * column / cells - 1), half * (2.0 * row / cells - 1), -depth});
      }
    }
    for (std::uint32_t row = 0; row < cells; ++row) {
      for (std::uint32_t column = 0; column < cells; ++column) {
        const std::uint32_t a = first + row * (cells + 1) + column;
        faces.push_back({a, a + 1, a + cells + 2});
        faces.push_back({a, a + cells + 2, a + cells + 1});
      }
    }
  }
  return mesh_of(std::move(vertices), faces);
}

ProjectedScene seen_from_above(const Mesh& mesh, int grid_bits = default_grid_bits) {
  ViewPoint view;
  view.eye = {0, 0, 1};
  view.target = {0, 0, 0};
  return project(mesh, orthographic_camera("above", view, 2), Sides::both, {Arithmetic::exact, grid_bits});
}

std::size_t count_of(const std::vector<std::uint8_t>& flags) {
  return static_cast<std::size_t>(std::ranges::count(flags, 1));
}

}  // namespace

TEST_CASE("facet cells: every cell in which a point of the facet lies is named, and the centres it is over") {
  INFO("seed ", seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-1.3, 1.3);
  std::size_t cells_met = 0;
  std::size_t over_centre = 0;
  for (int round = 0; round < 300; ++round) {
    const double size = std::ldexp(1.0, -(round % 8));
    const Point3 middle{place(random), place(random), 0};
    const auto corner = [&] { return middle + size * Vector3{place(random), place(random), 0}; };
    const Mesh mesh = mesh_of({corner(), corner(), corner()}, {{0, 1, 2}});
    const ProjectedScene scene = seen_from_above(mesh, 12);
    if (scene.status.empty() || scene.status[0] != Status::in_view) continue;
    const CellGrid grid(scene.grid_bits, round % 6);
    const FacetCells cells(scene, grid, {0});
    std::set<CellIndex> named;
    for (const FacetCell& cell : cells.of(FacetId(0))) named.insert(cell.cell());
    const auto polygon = scene.polygon(FacetId(0));
    for (unsigned row = 0; row < grid.side(); ++row) {
      for (unsigned column = 0; column < grid.side(); ++column) {
        const ImagePoint c = grid.centre(column, row);
        bool inside = true;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
          const ImagePoint& a = scene.point(polygon[i].point);
          const ImagePoint& b = scene.point(polygon[(i + 1) % polygon.size()].point);
          inside = inside && orientation(a, b, c) * (scene.facing[0] == Facing::back ? -1 : 1) >= 0;
        }
        if (inside) CHECK(named.contains(grid.cell(column, row)));
        for (const FacetCell& cell : cells.of(FacetId(0))) {
          if (cell.cell() == grid.cell(column, row) && cell.over_centre()) {
            CHECK(inside);
            ++over_centre;
          }
        }
      }
    }
    for (const ClippedCorner& corner_of_polygon : polygon) {
      const ImagePoint& p = scene.point(corner_of_polygon.point);
      const CellRange range = grid.range_of(std::array{p});
      CellGrid::for_each(range, [&](unsigned column, unsigned row) {
        CHECK(named.contains(grid.cell(column, row)));
        ++cells_met;
        return true;
      });
    }
  }
  CHECK(cells_met > 500);
  CHECK(over_centre > 500);
}

TEST_CASE("cell grid: a point on the line between cells touches both, and one on the window's border the last") {
  const CellGrid grid(8, 2);
  const CellRange corner = grid.range_of(std::array{ImagePoint{0, 0}});
  CHECK(corner.left == 1);
  CHECK(corner.right == 2);
  CHECK(corner.bottom == 1);
  CHECK(corner.top == 2);
  const CellRange border = grid.range_of(std::array{ImagePoint{256, -256}});
  CHECK(border.left == 3);
  CHECK(border.right == 3);
  CHECK(border.bottom == 0);
  CHECK(border.top == 0);
}

TEST_CASE("continuation: inside a sheet every edge continues it, and its border is contour") {
  const Mesh mesh = sheets({{1, 0.9, 4}});
  const ProjectedScene scene = seen_from_above(mesh);
  const Continuation continuation(scene);
  std::size_t contours = 0;
  for (std::size_t e = 0; e < scene.edge_count(); ++e) {
    contours += continuation.is_contour(EdgeId(e)) ? 1 : 0;
    if (continuation.is_contour(EdgeId(e))) continue;
    CHECK(continuation.across(EdgeId(e)).left != continuation.across(EdgeId(e)).right);
  }
  CHECK(contours == 16);
}

TEST_CASE("continuation: where edges of two sheets fall on each other, neither continues") {
  const Mesh mesh = sheets({{1, 0.5, 2}, {2, 0.5, 2}});
  const ProjectedScene scene = seen_from_above(mesh);
  const Continuation continuation(scene);
  for (std::size_t e = 0; e < scene.edge_count(); ++e) CHECK(continuation.is_contour(EdgeId(e)));
}

TEST_CASE("large covers: what lies behind one large facet is hidden, what looks out is not") {
  const Mesh mesh = sheets({{1, 0.8, 1}, {2, 0.5, 8}, {3, 0.9, 8}});
  const ProjectedScene scene = seen_from_above(mesh);
  const auto hidden = hidden_behind_large_facets(scene, depth_ranges(scene));
  // Along the diagonal of the first sheet no single facet covers the cells.
  const auto of_sheet = [&](std::size_t begin, std::size_t end) {
    return count_of(
        {hidden.begin() + static_cast<std::ptrdiff_t>(begin), hidden.begin() + static_cast<std::ptrdiff_t>(end)});
  };
  CHECK(of_sheet(0, 2) == 0);
  // Two in each of eight squares, and two more at each corner of these that is inside the sheet.
  CHECK(of_sheet(2, 130) == 128 - 16 - 14);
  CHECK(of_sheet(130, 258) < 128);
  CHECK(of_sheet(130, 258) > 0);
}

TEST_CASE("covers: sheets behind a sheet are hidden, whatever their borders are, and what looks out is not") {
  const Mesh mesh = sheets({{1, 0.8137, 16}, {2, 0.4871, 7}, {3, 0.9, 9}});
  const ProjectedScene scene = seen_from_above(mesh);
  const CellGrid grid(scene.grid_bits, 5);
  const std::vector<std::uint8_t> none(mesh.facet_count(), 0);
  const FacetCells cells(scene, grid, none);
  const auto hidden = hidden_behind_covers(mesh, scene, depth_ranges(scene), Continuation(scene), grid, cells, none);
  const VisibleSegments full = sweep(mesh, scene);
  for (const VisibleSegment& s : full.segments) CHECK(hidden[s.facet.index()] == 0);
  CHECK(count_of({hidden.begin(), hidden.begin() + 512}) == 0);
  // All but those at the sheets' common diagonal, where no facet is over the centres of the cells.
  CHECK(count_of({hidden.begin() + 512, hidden.begin() + 512 + 98}) == 98 - 14 - 12);
  CHECK(count_of({hidden.begin() + 610, hidden.end()}) > 0);
}

// Tilted against each other, sheets have no common depth between them, but an order over every cell's centre.
TEST_CASE("covers: sheets without a depth between them hide by their order") {
  const Mesh level = sheets({{1, 0.9137, 16}, {1.01, 0.8871, 15}});
  std::vector<Point3> vertices = level.vertices;
  for (Point3& p : vertices) p.z += p.x;
  Mesh tilted = build_mesh(std::move(vertices), level.faces);
  const MeshContacts contacts = find_contacts(tilted);
  tilted = cut_along_common_lines(std::move(tilted), contacts);
  const ProjectedScene scene = seen_from_above(tilted);
  const CellGrid grid(scene.grid_bits, 5);
  const std::vector<std::uint8_t> none(tilted.facet_count(), 0);
  const FacetCells cells(scene, grid, none);
  const auto hidden = hidden_behind_covers(tilted, scene, depth_ranges(scene), Continuation(scene), grid, cells, none);
  CHECK(count_of({hidden.begin(), hidden.begin() + 512}) == 0);
  CHECK(count_of({hidden.begin() + 512, hidden.end()}) > 450 / 2);
  for (const VisibleSegment& s : sweep(tilted, scene).segments) CHECK(hidden[s.facet.index()] == 0);
}

TEST_CASE("patches: the inside of a sheet is one patch, its border is open, and touched facets are never plain") {
  Mesh mesh = sheets({{1, 0.8, 16}});
  const ProjectedScene scene = seen_from_above(mesh);
  const CellGrid grid(scene.grid_bits, 5);
  const std::vector<std::uint8_t> none(mesh.facet_count(), 0);
  const FacetCells cells(scene, grid, none);
  const Continuation continuation(scene);
  const Patches patches = find_patches(mesh, scene, continuation, none, grid, cells);
  CHECK(patches.patch_count == 1);
  const auto plain = std::ranges::count(patches.role, Role::plain);
  CHECK(plain > 256);
  CHECK(plain < 512 - 64);
  CHECK(std::ranges::count(patches.role, Role::open) == 512 - plain);
  mesh.touched.assign(mesh.facet_count(), 1);
  CHECK(find_patches(mesh, scene, continuation, none, grid, cells).patch_count == 0);
}

TEST_CASE("engines: without knowledge of contacts, and in double, everything is swept") {
  Mesh mesh = sheets({{1, 0.8, 16}, {2, 0.5, 7}});
  const ProjectedScene scene = seen_from_above(mesh);
  const std::uint64_t all = sweep(mesh, scene).statistics.sweep_points;
  CHECK(fast_visible_segments(mesh, scene, {5, 1}).statistics.sweep_points < all);
  mesh.touched.clear();
  CHECK(fast_visible_segments(mesh, scene, {5, 1}).statistics.sweep_points == all);
}

}  // namespace sightline
