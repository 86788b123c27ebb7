// A polygon covers pixels: every centre belongs to one polygon of a tiling, and scan lines say what places say.
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "peers/errors/pixel_cover.h"
#include "tests/peers/flat_polygons.h"

namespace sightline::tests::pixel_cover_test {
using namespace peers;

namespace {

using Coverage = std::vector<int>;  // per pixel: how many polygons cover it

Coverage by_scan_lines(const FlatScene& scene, const ItemBuffer& buffer) {
  Coverage coverage(static_cast<std::size_t>(buffer.resolution() * buffer.resolution()));
  for (const FlatPolygon& polygon : scene.polygons) {
    for_each_covered_pixel(buffer, polygon.corners, [&](int column, int row) {
      ++coverage[static_cast<std::size_t>(row * buffer.resolution() + column)];
    });
  }
  return coverage;
}

Coverage by_places(const FlatScene& scene, const ItemBuffer& buffer) {
  Coverage coverage;
  for (int row = 0; row < buffer.resolution(); ++row) {
    for (int column = 0; column < buffer.resolution(); ++column) {
      const Point2 centre{buffer.x_of(column), buffer.y_of(row)};
      coverage.push_back(0);
      for (const FlatPolygon& polygon : scene.polygons) coverage.back() += covers(polygon.corners, centre) ? 1 : 0;
    }
  }
  return coverage;
}

// The window is a fan of triangles around the place.
FlatScene fan_around(const Point2& place) {
  const std::vector<Point2> rim{{-1, -1}, {0.25, -1}, {1, -1}, {1, 0.375}, {1, 1}, {-0.5, 1}, {-1, 1}, {-1, 0.125}};
  std::vector<tests::PlacedPolygon> triangles;
  for (std::size_t i = 0; i < rim.size(); ++i) triangles.push_back({{}, {place, rim[i], rim[(i + 1) % rim.size()]}});
  return flat_scene_of(triangles);
}

bool is_on_edge(const FlatScene& scene, const Point2& place) {
  for (const FlatPolygon& polygon : scene.polygons) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Corner& p = polygon.corners[i];
      const Corner& q = polygon.corners[(i + 1) % 3];
      if (orient2d({p.x, p.y}, {q.x, q.y}, place) == 0) return true;
    }
  }
  return false;
}

int centres_on_edges(const FlatScene& scene, const ItemBuffer& buffer) {
  int on_edges = 0;
  for (int row = 0; row < buffer.resolution(); ++row) {
    for (int column = 0; column < buffer.resolution(); ++column) {
      on_edges += is_on_edge(scene, {buffer.x_of(column), buffer.y_of(row)}) ? 1 : 0;
    }
  }
  return on_edges;
}

}  // namespace

TEST_CASE("pixel cover: each centre belongs to one triangle of a fan, also on edges and in the middle") {
  const ItemBuffer buffer(16);
  int on_edges = 0;
  for (int x = -15; x <= 15; ++x) {
    for (int y = -15; y <= 15; ++y) {
      const FlatScene fan = fan_around({x / 16.0, y / 16.0});
      CHECK(by_places(fan, buffer) == Coverage(256, 1));
      CHECK(by_scan_lines(fan, buffer) == Coverage(256, 1));
      on_edges += centres_on_edges(fan, buffer);
    }
  }
  MESSAGE(on_edges << " centres on lines of edges");
  CHECK(on_edges > 961);
}

TEST_CASE("pixel cover: scan lines cover the places that are covered, random fans") {
  std::mt19937_64 engine(7);
  for (int i = 0; i < 200; ++i) {
    const auto coordinate = [&] { return std::ldexp(static_cast<double>(engine() >> 13U), -50) - 1; };
    const double x = coordinate();
    const FlatScene fan = fan_around({x, coordinate()});
    const ItemBuffer buffer(i % 2 == 0 ? 16 : 25);
    CHECK(by_places(fan, buffer) == by_scan_lines(fan, buffer));
  }
}

TEST_CASE("pixel cover: a centre on an edge belongs to the right and upper side") {
  const ItemBuffer buffer(4);  // centres at -0.75, -0.25, 0.25, 0.75; row 0 is the highest
  const FlatScene scene = flat_scene_of({{{}, rectangle({-0.25, -0.25}, {0.75, 0.75})}});
  const Coverage expected{0, 0, 0, 0,  //
                          0, 1, 1, 0,  //
                          0, 1, 1, 0,  //
                          0, 0, 0, 0};
  CHECK(by_places(scene, buffer) == expected);
  CHECK(by_scan_lines(scene, buffer) == expected);
}

TEST_CASE("pixel cover: what is flat or turned over covers nothing") {
  const ItemBuffer buffer(4);
  const FlatScene flat = flat_scene_of({{{}, {{-1, -0.25}, {1, -0.25}, {0.25, -0.25}}},
                                        {{}, {{0.25, -1}, {0.25, 1}, {0.25, 0}}},
                                        {{}, {{-1, -1}, {-1, 1}, {1, 1}, {1, -1}}}});
  CHECK(by_places(flat, buffer) == Coverage(16, 0));
  CHECK(by_scan_lines(flat, buffer) == Coverage(16, 0));
}

}  // namespace sightline::tests::pixel_cover_test
