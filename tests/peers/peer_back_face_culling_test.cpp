// Back-face culling alone is right for one convex body, and for no more than that.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "oracle/lattice/lattice.h"
#include "peers/painters/back_face_culling.h"
#include "tests/peers/peer_parts.h"
#include "tests/tools/polygon_mesh.h"

namespace sightline::tests::peer_back_face_culling_test {
namespace {

using lattice::Dice;
using peers::back_face_culling;

using Body = std::vector<Corners>;

bool all_behind(const std::vector<Point3>& points, const Corners& face) {
  return std::all_of(points.begin(), points.end(), [&](const Point3& p) {
    return std::find(face.begin(), face.end(), p) != face.end() || orient3d(face[0], face[1], face[2], p) < 0;
  });
}

// Returns the outward triangles of the hull of points of which no four are in one plane.
Body hull_of(const std::vector<Point3>& points) {
  Body faces;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      for (std::size_t k = j + 1; k < points.size(); ++k) {
        for (const Corners& face :
             {Corners{points[i], points[j], points[k]}, Corners{points[i], points[k], points[j]}}) {
          if (all_behind(points, face)) faces.push_back(face);
        }
      }
    }
  }
  return faces;
}

std::size_t corner_count(const Body& body) {
  std::set<std::array<double, 3>> corners;
  for (const Corners& face : body) {
    for (const Point3& p : face) corners.insert({p.x(), p.y(), p.z()});
  }
  return corners.size();
}

Body box(const Point3& low, const Point3& high) {
  const auto at = [&](int x, int y, int z) {
    return Point3{x == 0 ? low.x() : high.x(), y == 0 ? low.y() : high.y(), z == 0 ? low.z() : high.z()};
  };
  return {{at(0, 0, 0), at(0, 1, 0), at(1, 1, 0), at(1, 0, 0)}, {at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)},
          {at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0)}, {at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1)},
          {at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1)}, {at(0, 1, 0), at(0, 1, 1), at(1, 1, 1), at(1, 1, 0)}};
}

Body both(Body a, const Body& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

Point3 on_grid(Dice& dice, int reach) {
  const auto place = [&] { return dice.between(-reach, reach) / 1024.0; };
  const double x = place();
  const double y = place();
  return {x, y, place()};
}

// The camera looks from some place around the origin, which bodies of a radius below 1 do not reach.
Camera looking_at_origin(Dice& dice) {
  ViewPoint view;
  do view.eye = on_grid(dice, 4096);
  while (norm(view.eye) < 2.5);
  view.up = {0.125, 1, 0.25};
  return dice.one_in(2) ? orthographic_camera("around", view, 3) : perspective_camera("around", view, 90);
}

void check_equals_sweep(const Body& body, const Camera& camera) {
  const PartsCase parts = parts_case(back_face_culling(), mesh_of(body), camera);
  CHECK(largest_error(parts) <= 1e-9);
  CHECK(overlap_within_faces(parts.parts) <= 1e-9);
  const std::uint64_t front = number_of(parts, "front faces");
  CHECK(front > 0);
  CHECK(front < body.size());
}

double total(const FaceAreas& areas) { return std::accumulate(areas.begin(), areas.end(), 0.0); }

}  // namespace

TEST_CASE("back-face culling: a box and a tetrahedron from all around") {
  const Body tetrahedron = hull_of({{0, 0, 0.75}, {0.5, 0, -0.5}, {-0.5, 0.25, -0.5}, {0, -0.75, -0.25}});
  CHECK(tetrahedron.size() == 4);
  Dice dice(1);
  for (int i = 0; i < 100; ++i) {
    INFO("seed 1, camera ", i);
    const Camera camera = looking_at_origin(dice);
    check_equals_sweep(box({-0.5, -0.25, -0.125}, {0.375, 0.5, 0.625}), camera);
    check_equals_sweep(tetrahedron, camera);
  }
}

TEST_CASE("back-face culling: random convex bodies") {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    INFO("seed ", seed);
    Dice dice(seed);
    std::vector<Point3> points;
    for (int i = dice.between(5, 16); i > 0; --i) points.push_back(on_grid(dice, 550));
    const Body body = hull_of(points);
    REQUIRE(body.size() == 2 * corner_count(body) - 4);
    check_equals_sweep(body, looking_at_origin(dice));
  }
}

TEST_CASE("back-face culling: of two boxes it shows what the nearer one hides") {
  const Body lower = box({-0.5, -0.5, -1}, {0.5, 0.5, -0.5});
  const Body upper = box({-0.25, -0.25, 1}, {0.75, 0.25, 1.5});
  const PartsCase parts = parts_case(back_face_culling(), mesh_of(both(lower, upper)), straight_down());
  const std::size_t top_of_lower = 1;
  const std::size_t top_of_upper = lower.size() + 1;
  CHECK(parts.seen[top_of_lower] == 1);
  CHECK(parts.exact[top_of_lower] == doctest::Approx(1 - 0.75 * 0.5));
  CHECK(parts.seen[top_of_upper] == parts.exact[top_of_upper]);
  CHECK(total(parts.seen) - total(parts.exact) == doctest::Approx(0.375));
}

TEST_CASE("back-face culling: an open sheet seen from behind is not shown") {
  const Corners sheet{{-0.5, -0.5, 0}, {-0.5, 0.5, 0}, {0.5, 0.5, 0}, {0.5, -0.5, 0}};
  const PartsCase parts = parts_case(back_face_culling(), mesh_of({sheet}), straight_down());
  CHECK(parts.parts.empty());
  CHECK(parts.exact[0] == 1);
}

}  // namespace sightline::tests::peer_back_face_culling_test
