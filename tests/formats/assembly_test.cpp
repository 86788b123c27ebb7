// Several meshes as one: numbers, places, regions, and what is said of faces that are none.
#include "formats/reading/assembly.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "formats/reading/obj_reader.h"
#include "tests/tools/obj_case.h"

namespace sightline::tests::assembly_test {
namespace {

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const std::string two_objects = "v 0 0 5\nv 1 0 5\nv 0 1 5\nv 1 1 5\no a\ng all\nf 1 2 3\no b\nusemtl m\nf 2 4 3\n";

MeshPart part(const std::string& text, const std::string& name, const Placement& placement = {}) {
  return {name + ".obj", name, placement, read_obj(text, name + ".obj", {}, Normals::read)};
}

Placement moved(double x) {
  Placement placement;
  placement.matrix(0, 3) = x;
  return placement;
}

std::vector<std::string> regions_of(const FaceRegions& regions, std::size_t face) {
  std::vector<std::string> names;
  regions.for_each(FaceId(face), [&](RegionId id) {
    const Region& region = regions.regions[id.index()];
    names.push_back(std::string(to_string(region.kind)) + " " + region.mesh + "/" + region.name);
  });
  std::ranges::sort(names);
  return names;
}

}  // namespace

TEST_CASE("vertices and faces are numbered on, and each mesh is where it is placed") {
  const MeshFile all = assembled({part(triangle, "screen", moved(2)), part(two_objects, "body")});
  REQUIRE(all.mesh.face_count() == 3);
  CHECK(all.mesh.vertices.size() == 7);
  CHECK(all.mesh.vertices[1] == Point3(3, 0, 0));
  CHECK(all.mesh.faces[2][1] == VertexId(6));
  CHECK(all.mesh.vertices[6] == Point3(1, 1, 5));
  CHECK(validate(all.mesh) == std::vector<std::string>{});
  CHECK(all.warnings.empty());
}

TEST_CASE("faces are in their mesh; where a file names no object, in one of its name") {
  const MeshFile all = assembled({part(triangle, "screen"), part(two_objects, "body")});
  using Names = std::vector<std::string>;
  CHECK(regions_of(all.regions, 0) ==
        Names{"group screen/", "material screen/", "mesh screen/screen", "object screen/screen", "smoothing screen/"});
  CHECK(regions_of(all.regions, 1) ==
        Names{"group body/all", "material body/", "mesh body/body", "object body/a", "smoothing body/"});
  CHECK(regions_of(all.regions, 2) ==
        Names{"group body/all", "material body/m", "mesh body/body", "object body/b", "smoothing body/"});
}

TEST_CASE("a file of a format without regions is one object of its mesh's name") {
  MeshPart plain = part(triangle, "scan");
  plain.file.regions = {};
  const MeshFile all = assembled({std::move(plain), part(triangle, "other", moved(2))});
  CHECK(regions_of(all.regions, 0)[3] == "object scan/scan");
  CHECK(all.regions.face_state.size() == 2);
}

TEST_CASE("one mesh that has no name and is not moved is what its file says, bit for bit") {
  MeshPart only = part("v -0.0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "");
  const MeshFile all = assembled({std::move(only)});
  CHECK(std::signbit(all.mesh.vertices[0].x()));
  CHECK(all.regions.regions[0].name == "");
}

TEST_CASE("what is no face only in the scene is said, with the file and the scene's number") {
  const MeshFile all = assembled({part(triangle + "f 1 2 1\n", "a"), part(triangle + "v 9 9 9\n", "b")});
  REQUIRE(all.warnings.size() == 2);
  CHECK(all.warnings[0] == "a.obj: 1 face skipped (too few corners): 1");
  CHECK(all.warnings[1] == "b.obj: 1 face skipped in the scene (repeated face), by the scene's numbers: 2");
  CHECK(all.mesh.facet_count() == 1);
}

TEST_CASE("normals of one mesh stay at its corners, and other meshes have none") {
  const std::string with_normals = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 2\nf 1//1 2//1 3//1\n";
  const MeshFile all =
      assembled({part(triangle, "a"), part(with_normals, "b", {.up_axis = UpAxis::z}), part(triangle, "c", moved(3))});
  REQUIRE(all.corner_normals.size() == 9);
  for (std::size_t i = 0; i < 9; ++i) {
    const Vector3 expected = i / 3 == 1 ? Vector3(0, 1, 0) : Vector3::Zero();
    CHECK(unit(all.corner_normals[i]) == expected);
  }
}

TEST_CASE("all meshes together count against the limit on memory") {
  const std::uint64_t one = memory_for_mesh(3, 3, 1);
  std::vector<MeshPart> parts;
  for (const char* name : {"a", "b"}) parts.push_back(part(triangle, name));
  CHECK_THROWS_AS((void)assembled(parts, {one + 10}), InputError);
  CHECK_NOTHROW((void)assembled(parts, {2 * one}));
}

TEST_CASE("without faces: as a file that does not have them, but for their numbers") {
  const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvn 0 0 1\n";
  const MeshFile whole = read_obj(text + "f 1//1 2//1 3//1\nf 3 2 1\nf 2 4 3\n", "mesh.obj", {}, Normals::read);
  const MeshFile left = without_faces(whole, {1, 0, 0});
  const MeshFile other = read_obj(text + "f 3 2 1\nf 2 4 3\n", "mesh.obj", {}, Normals::read);
  CHECK(left.mesh.face_count() == 3);
  REQUIRE(left.mesh.facet_count() == other.mesh.facet_count());
  CHECK(left.mesh.facets.corners == other.mesh.facets.corners);
  CHECK(left.mesh.facet_face[0] == FaceId(1));
  CHECK(left.mesh.edges == other.mesh.edges);
  CHECK(left.corner_normals == other.corner_normals);
  CHECK(validate(left.mesh) == std::vector<std::string>{});
  CHECK(without_faces(whole, {1, 1, 1}).warnings.back() == "the scene is empty: every face is left out");
}

}  // namespace sightline::tests::assembly_test
