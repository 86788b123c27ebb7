// The check of areas is sharp, by hand: what rounding can do is allowed, little more is not.
#include "reconstruct/labelling/face_areas.h"

#include <doctest/doctest.h>

#include "tests/tools/analyzed.h"
#include "tests/tools/polygon_mesh.h"

namespace sightline::tests::face_areas_test {
namespace {

using Messages = std::vector<std::string>;
using Triangles = std::vector<std::array<std::size_t, 3>>;

// There is one face, with one more vertex, seen from a side; the grid's spacing is 16 * 2^-40.
Messages messages_for(const Triangles& triangles, const Point3& fourth_vertex) {
  const Mesh mesh = tests::mesh_of({{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}});
  const Camera camera = orthographic_camera("any", {{3, 5, 9}, {0, 0, 0}, {0, 1, 0}, 1, {}, {}}, 32);
  LabelledMesh labelled{mesh.vertices, {}};
  labelled.vertices.push_back(fourth_vertex);
  for (const auto& [a, b, c] : triangles)
    labelled.triangles.push_back(
        {{VertexId(a), VertexId(b), VertexId(c)}, FaceId(0), FacetId(0), Label::visible, true});
  return validate(labelled, project(mesh, camera, Sides::both));
}

}  // namespace

TEST_CASE("areas: a point beside the edge that it splits, by as little as 2^-42 of the edge") {
  const Triangles split{{0, 3, 2}, {3, 1, 2}};
  for (const double aside : {0.0, 0x1p-44, -0x1p-44}) CHECK(messages_for(split, {2, aside, 0}) == Messages{});
  for (const double aside : {0x1p-40, -0x1p-40})
    CHECK(messages_for(split, {2, aside, 0}) == Messages{"face 0 has triangles of another area"});
}

TEST_CASE("areas: a triangle narrower than the grid may be turned over, and counts against the face") {
  const Triangles around{{0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  CHECK(messages_for(around, {1, 1, 0}) == Messages{});
  CHECK(messages_for(around, {2, -0x1p-37, 0}) == Messages{});
  CHECK(messages_for(around, {2, -0x1p-30, 0}) == Messages{"triangle 0 is turned over against face 0"});
  CHECK(messages_for({{1, 2, 3}, {2, 0, 3}, {1, 0, 3}}, {2, 0x1p-37, 0}).front() ==
        "face 0 has triangles of another area");
}

}  // namespace sightline::tests::face_areas_test
