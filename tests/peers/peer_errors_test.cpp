// The comparison measures shapes whose errors are known, and its two ways of measuring are held against each other.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "peers/errors/line_errors.h"
#include "peers/errors/part_errors.h"
#include "peers/errors/pixel_areas.h"
#include "peers/errors/pixel_errors.h"
#include "peers/scene/convex_ring.h"

namespace sightline::tests::peer_errors_test {
using namespace peers;

namespace {

constexpr unsigned seed = 20261126;

using Ring = std::vector<Point2>;

Ring rectangle(double left, double bottom, double right, double top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

// The star is drawn around a point of its inside, so that it is simple: it is concave as often as not.
Ring random_star(std::mt19937& random) {
  std::uniform_real_distribution<double> place(-0.5, 0.5);
  std::uniform_real_distribution<double> radius(0.05, 0.5);
  const Point2 centre{place(random), place(random)};
  Ring ring;
  const int corners = 3 + static_cast<int>(random() % 9);
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * 3.14159265358979 * i / corners;
    const double r = radius(random);
    ring.push_back({centre.x + r * std::cos(angle), centre.y + r * std::sin(angle)});
  }
  return ring;
}

// There is one face, everywhere or where a rectangle is.
ExactParts exact(const VisibleParts& parts) {
  ExactParts result{parts, {}, {}};
  for (const VisiblePart& part : parts) result.areas[part.face] += signed_area(part.ring);
  return result;
}

Ring pixel_of(int resolution, int column, int row) {
  const double size = 2.0 / resolution;
  return rectangle(column * size - 1, 1 - (row + 1) * size, (column + 1) * size - 1, 1 - row * size);
}

}  // namespace

TEST_CASE("pixel areas: each pixel has what the ring and its square have in common") {
  INFO("seed ", seed);
  std::mt19937 random(seed);
  constexpr int resolution = 13;
  for (int i = 0; i < 200; ++i) {
    const VisibleParts parts{{FaceId(0U), random_star(random)}};
    double sum = 0;
    double largest_difference = 0;
    PixelAreas(resolution, parts).for_each([&](int column, int row, double area) {
      const double true_area = common_area(pixel_of(resolution, column, row), parts[0].ring);
      largest_difference = std::max(largest_difference, std::abs(area - true_area * resolution * resolution / 4));
      sum += area;
    });
    CHECK(largest_difference < 1e-12);
    CHECK(sum * 4 / resolution / resolution == doctest::Approx(signed_area(parts[0].ring)).epsilon(1e-12));
  }
}

TEST_CASE("pixel areas: along the window's border and along pixels' borders; holes") {
  const VisibleParts parts{{FaceId(0U), rectangle(-1, -1, 1, 1)}, {FaceId(0U), rectangle(-0.5, -0.5, 0, 0.25)}};
  VisibleParts with_hole = parts;
  std::reverse(with_hole[1].ring.begin(), with_hole[1].ring.end());
  PixelAreas(4, with_hole).for_each([](int column, int row, double area) {
    const double expected = column != 1 || row == 0 || row == 3 ? 1 : row == 1 ? 0.5 : 0;
    CHECK(area == expected);
  });
}

TEST_CASE("errors of an item buffer: a pixel is wrong by the part that other faces have of it") {
  const FaceId left(0U);
  const FaceId right(1U);
  const ExactParts truth =
      exact({{left, rectangle(-1, -1, 0.25, 1)}, {right, rectangle(0.25, -1, 0.75, 1)}});  // nothing beyond
  ItemBuffer seen(4);
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 3; ++column) seen.paint(column, row, column < 2 ? left : right);
  }
  const PixelErrors found = errors_of(seen, truth);
  CHECK(found.wrong == std::vector<float>{0, 0, 0.5, 0.5, 0, 0, 0.5, 0.5, 0, 0, 0.5, 0.5, 0, 0, 0.5, 0.5});
  CHECK(found.errors.wrong_share == 0.25);
  CHECK(found.errors.largest_relative_error == doctest::Approx(0.2));
  CHECK(found.errors.mean_relative_error == doctest::Approx(0.1));
  CHECK(found.errors.missed_faces == 0);
  CHECK(found.errors.hidden_faces_shown == 0);
}

TEST_CASE("errors: faces that are missed, and hidden ones that are shown") {
  const ExactParts truth = exact({{FaceId(0U), rectangle(-1, -1, 1, 1)}});
  ItemBuffer seen(2);
  for (const int row : {0, 1}) {
    for (const int column : {0, 1}) seen.paint(column, row, FaceId(1U));
  }
  const AreaErrors of_pixels = errors_of(seen, truth).errors;
  const AreaErrors of_parts = errors_of({{FaceId(1U), rectangle(-1, -1, 1, 1)}}, truth);
  for (const AreaErrors& errors : {of_pixels, of_parts}) {
    CHECK(errors.wrong_share == 1);
    CHECK(errors.missed_faces == 1);
    CHECK(errors.hidden_faces_shown == 1);
    CHECK(errors.largest_relative_error == 1);
  }
}

TEST_CASE("errors of visible parts: missing, over nothing, of another face, twice") {
  const FaceId face(0U);
  const FaceId other(1U);
  const ExactParts truth = exact({{face, rectangle(-1, -1, 0, 0)}, {other, rectangle(0, -1, 1, 0)}});
  const auto wrong_share = [&](const VisibleParts& seen) { return errors_of(seen, truth).wrong_share; };
  CHECK(wrong_share(truth.parts) == 0);
  CHECK(wrong_share({{face, rectangle(-1, -1, 0, 0)}}) == 0.25);
  CHECK(wrong_share({{face, rectangle(-1, -1, 0, 1)}, {other, rectangle(0, -1, 1, 0)}}) == 0.25);
  CHECK(wrong_share({{other, rectangle(-1, -1, 0, 0)}, {face, rectangle(0, -1, 1, 0)}}) == 0.5);
  CHECK(wrong_share({{face, rectangle(-1, -1, 1, 0)}, {other, rectangle(0, -1, 1, 0)}}) == 0.25);
  VisibleParts hole = truth.parts;
  hole.push_back({face, {{-0.75, -0.75}, {-0.75, -0.25}, {-0.25, -0.25}, {-0.25, -0.75}}});  // clockwise
  CHECK(wrong_share(hole) == 0.0625);
}

TEST_CASE("errors of pixels are those of the same pixels as visible parts") {
  INFO("seed ", seed);
  std::mt19937 random(seed);
  constexpr int resolution = 16;
  for (int i = 0; i < 50; ++i) {
    const ExactParts truth = exact({{FaceId(0U), random_star(random)}});
    ItemBuffer seen(resolution);
    VisibleParts parts;
    for (int pixel = 0; pixel < resolution * resolution; ++pixel) {
      if (random() % 2 == 0) continue;
      seen.paint(pixel % resolution, pixel / resolution, FaceId(0U));
      parts.push_back({FaceId(0U), pixel_of(resolution, pixel % resolution, pixel / resolution)});
    }
    CHECK(std::abs(errors_of(seen, truth).errors.wrong_share - errors_of(parts, truth).wrong_share) < 1e-12);
  }
}

TEST_CASE("errors of lines: what is missing, what is hidden, on lines of any direction") {
  const VisibleLines exact{{{-0.5, -0.5}, {0.5, 0.5}}, {{0, 0.25}, {0, -0.75}}};
  const double length = std::sqrt(2.0) + 1;
  const auto errors = [&](const VisibleLines& seen) { return errors_of(seen, exact); };
  const auto is_near = [](double value, double expected) { return std::abs(value - expected) < 1e-12; };
  CHECK(is_near(errors(exact).length, length));
  CHECK(errors(exact).missing_share < 1e-12);
  CHECK(errors(exact).hidden_share < 1e-12);
  const LineErrors halves = errors({{{0.5, 0.5}, {0.25, 0.25}}, {{-0.5, -0.5}, {0.25, 0.25}}, {{0, 0.25}, {0, -0.25}}});
  CHECK(is_near(halves.missing_share, 0.5 / length));
  CHECK(halves.hidden_share < 1e-12);
  const LineErrors longer = errors({{{-0.75, -0.75}, {0.5, 0.5}}, {{0, 0.25}, {0, -0.75}}, {{0, 0.5}, {1, 0.5}}});
  CHECK(longer.missing_share < 1e-12);
  CHECK(is_near(longer.hidden_share, (std::sqrt(2.0) / 4 + 1) / length));
}

}  // namespace sightline::tests::peer_errors_test
