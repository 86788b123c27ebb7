// Certified numbers against rationals, and what they decide against the exact view in the mirror.
#include <doctest/doctest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include "oracle/lattice/lattice.h"
#include "reflect/exact/mirror_view.h"
#include "reflect/exact/mirrored_forms.h"
#include "reflect/exact/pyramid.h"
#include "reflect/world/mirror_world.h"
#include "reflect/world/uncut_facets.h"

namespace sightline::tests::mirrored_forms_test {
namespace {

using lattice::Dice;
using Rational = boost::multiprecision::cpp_rational;

// Digits and exponents are anywhere in a range, and the digits are often few.
double random_number(Dice& dice, int lowest, int highest) {
  const double mantissa = dice.one_in(4) ? dice.between(-4, 4) : dice.between(-1'000'000'000, 1'000'000'000) * 0x1p-29;
  return std::ldexp(mantissa, dice.between(lowest, highest));
}

struct KnownNumber {
  Bounded bounded;
  Rational value;
};

KnownNumber random_bounded(Dice& dice, int lowest, int highest) {
  const double middle = random_number(dice, lowest, highest);
  const double radius = dice.one_in(3) ? 0 : std::abs(random_number(dice, lowest - 60, highest - 10));
  return {{middle, radius}, Rational(middle) + Rational(radius) * dice.between(-8, 8) / 8};
}

bool holds(const Bounded& b, const Rational& value) {
  return !std::isfinite(b.value) || !std::isfinite(b.radius) || abs(value - Rational(b.value)) <= Rational(b.radius);
}

struct Mirrored {
  Camera camera;
  std::array<Point3, 3> plane;
  std::array<Point3, 3> triangle;
};

Point3 random_point(Dice& dice, double unit) {
  const auto coordinate = [&] { return dice.between(static_cast<int>(-2 * unit), static_cast<int>(2 * unit)) / unit; };
  return {coordinate(), coordinate(), coordinate()};
}

// An eye is in front of a mirror; the triangle often shares corners with it.
std::optional<Mirrored> random_mirrored(Dice& dice) {
  const double unit = dice.any_of(std::array{1.0, 3.0, 1e8});
  const ViewPoint view{{dice.between(-3, 3) * 1.0, dice.between(-3, 3) * 1.0, dice.between(3, 6) * 1.0},
                       {dice.between(-1, 1) * 1.0, dice.between(-1, 1) * 1.0, 0},
                       {0.1, 1, 0.05},
                       1,
                       {},
                       {}};
  Mirrored mirrored{
      dice.one_in(4) ? orthographic_camera("mirrored", view, 6) : perspective_camera("mirrored", view, 60),
      {random_point(dice, unit), random_point(dice, unit), random_point(dice, unit)},
      {random_point(dice, unit), random_point(dice, unit), random_point(dice, unit)}};
  auto& [camera, plane, triangle] = mirrored;
  if (norm((plane[1] - plane[0]).cross(plane[2] - plane[0])) < 1e-6) return std::nullopt;
  if (norm((triangle[1] - triangle[0]).cross(triangle[2] - triangle[0])) < 1e-6) return std::nullopt;
  if (plane_through(plane).side(exact_eye(camera)) < 0) std::swap(plane[1], plane[2]);
  if (plane_through(plane).side(exact_eye(camera)) == 0) return std::nullopt;
  for (std::size_t i = 0; i < 2; ++i) {
    if (dice.one_in(3)) triangle[i] = plane[i];
  }
  return mirrored;
}

CutPolygon exact_polygon(const std::array<Point3, 3>& corners) {
  CutPolygon polygon;
  for (const Point3& p : corners) polygon.push_back({exact_position(p), VertexId{}, {}});
  return polygon;
}

Box box_around(const std::array<Point3, 3>& corners) {
  Box box{corners[0], corners[0]};
  for (const Point3& p : corners) box = hull(box, {p, p});
  return box;
}

WindowPart part_around(const ImagePolygon& polygon, int grid_bits) {
  WindowPart part{2, -2, 2, -2};
  for (const ImagePoint& p : polygon) {
    const double x = std::ldexp(static_cast<double>(p.x), -grid_bits);
    const double y = std::ldexp(static_cast<double>(p.y), -grid_bits);
    part = {std::min(part.left, x), std::max(part.right, x), std::min(part.bottom, y), std::max(part.top, y)};
  }
  const double spacing = std::ldexp(1.0, -grid_bits);
  return {part.left - spacing, part.right + spacing, part.bottom - spacing, part.top + spacing};
}

}  // namespace

TEST_CASE("certified numbers hold the sum, difference, product and quotient of what they hold, at every scale") {
  constexpr std::uint64_t seed = 41;
  INFO("seed ", seed);
  Dice dice(seed);
  int overflows = 0;
  int denormal = 0;
  int signs = 0;
  for (int i = 0; i < 50'000; ++i) {
    const int scale = dice.any_of(std::array{0, 0, 500, -530, -1000, 990});
    const KnownNumber a = random_bounded(dice, scale - 40, scale + 30);
    const KnownNumber b = random_bounded(dice, scale - 40, scale + 30);
    CAPTURE(i);
    CHECK(holds(a.bounded + b.bounded, a.value + b.value));
    CHECK(holds(a.bounded - b.bounded, a.value - b.value));
    CHECK(holds(a.bounded * b.bounded, a.value * b.value));
    if (b.value != 0) CHECK(holds(a.bounded / b.bounded, a.value / b.value));
    const Bounded difference = a.bounded - b.bounded;
    if (difference.is_positive()) CHECK(a.value > b.value);
    if (difference.is_negative()) CHECK(a.value < b.value);
    signs += difference.is_positive() || difference.is_negative() ? 1 : 0;
    overflows += std::isfinite((a.bounded * b.bounded).value) ? 0 : 1;
    denormal += std::abs((a.bounded * b.bounded).value) < 0x1p-1022 ? 1 : 0;
  }
  CHECK(signs > 30'000);
  CHECK(overflows > 3'000);
  CHECK(denormal > 3'000);
}

TEST_CASE("where nothing is known no number has a sign") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const Bounded& b :
       {Bounded(1) / Bounded{1, 2}, Bounded(1e300) * Bounded(-1e300), Bounded(-1e308) + Bounded(-1e308),
        Bounded(infinity) - Bounded(infinity), Bounded{0, 0}, Bounded{-1, 1}, Bounded{1, 1}}) {
    CAPTURE(b.value);
    CHECK_FALSE(b.is_positive());
    CHECK_FALSE(b.is_negative());
  }
  CHECK(bounded_around(-3, 5).value == 1);
  CHECK(bounded_around(-3, 5).radius >= 4);
  CHECK(bounded_around(-3, 5).radius < 4.001);
}

TEST_CASE("an image in the mirror is the exact one, number for number, where it is certain; and it nearly always is") {
  constexpr std::uint64_t seed = 42;
  INFO("seed ", seed);
  Dice dice(seed);
  int seen = 0;
  int clipped = 0;
  int certain_ones = 0;
  int all = 0;
  for (int i = 0; i < 20'000; ++i) {
    const auto mirrored = random_mirrored(dice);
    if (!mirrored) continue;
    const auto& [camera, plane, triangle] = *mirrored;
    const int grid_bits = dice.any_of(std::array{8, 24, 40});
    const MirrorView view(camera, plane_through(plane), grid_bits);
    const ImagePolygon exact = view.image(exact_polygon(triangle));
    const auto certain = certain_image(mirrored_forms(camera, plane), camera, triangle, grid_bits);
    CAPTURE(i);
    if (certain) CHECK(*certain == exact);
    ++all;
    certain_ones += certain ? 1 : 0;
    seen += certain && !exact.empty() ? 1 : 0;
    clipped += certain && exact.size() > 3 ? 1 : 0;
  }
  MESSAGE(all, " triangles, ", certain_ones, " certain, ", seen, " of them seen, ", clipped, " clipped");
  CHECK(all > 10'000);
  CHECK(seen > 1'000);
  CHECK(clipped > 500);
  CHECK(certain_ones > all * 3 / 4);
  CHECK(certain_ones < all);
}

TEST_CASE("the mirror camera is on the side of a plane that it is on exactly, where it is certain") {
  constexpr std::uint64_t seed = 43;
  INFO("seed ", seed);
  Dice dice(seed);
  std::array<int, 3> sides{};
  int undecided = 0;
  for (int i = 0; i < 5'000; ++i) {
    const auto mirrored = random_mirrored(dice);
    if (!mirrored) continue;
    const auto& [camera, plane, triangle] = *mirrored;
    const Sign exact = MirrorView(camera, plane_through(plane), 40).side_of_centre(plane_through(triangle));
    const auto certain = certain_side_of_centre(mirrored_forms(camera, plane), camera, bounded_form(triangle));
    CAPTURE(i);
    if (certain) CHECK(*certain == exact);
    ++sides[static_cast<std::size_t>(exact + 1)];
    undecided += certain ? 0 : 1;
  }
  for (const int count : sides) CHECK(count > 0);
  CHECK(undecided >= sides[1]);
  CHECK(undecided < 100);
}

TEST_CASE("a pyramid touches the box of whatever has an image in its part of the window, and few others") {
  constexpr std::uint64_t seed = 44;
  INFO("seed ", seed);
  Dice dice(seed);
  constexpr int grid_bits = 24;
  int seen = 0;
  int rejected = 0;
  int elsewhere = 0;
  for (int i = 0; i < 10'000; ++i) {
    const auto mirrored = random_mirrored(dice);
    if (!mirrored) continue;
    const auto& [camera, plane, triangle] = *mirrored;
    const ImagePolygon image = MirrorView(camera, plane_through(plane), grid_bits).image(exact_polygon(triangle));
    const MirroredForms forms = mirrored_forms(camera, plane);
    const Box box = box_around(triangle);
    CAPTURE(i);
    if (image.empty()) {
      rejected += Pyramid(forms, {-1, 1, -1, 1}).may_touch(box) ? 0 : 1;
      continue;
    }
    ++seen;
    const WindowPart part = part_around(image, grid_bits);
    CHECK(Pyramid(forms, part).may_touch(box));
    elsewhere += part.right < 0.5 && !Pyramid(forms, {0.9, 1, part.bottom, part.top}).may_touch(box) ? 1 : 0;
  }
  CHECK(seen > 1'000);
  CHECK(rejected > 200);
  CHECK(elsewhere > 100);
}

}  // namespace sightline::tests::mirrored_forms_test
