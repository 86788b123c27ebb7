// Cohen-Sutherland and Cyrus-Beck are held against each other and against clipping in rationals.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <span>
#include <stdexcept>

#include "oracle/lattice/lattice.h"
#include "peers/lines/cohen_sutherland.h"
#include "peers/lines/cyrus_beck.h"

namespace sightline::tests::line_clipping_test {
using namespace peers;

namespace {

using Exact = boost::multiprecision::cpp_rational;

// A part in exact numbers is [enter, leave] of the line's parameter.
struct ExactPart {
  Exact enter = 0;
  Exact leave = 1;
  [[nodiscard]] bool is_seen() const { return enter <= leave; }
};

// Returns which t of P0 + t D have value + t change <= 0, for each edge of a counter-clockwise polygon; this does not
// take Cyrus and Beck's sets, but narrows the interval edge by edge.
ExactPart exact_part(const Line& line, std::span<const Point2> polygon) {
  ExactPart part;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2& p = polygon[i];
    const Point2& q = polygon[(i + 1) % polygon.size()];
    const auto outside = [&](const Point2& v) -> Exact {
      return (Exact(q.y) - p.y) * (Exact(v.x) - p.x) - (Exact(q.x) - p.x) * (Exact(v.y) - p.y);
    };
    const Exact value = outside(line.from);
    const Exact change = outside(line.to) - value;
    if (change == 0 && value > 0) part.leave = -1;
    if (change < 0) part.enter = std::max<Exact>(part.enter, -value / change);
    if (change > 0) part.leave = std::min<Exact>(part.leave, -value / change);
  }
  return part;
}

Point2 exact_place(const Line& line, const Exact& t) {
  const auto between = [&t](double from, double to) {
    return static_cast<double>(Exact(from + t * (Exact(to) - Exact(from))));
  };
  return {between(line.from.x, line.to.x), between(line.from.y, line.to.y)};
}

double distance(const Point2& a, const Point2& b) { return std::hypot(a.x - b.x, a.y - b.y); }

double length(const Line& line) { return distance(line.from, line.to); }

constexpr Window window{-1, -1, 2, 1};
constexpr std::array<Point2, 4> window_corners{Point2{-1, -1}, Point2{2, -1}, Point2{2, 1}, Point2{-1, 1}};

// How far off a computed end may be, with coordinates below 3.5 in size: 256 u f, where u = 2^-53 and 1 / f is the sine
// of the smallest angle between the line and an edge that it is not parallel to.
// Cyrus-Beck: N . (P0 - P_E) and N . D are off by 4 u |N| |P0 - P_E| and 4 u |N| |D|, and t in [0, 1] by their sum over
// |N . D|; the place by |D| times that, some 4 u f (|P0 - P_E| + |D|), and by its own roundings, 3 u |D| + 5 u. Both
// lengths are below 10: 115 u f in all.
// Cohen-Sutherland: a cut's own roundings are below 40 u, and it takes over, f times as large, how far the cuts before
// it left the line: four cuts, 160 u f.
double roundings(const Line& line, std::span<const Point2> polygon) {
  const Point2 along{line.to.x - line.from.x, line.to.y - line.from.y};
  double f = 1;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2& p = polygon[i];
    const Point2& q = polygon[(i + 1) % polygon.size()];
    const double rise = std::abs((q.y - p.y) * along.x - (q.x - p.x) * along.y);
    if (rise > 0) f = std::max(f, distance(p, q) * length(line) / rise);
  }
  return 0x1p-45 * f;
}

// What came out is held against the exact part. Where no more than a point is seen, rounding may decide either way.
void check(const std::optional<Line>& clipped, const Line& line, const ExactPart& exact, double roundings) {
  const Line truth{exact_place(line, exact.enter), exact_place(line, exact.leave)};
  const bool is_more_than_a_point = exact.is_seen() && length(truth) > roundings;
  if (is_more_than_a_point) REQUIRE(clipped.has_value());
  if (!exact.is_seen() && clipped) CHECK(length(*clipped) <= roundings);
  if (!exact.is_seen() || !clipped) return;
  CHECK(distance(clipped->from, truth.from) <= roundings);
  CHECK(distance(clipped->to, truth.to) <= roundings);
}

std::optional<Line> by_cyrus_beck(const Line& line, std::span<const Point2> polygon) {
  const auto clipped = cyrus_beck(line, polygon);
  return clipped ? std::optional(clipped->line) : std::nullopt;
}

void check_all(const Line& line) {
  const ExactPart exact = exact_part(line, window_corners);
  const double bound = roundings(line, window_corners);
  INFO(line.from.x, ",", line.from.y, " to ", line.to.x, ",", line.to.y);
  const auto by_table = cyrus_beck(line, window);
  check(cohen_sutherland(line, window), line, exact, bound);
  if (exact.is_seen() && exact.enter == 0) CHECK(cohen_sutherland(line, window)->from == line.from);
  if (exact.is_seen() && exact.leave == 1) CHECK(cohen_sutherland(line, window)->to == line.to);
  check(by_cyrus_beck(line, window_corners), line, exact, bound);
  check(by_table ? std::optional(by_table->line) : std::nullopt, line, exact, bound);
}

struct Kinds {
  int points = 0;
  int on_border = 0;  // along one of the window's lines
  int touching = 0;   // seen in a point only
  int unseen = 0;     // though no outcode says so at once
  int through = 0;    // cut at both ends

  void add(const Line& line) {
    const ExactPart exact = exact_part(line, window_corners);
    const bool has_length = !(line.from == line.to);
    points += has_length ? 0 : 1;
    on_border += has_length && (line.from.x == line.to.x) && (line.from.x == -1 || line.from.x == 2) ? 1 : 0;
    touching += has_length && exact.enter == exact.leave ? 1 : 0;
    const bool trivial = (outcode_of(line.from, window) & outcode_of(line.to, window)) != 0;
    unseen += !trivial && !exact.is_seen() ? 1 : 0;
    through += exact.is_seen() && exact.enter > 0 && exact.leave < 1 ? 1 : 0;
  }
};

}  // namespace

TEST_CASE("outcodes: bits 3210 are above, below, right, left; the border is inside") {
  CHECK(outcode_of({0, 2}, window) == 0b1000);
  CHECK(outcode_of({0, -2}, window) == 0b0100);
  CHECK(outcode_of({3, 0}, window) == 0b0010);
  CHECK(outcode_of({-2, 0}, window) == 0b0001);
  CHECK(outcode_of({3, 2}, window) == 0b1010);
  CHECK(outcode_of({-2, 2}, window) == 0b1001);
  for (const Point2& corner : window_corners) CHECK(outcode_of(corner, window) == 0);
}

TEST_CASE("The slides' line C D: outcodes 0100 and 1010, cut at E below and, by way of F, at G on the right") {
  const Line line{{0, -2}, {4, 2}};
  CHECK(outcode_of(line.from, window) == 0b0100);
  CHECK(outcode_of(line.to, window) == 0b1010);
  const auto clipped = cohen_sutherland(line, window);
  REQUIRE(clipped.has_value());
  CHECK(clipped->from == Point2{1, -1});
  CHECK(clipped->to == Point2{2, 0});
  const auto turned = cohen_sutherland({line.to, line.from}, window);
  REQUIRE(turned.has_value());
  CHECK(turned->from == clipped->to);
  CHECK(turned->to == clipped->from);
}

TEST_CASE("Every line between lattice places: corners, borders, parallels, points") {
  Kinds kinds;
  for (int code = 0; code < 9 * 7 * 9 * 7; ++code) {
    const auto place = [](int number, int count) { return (number % count - count / 2) * 0.75 + 0.25; };
    const Line line{{place(code, 9), place(code / 9, 7) - 0.25 + 0.25 * (code % 2)},
                    {place(code / 63, 9), place(code / 567, 7) - 0.25}};
    check_all(line);
  }
  for (int code = 0; code < 6 * 5 * 6 * 5; ++code) {
    const auto across = [](int number) { return number % 6 - 2.0; };   // -2 .. 3
    const auto upwards = [](int number) { return number % 5 - 2.0; };  // -2 .. 2
    const Line line{{across(code), upwards(code / 6)}, {across(code / 30), upwards(code / 180)}};
    check_all(line);
    kinds.add(line);
  }
  CHECK(kinds.points == 30);
  CHECK(kinds.on_border > 30);
  CHECK(kinds.touching > 30);
  CHECK(kinds.unseen > 30);
  CHECK(kinds.through > 30);
}

TEST_CASE("Random lines, at thirds and sevenths of the lattice and anywhere") {
  constexpr std::uint64_t seed = 20261126;
  INFO("seed ", seed);
  lattice::Dice dice(seed);
  Kinds kinds;
  for (int i = 0; i < 20000; ++i) {
    const double unit = dice.any_of(std::array{1.0, 3.0, 7.0, 1000.0, 2e8});
    const auto coordinate = [&] {
      return dice.between(static_cast<int>(-2 * unit), static_cast<int>(3 * unit)) / unit;
    };
    Line line{{coordinate(), coordinate()}, {coordinate(), coordinate()}};
    if (dice.one_in(8)) line.to.y = line.from.y;
    if (dice.one_in(8)) line.to.x = line.from.x;
    if (dice.one_in(8)) line.from = dice.any_of(window_corners);
    check_all(line);
    kinds.add(line);
  }
  CHECK(kinds.points > 300);
  CHECK(kinds.on_border > 30);
  CHECK(kinds.touching > 300);
  CHECK(kinds.unseen > 500);
  CHECK(kinds.through > 1000);
}

TEST_CASE("Cyrus-Beck in a convex polygon: random lines, many through corners and along edges") {
  constexpr std::array<Point2, 6> hexagon{Point2{-2, 0}, Point2{-1, -2}, Point2{1, -2},
                                          Point2{2, 0},  Point2{1, 2},   Point2{-1, 2}};
  constexpr std::uint64_t seed = 7;
  INFO("seed ", seed);
  lattice::Dice dice(seed);
  int seen = 0;
  int not_seen = 0;
  for (int i = 0; i < 20000; ++i) {
    const double unit = dice.any_of(std::array{1.0, 2.0, 3.0, 2e8});
    const auto coordinate = [&] {
      return dice.between(static_cast<int>(-2 * unit), static_cast<int>(2 * unit)) * 1.5 / unit;
    };
    Line line{{coordinate(), coordinate()}, {coordinate(), coordinate()}};
    if (dice.one_in(4)) line.from = dice.any_of(hexagon);
    if (dice.one_in(4)) line.to = dice.any_of(hexagon);
    INFO(line.from.x, ",", line.from.y, " to ", line.to.x, ",", line.to.y);
    const ExactPart exact = exact_part(line, hexagon);
    check(by_cyrus_beck(line, hexagon), line, exact, roundings(line, hexagon));
    ++(exact.is_seen() ? seen : not_seen);
  }
  CHECK(seen > 1000);
  CHECK(not_seen > 1000);
}

TEST_CASE("Cyrus-Beck says where along the line, and refuses an edge without a normal") {
  const auto clipped = cyrus_beck({{-3, 0}, {5, 0}}, window);
  REQUIRE(clipped.has_value());
  CHECK(clipped->tE == 0.25);
  CHECK(clipped->tL == 0.625);
  constexpr std::array<Point2, 4> wrong{Point2{0, 0}, Point2{1, 0}, Point2{1, 0}, Point2{0, 1}};
  CHECK_THROWS_AS((void)cyrus_beck({{-3, 0}, {5, 0}}, wrong), std::invalid_argument);
}

}  // namespace sightline::tests::line_clipping_test
