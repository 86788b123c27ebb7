// Faces that lie on each other, found in whatever pose they were rounded.
#include "geometry/cutting/coincidence.h"

#include <doctest/doctest.h>

#include <cmath>

#include "geometry/faces/face_shape.h"
#include "geometry/mesh/cut_mesh.h"
#include "oracle/scenes/moved_scene.h"
#include "tests/tools/polygon_mesh.h"

namespace sightline::tests::coincidence_test {
namespace {

const Corners wall{{0, 0, 0}, {10, 0, 0}, {10, 3, 0}, {0, 3, 0}};
const Corners window{{2, 1, 0}, {4, 1, 0}, {4, 2, 0}, {2, 2, 0}};
const Corners window_over_the_edge{{9, 1, 0}, {11, 1, 0}, {11, 2, 0}, {9, 2, 0}};

Corners turned(const Corners& corners, double angle, const Vector3& by = Vector3::Zero()) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Vector3(0.3, 0.5, 0.8).normalized()).toRotationMatrix();
  Corners result;
  for (const Point3& p : corners) result.emplace_back(turn * p + by);
  return result;
}

Corners corners_of(const Mesh& mesh, FacetId facet) {
  Corners result;
  for (const VertexId v : mesh.corners(facet)) result.push_back(mesh.position(v));
  return result;
}

std::vector<FaceCoincidence> coincidences(const std::vector<Corners>& faces, double distance = 1e-9) {
  return find_coincidences(uncrossed(mesh_of(faces)), distance);
}

}  // namespace

TEST_CASE("a window in its wall is found in every pose, with its overlap") {
  for (int i = 0; i < 40; ++i) {
    CAPTURE(i);
    for (const auto& [other, overlap] : {std::pair(window, 2.0), std::pair(window_over_the_edge, 1.0)}) {
      Corners face = turned(other, 0.1 * i, {0.1 * i, 7, 3});
      if (i % 2 == 1) std::ranges::reverse(face);
      const auto found = coincidences({turned(wall, 0.1 * i, {0.1 * i, 7, 3}), face});
      REQUIRE(found.size() == 1);
      CHECK(found[0].first == FaceId(0));
      CHECK(found[0].second == FaceId(1));
      CHECK(found[0].distance < 1e-13);
      CHECK(found[0].overlap == doctest::Approx(overlap).epsilon(1e-9));
    }
  }
}

TEST_CASE("faces in one plane, exactly, are no distance apart") {
  const auto found = coincidences({wall, window});
  REQUIRE(found.size() == 1);
  CHECK(found[0].distance == 0);
  const Corners slope{{0, 0, 0}, {8, 0, 4}, {8, 8, 8}, {0, 8, 4}};
  const auto on_slope = coincidences({slope, {{2, 2, 2}, {4, 2, 3}, {4, 4, 4}}});
  REQUIRE(on_slope.size() == 1);
  CHECK(on_slope[0].distance == 0);
}

TEST_CASE("the largest distance in the overlap counts, and only what is closer than asked is found") {
  Corners apart = window;
  for (Point3& p : apart) p.z() = 1e-6;
  apart[0].z() = 3e-6;
  apart[3].z() = 3e-6;
  CHECK(coincidences({wall, apart}).empty());
  CHECK(coincidences({wall, apart}, 2.9e-6).empty());
  const auto found = coincidences({wall, apart}, 3.1e-6);
  REQUIRE(found.size() == 1);
  CHECK(found[0].distance == doctest::Approx(3e-6));
}

TEST_CASE("what meets in an edge or a corner, is turned over, or passes through, is none") {
  const Corners beside{{10, 0, 0}, {12, 0, 0}, {12, 3, 0}, {10, 3, 0}};
  const Corners upright{{10, 0, 0}, {10, 3, 0}, {10, 3, 5}, {10, 0, 5}};
  const Corners through{{2, 1, -1}, {4, 1, 1}, {4, 2, 1}, {2, 2, -1}};
  Corners copy = wall;
  std::ranges::reverse(copy);
  CHECK(coincidences({wall, beside}).empty());
  CHECK(coincidences({wall, upright}).empty());
  CHECK(coincidences({wall, through}).empty());
  CHECK(coincidences({wall, copy}).empty());
  CHECK(coincidences({turned(wall, 1), turned(beside, 1)}).empty());
}

// Every pair of facets is looked at, without the hierarchy of boxes. The scenes are of a lattice, where faces lie in one plane often,
// and turned off it.
TEST_CASE("what is found in random scenes is what is found pair by pair") {
  std::size_t pairs = 0;
  for (std::uint64_t seed = 1; seed <= 600; ++seed) {
    CAPTURE(seed);
    const Mesh mesh = lattice::moved(lattice::random_scene(seed), lattice::Moved::turned);
    const double distance = 1e-12 * size_of(mesh);
    std::vector<std::array<FaceId, 2>> expected;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
      for (std::size_t g = f + 1; g < mesh.facet_count(); ++g) {
        const std::array faces{mesh.facet_face[f], mesh.facet_face[g]};
        Corners a = corners_of(mesh, FacetId(f));
        Corners b = corners_of(mesh, FacetId(g));
        if (faces[0] == faces[1] || !coincidence_of(a, b, distance)) continue;
        std::ranges::sort(a, lexicographically_less);
        std::ranges::sort(b, lexicographically_less);
        if (a != b) expected.push_back(faces);
      }
    }
    std::ranges::sort(expected);
    expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
    std::vector<std::array<FaceId, 2>> found;
    for (const FaceCoincidence& pair : find_coincidences(uncrossed(mesh), distance))
      found.push_back({pair.first, pair.second});
    CHECK(found == expected);
    pairs += found.size();
  }
  CHECK(pairs > 30);
}

TEST_CASE("faces that a point is on are named, be it over them or at their border") {
  const Mesh mesh = mesh_of({wall, {{0, 0, 0}, {0, 3, 0}, {0, 3, 5}, {0, 0, 5}}});
  CHECK(faces_at(mesh, {5, 1, 0}, 0) == std::vector{FaceId(0)});
  CHECK(faces_at(mesh, {5, 1, 1e-10}, 1e-9) == std::vector{FaceId(0)});
  CHECK(faces_at(mesh, {5, 1, 1e-8}, 1e-9).empty());
  CHECK(faces_at(mesh, {0, 1, 0}, 1e-9) == std::vector{FaceId(0), FaceId(1)});
  CHECK(faces_at(mesh, {5, -1e-10, 0}, 1e-9) == std::vector{FaceId(0)});
  CHECK(faces_at(mesh, {5, -1e-8, 0}, 1e-9).empty());
}

TEST_CASE("the scene's size is the diagonal of the box around its faces") {
  CHECK(size_of(mesh_of({{{0, 0, 0}, {3, 0, 0}, {3, 4, 0}}})) == 5);
  CHECK(size_of(mesh_of({})) == 0);
}

}  // namespace sightline::tests::coincidence_test
