// Surfaces that are closed, and that are nearly.
#include "reflect/world/closed_surface.h"

#include <doctest/doctest.h>

#include "tests/reflect/mirror_outcome.h"
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

// The eye sees the box's inside, whose walls are before a panel that lies outside.
TEST_CASE("a near plane that opens a closed body leaves both sides of its facets in the way") {
  std::vector<Corners> box;
  for (const double side : {-3.0, 3.0}) {
    for (const int axis : {0, 1, 2}) {
      Corners face;
      for (const auto& [u, v] : {std::pair(-3, -3), std::pair(3, -3), std::pair(3, 3), std::pair(-3, 3)}) {
        Point3 corner = Point3::Zero();
        corner[axis] = side;
        corner[(axis + 1) % 3] = u;
        corner[(axis + 2) % 3] = v;
        face.push_back(corner);
      }
      if (side < 0) std::ranges::reverse(face);
      box.push_back(face);
    }
  }
  ViewPoint from;
  from.eye = {0, 0, 10};
  from.near_distance = 8;
  const Camera camera = perspective_camera("c", from, 30);
  const std::vector<Panel> panels{{"p", {{-9, -9, 20}, {9, -9, 20}, {9, 9, 20}, {-9, 9, 20}}}};
  ReflectionOptions options{ReflectionMode::smooth};
  options.crease_angle_degrees = 10;
  CHECK(reflected(AnyMesh(mesh_of(box)), panels, camera, options).areas[0] == 0);
  CHECK(reflected(AnyMesh(mesh_of({box[2]})), panels, camera, options).areas[0] > 1);
}

}  // namespace sightline::tests::closed_surface_test
