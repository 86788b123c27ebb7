// Two pieces may neither lie on one side of the other's plane: then what the eye sees of one within the other has to
// decide their order.
#include "sweep/plain/piece_order.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "geometry/cutting/common_lines.h"
#include "tests/tools/analyzed.h"
#include "tests/tools/polygon_mesh.h"

namespace sightline::tests::piece_order_test {
namespace {

// Two triangles pass through each other along the x axis, the rising one for -1.5 < x < 1.5 within the falling one.
// Seen from high z both are counter-clockwise; at their tips, one far above the other, they overlap.
const Corners rising{{-4, -2, -1}, {2, -2, -1}, {0, 6, 3}};
const Corners falling{{4, -2, 1}, {0, 6, -3}, {-2, -2, 1}};

// Small triangles are in upright planes, each of which cuts one of the above before the other one does. So that one
// keeps a piece on both sides of the x axis, left of x = y - 2 and right of x = 2 - y.
const std::vector<Corners> leaning_cutters{{{-3.5, -1.5, -1}, {-2.5, -0.5, -1}, {-3, -1, 1}},
                                           {{3.5, -1.5, 1}, {2.5, -0.5, 1}, {3, -1, -1}}};
// These are left of x = -2 and right of x = 2.
const std::vector<Corners> upright_cutters{{{-2, -1.25, -1}, {-2, -0.75, -1}, {-2, -1, 1}},
                                           {{2, -1.25, 1}, {2, -0.75, 1}, {2, -1, -1}}};

CutMesh cut_mesh(std::vector<Corners> triangles, const std::vector<Corners>& cutters) {
  triangles.insert(triangles.end(), cutters.begin(), cutters.end());
  const Mesh whole = tests::mesh_of(triangles);
  return cut_along_common_lines(whole, find_contacts(whole));
}

bool has_corner_at(const CutMesh& mesh, FacetId f, const Point3& p) {
  return std::ranges::any_of(mesh.corners(f), [&](VertexId v) { return mesh.position(v) == p; });
}

// Returns the piece with this corner; both of the planes part space at y = 0, and it must be on either side.
FacetId straddling_piece_at(const CutMesh& mesh, const Point3& p) {
  for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
    if (!has_corner_at(mesh, FacetId(f), p)) continue;
    const auto corners = mesh.corners(FacetId(f));
    const bool reaches_up = std::ranges::any_of(corners, [&](VertexId v) { return mesh.position(v).y() > 0; });
    const bool reaches_down = std::ranges::any_of(corners, [&](VertexId v) { return mesh.position(v).y() < 0; });
    if (reaches_up && reaches_down) return FacetId(f);
  }
  FAIL("the scene has no such piece");
  return {};
}

ViewPoint from_height(double z) { return {{0, 0, z}, {0, 0, 0}, {0, 1, 0}, 1, {}, {}}; }
Camera pinhole_at(double z) { return perspective_camera("pinhole", from_height(z), 60); }
Camera level_at(double z) { return orthographic_camera("level", from_height(z), 16); }

}  // namespace

TEST_CASE(
    "pieces that straddle each other's planes: the upper tip is before the lower one, from above and from below") {
  for (const bool rising_first : {true, false}) {
    const CutMesh mesh =
        cut_mesh(rising_first ? std::vector{rising, falling} : std::vector{falling, rising}, leaning_cutters);
    const FacetId upper = straddling_piece_at(mesh, {0, 6, 3});
    const FacetId lower = straddling_piece_at(mesh, {0, 6, -3});
    REQUIRE((upper < lower) == rising_first);
    for (const double z : {20.0, -20.0}) {
      for (const Camera& camera : {pinhole_at(z), level_at(z)}) {
        CAPTURE(rising_first);
        CAPTURE(z);
        CAPTURE(camera.name);
        const ProjectedScene scene = project(mesh, camera, Sides::both);
        PieceOrder order(scene);
        REQUIRE(order.applies_to(UncutFacetId(0), UncutFacetId(1)));
        CHECK(order.lower_is_nearer(std::min(upper, lower), std::max(upper, lower)) == (rising_first == (z > 0)));
      }
    }
  }
}

TEST_CASE("pieces that straddle each other's planes and overlap nowhere: the lower index is in front") {
  for (const bool rising_first : {true, false}) {
    const CutMesh mesh =
        cut_mesh(rising_first ? std::vector{rising, falling} : std::vector{falling, rising}, upright_cutters);
    const FacetId left = straddling_piece_at(mesh, {-4, -2, -1});
    const FacetId right = straddling_piece_at(mesh, {4, -2, 1});
    REQUIRE((left < right) == rising_first);
    for (const Camera& camera : {pinhole_at(20), level_at(20), pinhole_at(-20), level_at(-20)}) {
      CAPTURE(rising_first);
      CAPTURE(camera.name);
      const ProjectedScene scene = project(mesh, camera, Sides::both);
      PieceOrder order(scene);
      CHECK(order.lower_is_nearer(std::min(left, right), std::max(left, right)));
    }
  }
}

}  // namespace sightline::tests::piece_order_test
