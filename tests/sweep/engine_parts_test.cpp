// The parts of the fast engine are tested, each by itself.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <random>
#include <set>

#include "sweep/bands/scene_part.h"
#include "sweep/engine.h"
#include "sweep/fast/covers.h"
#include "sweep/fast/large_covers.h"
#include "sweep/fast/roles.h"
#include "sweep/plain/depth_ranges.h"
#include "tests/tools/analyzed.h"

namespace sightline::tests::engine_parts_test {
namespace {

constexpr unsigned seed = 20261126;

using Faces = std::vector<std::vector<std::uint32_t>>;

// The sheets are cells x cells squares, each two triangles, parallel to the image: at these depths, with these half
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
  return build_mesh(std::move(vertices), std::move(list));
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

ProjectedScene seen_from_above(const AnyMesh& mesh, int grid_bits = default_grid_bits) {
  ViewPoint view;
  view.eye = {0, 0, 1};
  view.target = {0, 0, 0};
  return project(mesh, orthographic_camera("above", view, 2), Sides::both, {Arithmetic::exact, grid_bits});
}

// This is what the fast engine finds before it sweeps, in 32 x 32 cells, where covers have to find all that is hidden.
struct Found {
  SceneInCells in;
  Covers covers;

  explicit Found(const ProjectedScene& scene)
      : in(scene, 5, std::vector<std::uint8_t>(scene.status.size(), 0)), covers(find_covers(in)) {}

  [[nodiscard]] std::vector<Role> roles() const { return find_roles(in, covers); }
};

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
    const auto corner = [&]() -> Vector3 { return middle + size * Vector3{place(random), place(random), 0}; };
    const Mesh mesh = mesh_of({corner(), corner(), corner()}, {{0, 1, 2}});
    const ProjectedScene scene = seen_from_above(mesh, 12);
    if (scene.status.empty() || scene.status[0] != FacetStatus::in_view) continue;
    const CellGrid grid(scene.grid_bits, round % 6);
    const Continuation continuation(scene);
    const CellSides sides(scene);
    const FacetCells cells(scene, sides, continuation, grid, {0});
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
          inside = inside && orientation(a, b, c) * (scene.facing[0] == FacetFacing::back ? -1 : 1) >= 0;
        }
        if (inside) CHECK(named.contains(grid.cell(column, row)));
        for (const FacetCell& cell : cells.of(FacetId(0))) {
          if (cell.cell() != grid.cell(column, row)) continue;
          CHECK(cell.over_centre() == (inside || !continuation.is_proper(FacetId(0))));
          over_centre += inside ? 1 : 0;
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

TEST_CASE("cells: there are not many more than facets, however small these are in the image") {
  for (const double half_width : {1.0, 1e-2, 1e-5}) {
    const ProjectedScene scene = seen_from_above(sheets({{1, half_width, 1}, {2, half_width, 4}}));
    const SceneInCells in(scene, std::nullopt);
    CAPTURE(half_width);
    CHECK(in.grid.cell_count() >= 16);
    CHECK(in.grid.cell_count() <= 64 * scene.status.size());
  }
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
  const auto hidden = hidden_behind_large_facets(scene, CellSides(scene), depth_ranges(scene));
  // Along the diagonal of the first sheet no single facet covers the cells.
  const auto of_sheet = [&](std::size_t begin, std::size_t end) {
    return count_of(
        {hidden.begin() + static_cast<std::ptrdiff_t>(begin), hidden.begin() + static_cast<std::ptrdiff_t>(end)});
  };
  CHECK(of_sheet(0, 2) == 0);
  // Two are left in each of eight squares, and two more at each corner of these that is inside the sheet.
  CHECK(of_sheet(2, 130) == 128 - 16 - 14);
  CHECK(of_sheet(130, 258) < 128);
  CHECK(of_sheet(130, 258) > 0);
}

TEST_CASE("covers: sheets behind a sheet are hidden, whatever their borders are, and what looks out is not") {
  const Mesh mesh = sheets({{1, 0.8137, 16}, {2, 0.4871, 7}, {3, 0.9, 9}});
  const ProjectedScene scene = seen_from_above(mesh);
  const std::vector<std::uint8_t> hidden = Found(scene).covers.hidden;
  const VisibleSegments full = plain_sweep(scene);
  for (const VisibleSegment& s : full.segments) CHECK(hidden[s.facet.index()] == 0);
  CHECK(count_of({hidden.begin(), hidden.begin() + 512}) == 0);
  CHECK(count_of({hidden.begin() + 512, hidden.begin() + 512 + 98}) == 98);
  CHECK(count_of({hidden.begin() + 610, hidden.end()}) > 0);
}

// Tilted, sheets have no depth between them, but their facets have an order.
TEST_CASE("covers: sheets without a depth between them hide by their order") {
  const Mesh level = sheets({{1, 0.9137, 16}, {1.01, 0.8871, 15}});
  std::vector<Point3> vertices = level.vertices;
  for (Point3& p : vertices) p.z() += p.x();
  const Mesh tilted = build_mesh(std::move(vertices), level.faces);
  const ProjectedScene scene = seen_from_above(tilted);
  const std::vector<std::uint8_t> hidden = Found(scene).covers.hidden;
  CHECK(count_of({hidden.begin(), hidden.begin() + 512}) == 0);
  CHECK(count_of({hidden.begin() + 512, hidden.end()}) > 450 / 2);
  for (const VisibleSegment& s : plain_sweep(scene).segments) CHECK(hidden[s.facet.index()] == 0);
}

TEST_CASE("roles: the inside of a sheet is plain, its border is open") {
  const Mesh mesh = sheets({{1, 0.8, 16}});
  const ProjectedScene scene = seen_from_above(mesh);
  const std::vector<Role> roles = Found(scene).roles();
  const auto plain = std::ranges::count(roles, Role::plain);
  CHECK(plain > 256);
  CHECK(plain < 512 - 64);
  CHECK(std::ranges::count(roles, Role::open) == 512 - plain);
}

TEST_CASE("roles: beside a hidden facet of the sheet none is plain") {
  const Mesh mesh = sheets({{1, 0.8, 16}});
  const ProjectedScene scene = seen_from_above(mesh);
  Found found(scene);
  const FacetId hidden(256 + 16);
  found.covers.hidden[hidden.index()] = 1;
  const std::vector<Role> roles = found.roles();
  CHECK(roles[hidden.index()] == Role::hidden);
  std::size_t beside = 0;
  for (const EdgeId e : found.in.continuation.edges_of(scene, hidden)) {
    for (const EdgeSide& side : scene.sides_of(e)) {
      if (side.facet == hidden) continue;
      CHECK(roles[side.facet.index()] == Role::open);
      ++beside;
    }
  }
  CHECK(beside == 3);
}

// What is left of the common border is hidden, and four segments run around the rest.
TEST_CASE("engines: a facet between two sheets whose borders fall on each other") {
  const Mesh mesh = mesh_of({{-0.9, -0.9, -1},
                             {0, -0.9, -1},
                             {0, 0.9, -1},
                             {-0.9, 0.9, -1},
                             {0.9, -0.9, -3},
                             {0.9, 0.9, -3},
                             {0, 0.9, -3},
                             {0, -0.9, -3},
                             {-0.01, 0, -2},
                             {0.01, -0.01, -2},
                             {0.01, 0.01, -2}},
                            {{0, 1, 2, 3}, {4, 5, 6, 7}, {8, 9, 10}});
  const ProjectedScene scene = seen_from_above(mesh);
  const Continuation continuation(scene);
  for (std::size_t e = 0; e < scene.edge_count(); ++e) CHECK(continuation.is_contour(EdgeId(e)));
  for (const int level : {1, 2, 3, 4}) {
    const auto segments = fast_visible_segments(scene, {level, 1}).segments;
    CHECK(std::ranges::count(segments, FacetId(2), &VisibleSegment::facet) == 4);
  }
}

TEST_CASE("continuation: a sliver that rounding makes a line has contour edges, and its sheet a slit") {
  const Mesh mesh = mesh_of({{-0.5, 0, -1}, {0.5, 0, -1}, {0.1, 1e-15, -1}, {0, 0.5, -1}, {0, -0.5, -1}},
                            {{0, 1, 2}, {0, 2, 3}, {2, 1, 3}, {0, 4, 1}});
  const ProjectedScene scene = seen_from_above(mesh);
  const Continuation continuation(scene);
  REQUIRE(mesh.facet_count() == 4);
  CHECK_FALSE(continuation.is_proper(FacetId(0)));
  std::size_t contours = 0;
  for (std::size_t e = 0; e < scene.edge_count(); ++e) contours += continuation.is_contour(EdgeId(e)) ? 1 : 0;
  CHECK(scene.edge_count() == 8);
  CHECK(contours == 7);
  for (const int level : {0, 3, 6}) {
    for (const VisibleSegment& s : fast_visible_segments(scene, {level, 1}).segments) CHECK(s.facet != FacetId(0));
  }
}

// Two squares overlap at their corners. Behind both lies a triangle, with a corner where their borders cross.
TEST_CASE("scene parts: a crossing of the part may be a vertex of the whole") {
  const Mesh mesh = mesh_of({{-0.5, -0.5, -1},
                             {0.25, -0.5, -1},
                             {0.25, 0.25, -1},
                             {-0.5, 0.25, -1},
                             {-0.25, -0.25, -2},
                             {0.5, -0.25, -2},
                             {0.5, 0.5, -2},
                             {-0.25, 0.5, -2},
                             {0.25, -0.25, -3},
                             {0.125, 0, -3},
                             {0, 0, -3}},
                            {{0, 1, 2, 3}, {4, 5, 6, 7}, {8, 9, 10}});
  const ProjectedScene whole = seen_from_above(mesh);
  const std::array<FacetId, 2> kept{FacetId(0), FacetId(1)};
  const ScenePart part = part_of(whole, Continuation(whole), kept);
  CHECK(part.point.size() == 8);
  const VisibleSegments of_part = plain_sweep(part.scene);
  CHECK(of_part.crossings.size() == 2);
  const VisibleSegments found = in_whole(whole, part, of_part);
  const VisibleSegments expected = plain_sweep(whole);
  CHECK(found.crossings.size() == 1);
  CHECK(expected.crossings.size() == 1);
  const auto ends = [](const VisibleSegments& segments) {
    std::vector<std::array<PointId, 2>> all;
    for (const VisibleSegment& s : segments.segments) all.push_back({s.start, s.end});
    return all;
  };
  CHECK(ends(found) == ends(expected));
}

TEST_CASE("engines: in double, everything is swept") {
  const Mesh mesh = sheets({{1, 0.8, 16}, {2, 0.5, 7}});
  ProjectedScene scene = seen_from_above(mesh);
  const std::uint64_t all = plain_sweep(scene).statistics.sweep_points;
  CHECK(fast_visible_segments(scene, {5, 1}).statistics.sweep_points < all);
  scene.arithmetic = Arithmetic::double_precision;
  CHECK(fast_visible_segments(scene, {5, 1}).statistics.sweep_points == all);
}

}  // namespace sightline::tests::engine_parts_test
