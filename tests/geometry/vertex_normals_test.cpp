// Normals come as files give them, and as means.
#include <doctest/doctest.h>

#include <cmath>

#include "formats/reading/obj_reader.h"
#include "geometry/mesh/vertex_normals.h"

namespace sightline::tests::vertex_normals_test {
namespace {

std::vector<Vector3> read_normals(const std::string& text) {
  return read_obj(text, "test.obj", {}, Normals::read).corner_normals;
}

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

bool is_near(const Vector3& a, const Vector3& b) { return norm(a - b) < 1e-15; }

// The corner of a box is at the origin, its three faces of different sizes.
Mesh box_corner(double scale) {
  const std::vector<Point3> places{{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}, {0, 0, 2}, {1, 0, 2}, {0, 1, 2}};
  std::vector<Point3> vertices;
  for (const Point3& p : places) vertices.push_back(scale * p);
  PolygonList faces;
  const auto add = [&](std::initializer_list<std::size_t> corners) {
    std::vector<VertexId> face;
    for (const std::size_t corner : corners) face.emplace_back(corner);
    faces.push_back(face);
  };
  add({0, 1, 2, 3});  // area 1, facing down
  add({0, 3, 5, 4});  // area 2, facing the front
  add({0, 4, 6, 1});  // area 2, facing the left
  return build_mesh(std::move(vertices), std::move(faces));
}

}  // namespace

TEST_CASE("normals of corners, by index, from the end, and where there are none") {
  CHECK(read_normals(triangle + "vn 0 0 1\nvn 0 3 4\nf 1//1 2//2 3//-1\n") ==
        std::vector<Vector3>{{0, 0, 1}, {0, 3, 4}, {0, 3, 4}});
  CHECK(read_normals(triangle + "vn 0 0 1\nvt 0 0\nf 1/1/1 2/1 3\n") ==
        std::vector<Vector3>{{0, 0, 1}, {0, 0, 0}, {0, 0, 0}});
  // One that names nothing is none, with a warning.
  CHECK(read_normals(triangle + "vn 0 0 1\nf 1//2 2//1 3//-2\n") ==
        std::vector<Vector3>{{0, 0, 0}, {0, 0, 1}, {0, 0, 0}});
}

TEST_CASE("normals are not read, and not looked at, where nobody asks") {
  const std::string text = triangle + "vn one\nvn nan 0 0\nf 1//1 2//2 3//1\n";
  CHECK(read_obj(text, "test.obj").corner_normals.empty());
  CHECK_THROWS_WITH_AS((void)read_normals(text), doctest::Contains("test.obj:4: "), InputError);
  CHECK_THROWS_WITH_AS((void)read_normals(triangle + "vn 1 2\nf 1 2 3\n"),
                       doctest::Contains("a normal needs three coordinates"), InputError);
}

TEST_CASE("without given normals a corner has the mean of the faces around it, weighted by area, at any scale") {
  for (const double scale : {1.0, 0x1p-1060, 0x1p1000}) {
    CAPTURE(scale);
    const std::vector<Vector3> normals = vertex_normals(box_corner(scale), {});
    REQUIRE(normals.size() == 12);
    const Vector3 corner{-2.0 / 3, -2.0 / 3, -1.0 / 3};
    CHECK(is_near(normals[0], corner));
    CHECK(is_near(normals[4], corner));
    CHECK(is_near(normals[2], {0, 0, -1}));
    CHECK(is_near(normals[3], (1 / std::sqrt(5.0)) * Vector3{0, -2, -1}));
  }
}

TEST_CASE("plain means give every face the same weight, at any scale") {
  for (const double scale : {1.0, 0x1p-1060, 0x1p1000}) {
    CAPTURE(scale);
    const std::vector<Vector3> normals = vertex_normals(box_corner(scale), {}, {NormalMeans::plain, std::nullopt});
    CHECK(is_near(normals[0], -1 / std::sqrt(3.0) * Vector3{1, 1, 1}));
    CHECK(is_near(normals[3], -1 / std::sqrt(2.0) * Vector3{0, 1, 1}));
  }
}

TEST_CASE("beyond a crease faces do not count") {
  const std::vector<Vector3> sharp = vertex_normals(box_corner(1), {}, {NormalMeans::area, 89});
  CHECK(is_near(sharp[0], {0, 0, -1}));
  CHECK(is_near(sharp[4], {0, -1, 0}));
  CHECK(is_near(sharp[8], {-1, 0, 0}));
  CHECK(vertex_normals(box_corner(1), {}, {NormalMeans::area, 91}) == vertex_normals(box_corner(1), {}));
}

TEST_CASE("doubts about normals: those of faces, turned ones, and means across sharp edges") {
  const Mesh box = box_corner(1);
  const NormalDoubts means = doubts_about_normals(box, {});
  CHECK_FALSE(means.are_of_faces);
  CHECK(means.turned_corners == 0);
  CHECK(means.sharpest_mean == doctest::Approx(90));
  CHECK(means.sharpest[0] != means.sharpest[1]);
  CHECK(doubts_about_normals(box, {}, {NormalMeans::area, 80}).sharpest_mean == 0);
  const Vector3 down{0, 0, -1};
  const Vector3 front{0, -2, 0};
  const Vector3 left{-3, 0, 0};
  std::vector<Vector3> of_faces{down, down, down, down, front, front, front, front, left, left, left, left};
  const NormalDoubts flat = doubts_about_normals(box, of_faces);
  CHECK(flat.are_of_faces);
  CHECK(flat.sharpest_mean == 0);
  of_faces[5] = -front;
  const NormalDoubts turned = doubts_about_normals(box, of_faces);
  CHECK_FALSE(turned.are_of_faces);
  CHECK(turned.turned_corners == 1);
  CHECK(turned.first_turned == FaceId(1));
  // A flat mesh has no other normals than those of its faces.
  const Mesh flat_mesh = read_obj(triangle + "f 1 2 3\n", "test.obj").mesh;
  CHECK_FALSE(doubts_about_normals(flat_mesh, {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}).are_of_faces);
}

TEST_CASE("vertices at one place share their mean, and given normals stand") {
  // Two triangles make a roof, each with its own vertices.
  const MeshFile roof =
      read_obj("v 0 0 0\nv 0 1 0\nv -1 0 -1\nv 0 0 0\nv 1 0 -1\nv 0 1 0\nf 1 2 3\nf 4 5 6\n", "roof.obj");
  const std::vector<Vector3> means = vertex_normals(roof.mesh, {});
  CHECK(is_near(means[0], {0, 0, 1}));
  CHECK(is_near(means[3], {0, 0, 1}));
  std::vector<Vector3> given(6, Vector3::Zero());
  given[0] = {0, 5, 0};
  const std::vector<Vector3> mixed = vertex_normals(roof.mesh, given);
  CHECK(mixed[0] == Vector3{0, 1, 0});
  CHECK(is_near(mixed[3], {0, 0, 1}));
}

}  // namespace sightline::tests::vertex_normals_test
