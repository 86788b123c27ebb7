// These extreme scenes have many faces: what is seen is known by a formula.
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <utility>

#include "geometry/mesh/components.h"
#include "tests/extremes/checked_scene.h"

namespace sightline::tests::extremes_many_test {
using namespace extremes;

namespace {

constexpr Allowances large{.coplanar = false, .large = true};

// The scene is shrunk to what the rational oracle takes, and seen by the same cameras.
void check_part(const CheckedScene& scene, const std::function<bool(FaceId)>& wanted) {
  const Mesh part = with_faces(scene.mesh, wanted);
  CHECK(part.face_count() >= 10);
  CHECK(part.face_count() <= 24);
  for (const Sight& whole : scene.sights) {
    CAPTURE(whole.camera.name);
    const Sight seen = sight(part, whole.camera, SidesPolicy::both);
    CHECK(total(seen.areas) > 0);
    CHECK(lattice::joined(differences_from_truth(part, seen)) == "");
  }
}

// The window is taken as 64 by 64 squares: the borders of grid_head_on's cells fall between them, for both of its
// cameras.
constexpr int squares = 64;

// Returns the column or row at which a coordinate lies.
std::size_t square_at(double coordinate, double half_width) {
  const double place = (coordinate / half_width + 1) * (squares / 2);
  REQUIRE(place == std::floor(place));
  return static_cast<std::size_t>(place);
}

// Returns what is seen of rectangles parallel to the window, in order of depth: they are painted into the squares that
// are free yet.
std::vector<Rational> painted_areas(const Mesh& mesh, const Camera& camera) {
  std::vector<std::uint8_t> taken(squares * squares, 0);
  std::vector<Rational> areas(mesh.face_count());
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const Point3& low = mesh.position(mesh.faces[f][0]);
    const Point3& high = mesh.position(mesh.faces[f][2]);
    const double half_width = camera.projection == Projection::perspective ? 8 - low.z() : 8;
    for (std::size_t y = square_at(low.y(), half_width); y < square_at(high.y(), half_width); ++y) {
      for (std::size_t x = square_at(low.x(), half_width); x < square_at(high.x(), half_width); ++x) {
        if (std::exchange(taken[y * squares + x], 1) == 0) areas[f] += Rational(4, squares * squares);
      }
    }
  }
  return areas;
}

}  // namespace

TEST_CASE("extreme scene edges_through_a_point: each half-plane adds the wedge to the next edge") {
  const CheckedScene scene = checked("edges_through_a_point", large);
  const Sight& above = scene.from("above");
  CHECK(is_exact(scene.mesh, above));
  REQUIRE(above.areas.size() == 1000);
  CHECK(above.areas[0] == 2);
  // Ends of neighbouring edges are 1/256 apart on the window's border, at distance 1 from the middle.
  for (std::size_t k = 1; k < 1000; ++k) CHECK(above.areas[k] == Rational(1, 2 * 256));
  CHECK(above.view.segments.crossings.size() == 1);
  check_part(scene, [](FaceId f) { return f.value % 50 == 0; });
}

TEST_CASE("extreme scene coincident_edges: of each size the first triangle to each side shows around the size before") {
  const CheckedScene scene = checked("coincident_edges", large);
  const Sight& above = scene.from("above");
  CHECK(is_exact(scene.mesh, above));
  REQUIRE(above.areas.size() == 10000);
  for (std::size_t k = 0; k < 10000; ++k) {
    const Rational size(k / 100 + 1, 128);
    const Rational before(k / 100, 128);
    CHECK(above.areas[k] == (k % 100 < 2 ? Rational(size * size - before * before) : Rational(0)));
  }
  check_part(scene, [](FaceId f) { return f.value % 550 == 0; });
}

TEST_CASE("extreme scene grid_head_on: as painted on squared paper") {
  const CheckedScene scene = checked("grid_head_on", large);
  for (const Sight& seen : scene.sights) {
    CAPTURE(seen.camera.name);
    CHECK(is_exact(scene.mesh, seen));
    CHECK(seen.areas == painted_areas(scene.mesh, seen.camera));
  }
  check_part(scene, [&](FaceId f) {
    const Point3& low = scene.mesh.position(scene.mesh.faces[f.index()].front());
    return low.x() >= -2 && low.x() < 0 && low.y() >= -2 && low.y() < 0;
  });
}

TEST_CASE("extreme scene touching_cubes: from straight above five cubes of the first layer and four of the second") {
  const CheckedScene scene = checked("touching_cubes", large);
  const Sight& straight = scene.from("straight");
  CHECK(is_exact(scene.mesh, straight));
  for (std::size_t f = 0; f < straight.areas.size(); ++f) {
    const auto height = [&](std::size_t corner) { return scene.mesh.position(scene.mesh.faces[f][corner]).z(); };
    const bool is_top = f % 6 == 5;
    REQUIRE((!is_top || (height(0) == height(1) && height(1) == height(2))));
    CHECK(straight.areas[f] == (is_top && height(0) >= 2 ? Rational(1, 4) : Rational(0)));
  }
  CHECK(total(straight.areas) == Rational(9, 4));
  // The first cubes are two at the bottom, touching along an edge, one that touches both, and one above.
  check_part(scene, [](FaceId f) { return f.value / 6 < 3 || f.value / 6 == 5; });
}

TEST_CASE("extreme scene components: every one of a hundred thousand is seen whole") {
  const CheckedScene scene = checked("components", large);
  const Sight& above = scene.from("above");
  CHECK(is_exact(scene.mesh, above));
  CHECK(components(scene.mesh).size() == 100000);
  // The window is 128 wide and 1024 high, so a unit square is 1/64 by 1/512 of the image.
  CHECK(above.areas == std::vector<Rational>(100000, Rational(1, 2 * 64 * 512)));
  check_part(scene, [](FaceId f) { return f.value / 100 < 4 && f.value % 100 < 5; });
}

}  // namespace sightline::tests::extremes_many_test
