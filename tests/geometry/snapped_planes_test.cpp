// Which faces get one plane, and whose.
#include "geometry/cutting/snapped_planes.h"

#include <doctest/doctest.h>

#include "tests/tools/polygon_mesh.h"

namespace sightline::tests::snapped_planes_test {
namespace {

constexpr double distance = 1e-9;

Corners square(double from, double size, double height) {
  return {{from, 0, height}, {from + size, 0, height}, {from + size, size, height}, {from, size, height}};
}

Corners triangle(double from, double height) { return {{from, 0, height}, {from + 2, 0, height}, {from, 2, height}}; }

// Per face the face whose plane its first facet has; nothing where nothing is snapped.
std::vector<std::uint32_t> planes(const std::vector<Corners>& faces, double within = distance) {
  CutMesh mesh = uncrossed(mesh_of(faces));
  mesh.snapped_to = snapped_planes(mesh, within);
  CHECK(validate(mesh).empty());
  std::vector<std::uint32_t> result;
  if (mesh.snapped_to.empty()) return result;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const UncutFacetId plane = mesh.plane_of(UncutFacetId(mesh.first_facet(FaceId(f))));
    result.push_back(mesh.facet_face[plane.index()].value);
  }
  return result;
}

using Planes = std::vector<std::uint32_t>;

}  // namespace

TEST_CASE("the largest face lends its plane, whatever its number") {
  CHECK(planes({square(0, 2, 1e-10), square(0, 4, 0), square(0, 3, -1e-10)}) == Planes{1, 1, 1});
  CHECK(planes({square(0, 4, 0), square(0, 2, 1e-10)}) == Planes{0, 0});
}

TEST_CASE("faces in one plane, and faces that do not overlap, have their own") {
  CHECK(planes({square(0, 4, 0), square(1, 2, 0)}).empty());
  CHECK(planes({square(0, 4, 0), square(4, 4, 1e-10)}).empty());
  CHECK(planes({square(0, 4, 0), square(1, 2, 2e-9)}).empty());
  CHECK(planes({square(0, 4, 0), square(1, 2, 1e-10)}, 0).empty());
}

TEST_CASE("what is in one plane with a face that is snapped goes with it, as does its turned copy") {
  Corners copy = square(1, 2, 1e-10);
  std::ranges::reverse(copy);
  CHECK(planes({square(0, 4, 0), square(1, 2, 1e-10), copy, square(2, 1, 1e-10)}) == Planes{0, 0, 0, 0});
}

TEST_CASE("a chain of faces is not drawn into one plane") {
  // Each is near to the next; the last is far from the first, which is the largest.
  CHECK(planes({square(0, 9, 0), square(6, 4, 8e-10), square(9, 3, 1.6e-9), square(11, 3, 2.4e-9)}) ==
        Planes{0, 0, 2, 2});
}

TEST_CASE("a face that rounding has warped is in one plane, with all of its facets") {
  Corners warped = square(0, 4, 0);
  warped[2].z() = 1e-15;
  CutMesh mesh = uncrossed(mesh_of({warped, triangle(0.5, 1e-15)}));
  REQUIRE(mesh.facet_count() == 3);
  mesh.snapped_to = snapped_planes(mesh, distance);
  REQUIRE(mesh.snapped_to.size() == 3);
  CHECK(mesh.snapped_to[0] == mesh.snapped_to[1]);
  CHECK(mesh.snapped_to[0] == mesh.snapped_to[2]);
}

TEST_CASE("of a face that is warped by more only what lies on the other is snapped") {
  Corners roof = square(0, 4, 0);
  roof[1].z() = 1;
  CutMesh mesh = uncrossed(mesh_of({roof, {{0.2, 1, 1e-12}, {1, 3.5, 1e-12}, {0.2, 3.5, 1e-12}}}));
  REQUIRE(mesh.facet_count() == 3);
  mesh.snapped_to = snapped_planes(mesh, distance);
  REQUIRE(mesh.snapped_to.size() == 3);
  CHECK(mesh.plane_of(UncutFacetId(0)) != mesh.plane_of(UncutFacetId(1)));
  CHECK(mesh.is_snapped(UncutFacetId(2)));
}

TEST_CASE("the validator sees planes that are no facet's own, and planes that are missing") {
  CutMesh mesh = uncrossed(mesh_of({square(0, 4, 0), square(1, 2, 1e-10), square(2, 1, 2e-10)}));
  mesh.snapped_to = {UncutFacetId(0), UncutFacetId(0), UncutFacetId(1)};
  CHECK(validate(mesh).size() == 1);
  mesh.snapped_to.pop_back();
  CHECK(validate(mesh).size() == 1);
}

}  // namespace sightline::tests::snapped_planes_test
