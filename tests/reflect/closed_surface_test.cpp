// Surfaces that are closed, and that are nearly.
#include "reflect/world/closed_surface.h"

#include <doctest/doctest.h>

#include "tests/reflect/smooth_bodies.h"

namespace sightline::tests::closed_surface_test {
namespace {

std::optional<Box> closed(const SmoothBody& body) { return box_of_closed(uncrossed(body.mesh())); }

SmoothBody without_face(const SmoothBody& body, std::size_t left_out) {
  SmoothBody result = body;
  result.faces = {};
  for (std::size_t f = 0; f < body.faces.size(); ++f) {
    if (f != left_out) result.faces.push_back(body.faces[f]);
  }
  return result;
}

SmoothBody with_turned_face(const SmoothBody& body) {
  SmoothBody result = without_face(body, 0);
  const auto corners = body.faces[0];
  result.faces.push_back(std::vector<VertexId>(corners.rbegin(), corners.rend()));
  return result;
}

}  // namespace

TEST_CASE("a torus is closed, and in its box; a sphere is, whose poles are many vertices in one place") {
  const std::optional<Box> box = closed(torus(8));
  REQUIRE(box);
  CHECK(box->high.x() == doctest::Approx(1.4));
  CHECK(box->low.z() == doctest::Approx(-0.4));
  CHECK(closed(sphere(6)));
}

TEST_CASE("what lacks a face, or has one turned around, or has ends, is not closed") {
  CHECK(!closed(without_face(torus(8), 3)));
  CHECK(!closed(with_turned_face(torus(8))));
  CHECK(!closed(cylinder(12)));
}

}  // namespace sightline::tests::closed_surface_test
