// In these extreme scenes faces touch, coincide, are thin or are seen edge-on.
#include <doctest/doctest.h>

#include <algorithm>
#include <utility>

#include "oracle/judging/scene_changes.h"
#include "tests/extremes/checked_scene.h"

namespace sightline::tests::extremes_touching_test {
using namespace extremes;

namespace {

bool is_seen(const View& view, FaceId face) {
  const auto& triangles = view.labelled.triangles;
  return std::any_of(triangles.begin(), triangles.end(),
                     [face](const LabelledTriangle& t) { return t.face == face && t.seen; });
}

Rational sum(const std::vector<Rational>& areas, std::size_t begin, std::size_t end) {
  return total({areas.begin() + static_cast<std::ptrdiff_t>(begin), areas.begin() + static_cast<std::ptrdiff_t>(end)});
}

// Returns the mesh with the faces from begin on, up to end, in the opposite order.
Mesh with_range_reversed(const Mesh& mesh, std::size_t begin, std::size_t end) {
  PolygonList faces;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    faces.push_back(mesh.faces[f >= begin && f < end ? begin + end - 1 - f : f]);
  }
  return build_mesh(mesh.vertices, std::move(faces));
}

}  // namespace

TEST_CASE("extreme scene t_junctions: the wall behind is not seen, though rounding may open a sliver before it") {
  const CheckedScene scene = checked("t_junctions");
  const Sight& above = scene.from("above");
  CHECK(is_exact(scene.mesh, above));
  CHECK(above.areas == std::vector<Rational>{Rational(3, 4), Rational(1, 8), Rational(1, 8), Rational(3, 32),
                                             Rational(3, 32), Rational(3, 32), Rational(3, 32), 0});
  const Sight& tilted = scene.from("tilted");
  CHECK_FALSE(is_exact(scene.mesh, tilted));
  CHECK_FALSE(is_seen(tilted.view, FaceId(7)));
}

TEST_CASE("extreme scene vertices_on_edges") {
  const CheckedScene scene = checked("vertices_on_edges");
  CHECK(is_exact(scene.mesh, scene.from("above")));
  CHECK_FALSE(is_exact(scene.mesh, scene.from("tilted")));
}

TEST_CASE("extreme scene coplanar_tessellations: the lower index hides the higher") {
  const CheckedScene scene = checked("coplanar_tessellations", {.coplanar = true, .large = false});
  const Sight& above = scene.from("above");
  CHECK(is_exact(scene.mesh, above));
  // What is seen is [-1, 1/2]^2 in two triangles, [-1/2, 1]^2 without [-1/2, 1/2]^2, and the rest of [-1, 1]^2.
  CHECK(above.areas[0] == Rational(9, 8));
  CHECK(above.areas[1] == Rational(9, 8));
  CHECK(sum(above.areas, 2, 10) == Rational(9, 4) - 1);
  CHECK(sum(above.areas, 10, 14) == 4 - Rational(9, 4) - Rational(9, 4) + 1);
  for (const auto& range : {std::pair(0, 2), std::pair(2, 10), std::pair(10, 14)}) {
    const auto first = static_cast<std::size_t>(range.first);
    const auto last = static_cast<std::size_t>(range.second);
    CAPTURE(first);
    std::vector<Rational> turned =
        sight(with_range_reversed(scene.mesh, first, last), above.camera, SidesPolicy::both).areas;
    std::reverse(turned.begin() + range.first, turned.begin() + range.second);
    CHECK(turned == above.areas);
  }
}

TEST_CASE("extreme scene boxes_one_ulp_apart: only the nearest of three is seen, from outside and from within") {
  const CheckedScene scene = checked("boxes_one_ulp_apart");
  for (const char* camera : {"outside", "straight"}) {
    CAPTURE(camera);
    const Sight& outside = scene.from(camera);
    CHECK(outside.sides == Sides::front);
    CHECK(sum(outside.areas, 0, 12) == 0);
    CHECK(sum(outside.areas, 12, 18) > Rational(1, 2));
  }
  const Sight& inside = scene.from("inside");
  CHECK(inside.sides == Sides::both);
  CHECK(sum(inside.areas, 0, 6) == 4);
}

TEST_CASE("extreme scene needles: none is wide enough to be called seen, and the square behind loses next to nothing") {
  const CheckedScene scene = checked("needles");
  const Sight& above = scene.from("above");
  const Rational bound = rounding_bound(above.view.scene);
  CHECK(bound < Rational(1, 1000000000));
  for (std::size_t f = 0; f < 16; ++f) {
    CHECK_FALSE(is_seen(above.view, FaceId(f)));
    CHECK(above.areas[f] <= bound);
  }
  CHECK(abs(Rational(above.areas[16] - Rational(9, 4))) <= 2 * bound);
}

TEST_CASE("extreme scene edges_at_a_tiny_angle: stretched, the edges are the window's diagonals") {
  const CheckedScene scene = checked("edges_at_a_tiny_angle");
  const Sight& stretched = scene.from("stretched");
  CHECK(is_exact(scene.mesh, stretched));
  CHECK(stretched.areas == std::vector<Rational>{2, 1});
  // Unstretched, both edges are rounded to the line y = 0.
  CHECK(scene.from("above").areas[1] == 0);
}

TEST_CASE("extreme scene faces_edge_on: plates that are edge-on hide nothing") {
  const CheckedScene scene = checked("faces_edge_on");
  const Sight& above = scene.from("above");
  CHECK(is_exact(scene.mesh, above) == false);  // the leaning plate's upper edge
  CHECK(above.areas[0] == Rational(9, 4));
  for (std::size_t f = 1; f < 6; ++f) CHECK(above.view.scene.facing[f] == FacetFacing::edge_on);
  CHECK(above.view.scene.facing[6] != FacetFacing::edge_on);
  CHECK(above.areas[6] == 0);
  const Sight& pinhole = scene.from("pinhole");
  for (std::size_t f = 1; f < 4; ++f) CHECK(pinhole.view.scene.facing[f] == FacetFacing::edge_on);
  for (std::size_t f = 4; f < 7; ++f) CHECK(pinhole.areas[f] > 0);
}

}  // namespace sightline::tests::extremes_touching_test
