// In these extreme scenes the eye is in a special place, or the view volume is extreme.
#include <doctest/doctest.h>

#include "tests/extremes/checked_scene.h"

namespace sightline::tests::extremes_eye_test {
using namespace extremes;

namespace {

using Areas = std::vector<Rational>;

// The faces of a box are, in the order of the files, left, right, bottom, top, back, front; the wall behind is face 6.

}  // namespace

TEST_CASE("extreme scene eye_on_vertex: the three faces at the eye are edge-on") {
  const CheckedScene scene = checked("eye_on_vertex");
  const Sight& straight = scene.from("straight");
  CHECK(is_exact(scene.mesh, straight));
  // At distance 2 the window is 4 wide, and the cube's back, 2 wide, fills its lower left quarter.
  CHECK(straight.areas == Areas{0, 0, 0, 0, 1, 0, 3});
  for (const std::size_t at_eye : {1U, 3U, 5U}) CHECK(straight.view.scene.facing[at_eye] == FacetFacing::edge_on);
  CHECK(total(scene.from("diagonal").areas) == 4);
}

TEST_CASE("extreme scene eye_on_edge: the two faces at the eye are edge-on") {
  const CheckedScene scene = checked("eye_on_edge");
  const Sight& straight = scene.from("straight");
  CHECK(is_exact(scene.mesh, straight));
  // The left half of the window shows the cube's inside: the back, 2 by 2 at distance 2, bottom and top, cut off where
  // they leave the window at distance 1. The right half shows the wall.
  CHECK(straight.areas == Areas{0, 0, Rational(1, 2), Rational(1, 2), 1, 0, 2});
  for (const std::size_t at_eye : {1U, 5U}) CHECK(straight.view.scene.facing[at_eye] == FacetFacing::edge_on);
}

TEST_CASE("extreme scene eye_in_face_plane: beside the face, and within it") {
  const CheckedScene scene = checked("eye_in_face_plane");
  const Sight& beside = scene.from("beside");
  CHECK(is_exact(scene.mesh, beside));
  CHECK(beside.view.scene.facing[1] == FacetFacing::edge_on);
  // The front is 2 by 2 at distance 2, where the window is 4 wide; the wall fills the rest.
  CHECK(beside.areas == Areas{0, 0, 0, 0, 0, 1, 3});
  const Sight& within = scene.from("within");
  CHECK(is_exact(scene.mesh, within));
  CHECK(within.view.scene.facing[5] == FacetFacing::edge_on);
  const Rational side(3, 4);
  CHECK(within.areas == Areas{side, side, side, side, 1, 0, 0});
}

TEST_CASE("extreme scene eye_inside: the cube's back fills the window but for the small cube's front") {
  const CheckedScene scene = checked("eye_inside");
  const Sight& straight = scene.from("straight");
  CHECK(straight.sides == Sides::both);
  CHECK(is_exact(scene.mesh, straight));
  CHECK(straight.areas == Areas{0, 0, 0, 0, 4 - Rational(1, 4), 0, 0, 0, 0, 0, 0, Rational(1, 4)});
  CHECK(total(scene.from("diagonal").areas) == 4);
}

TEST_CASE("extreme scene narrow_field_of_view") {
  const CheckedScene scene = checked("narrow_field_of_view");
  CHECK(total(scene.from("far").areas) > 1);
}

TEST_CASE("extreme scene wide_field_of_view") {
  const CheckedScene scene = checked("wide_field_of_view");
  CHECK(total(scene.from("wide").areas) > Rational(1, 10));
}

TEST_CASE("extreme scene far_over_near: what is too near and too far is not seen") {
  const CheckedScene scene = checked("far_over_near");
  const Sight& deep = scene.from("deep");
  for (const std::size_t f : {0U, 7U}) CHECK(deep.view.scene.status[f] == FacetStatus::out_of_view);
  for (std::size_t f = 1; f < 7; ++f) CHECK(deep.areas[f] > Rational(1, 1000));
}

}  // namespace sightline::tests::extremes_eye_test
