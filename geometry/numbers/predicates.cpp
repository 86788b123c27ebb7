#include "geometry/numbers/predicates.h"

#include <limits>
#include "geometry/numbers/rounding.h"

namespace sightline::inline geometry {
namespace {

// In double, orient3d takes differences (1 rounding each), 2x2 minors (2 more), a product with a difference (1) and
// sums (2). Expanded, the error is at most (7 + 56 u) u times the permanent, the same expression with absolute values
// (Shewchuk 1997, theorem on orient3d's stage A); 8 u covers it and the roundings of the bound itself.
constexpr double orient3d_bound = 8 * unit_roundoff;
static_assert(orient3d_bound >= (7 + 56 * unit_roundoff) * unit_roundoff * (1 + 8 * unit_roundoff));

// The error of orient2d is at most (3 + 16 u) u times the permanent (Shewchuk 1997); 4 u covers it.
constexpr double orient2d_bound = 4 * unit_roundoff;
static_assert(orient2d_bound >= (3 + 16 * unit_roundoff) * unit_roundoff * (1 + 8 * unit_roundoff));

// The error of in_circle is at most (10 + 96 u) u times the permanent (Shewchuk 1997); 11 u covers it.
constexpr double in_circle_bound = 11 * unit_roundoff;
static_assert(in_circle_bound >= (10 + 96 * unit_roundoff) * unit_roundoff * (1 + 8 * unit_roundoff));
// The bounds above suppose that nothing over- or underflows. With all differences below 2^340 no product of three
// overflows; an underflow in a product of two costs at most 2^-1074, times a difference 2^-734, and there are fewer
// than 2^4 of them: less than 2^-700 in all.
constexpr double largest_difference = 0x1p340;
constexpr double underflow_bound = 0x1p-700;
// In in_circle, with differences below 2^180, a lift is below 2^361, and so is a minor. An underflow in one costs at
// most 2^-1074 times the other, less than 2^-713, and there are fewer than 2^4 of them: less than 2^-700 in all.
constexpr double largest_in_circle_difference = 0x1p180;

bool in_range(const Vector3& v) {
  return std::fabs(v.x()) < largest_difference && std::fabs(v.y()) < largest_difference &&
         std::fabs(v.z()) < largest_difference;
}

// Points in one plane across an axis make a column of exact zeros (a difference rounds to zero only where it is zero).
bool share_zero_coordinate(const Vector3& u, const Vector3& v, const Vector3& w) {
  return (u.x() == 0 && v.x() == 0 && w.x() == 0) || (u.y() == 0 && v.y() == 0 && w.y() == 0) ||
         (u.z() == 0 && v.z() == 0 && w.z() == 0);
}

std::optional<Sign> decide(double value, double bound) {
  if (value > bound) return 1;
  if (value < -bound) return -1;
  return std::nullopt;
}

template <class Integer>
Integer determinant(const std::array<Integer, 9>& m) {
  return m[0] * (m[4] * m[8] - m[5] * m[7]) + m[1] * (m[5] * m[6] - m[3] * m[8]) + m[2] * (m[3] * m[7] - m[4] * m[6]);
}

}  // namespace

namespace predicates::filter {

std::optional<Sign> orient3d(const Point3& a, const Point3& b, const Point3& c, const HomogeneousPoint& d) {
  const Vector3 u = b - a;
  const Vector3 v = c - a;
  const Vector3 w = d.w == 0 ? d.xyz : d.xyz - a;
  if (!in_range(u) || !in_range(v) || !in_range(w)) return std::nullopt;
  if (share_zero_coordinate(u, v, w)) return 0;
  const double vw = v.y() * w.z();
  const double wv = v.z() * w.y();
  const double vw2 = v.z() * w.x();
  const double wv2 = v.x() * w.z();
  const double vw3 = v.x() * w.y();
  const double wv3 = v.y() * w.x();
  const double det = (u.x() * (vw - wv) + u.y() * (vw2 - wv2)) + u.z() * (vw3 - wv3);
  const double permanent =
      (std::fabs(u.x()) * (std::fabs(vw) + std::fabs(wv)) + std::fabs(u.y()) * (std::fabs(vw2) + std::fabs(wv2))) +
      std::fabs(u.z()) * (std::fabs(vw3) + std::fabs(wv3));
  return decide(det, orient3d_bound * permanent + underflow_bound);
}

std::optional<Sign> orient2d(const Point2& a, const Point2& b, const Point2& c) {
  const Point2 u{b.x - a.x, b.y - a.y};
  const Point2 v{c.x - a.x, c.y - a.y};
  if ((u.x == 0 || v.y == 0) && (u.y == 0 || v.x == 0)) return 0;
  const double left = u.x * v.y;
  const double right = u.y * v.x;
  const double bound = orient2d_bound * (std::fabs(left) + std::fabs(right)) + underflow_bound;
  if (!(bound < std::numeric_limits<double>::infinity())) return std::nullopt;
  return decide(left - right, bound);
}

std::optional<Sign> in_circle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  double det = 0;
  double permanent = 0;
  const std::array points{&a, &b, &c};
  for (std::size_t i = 0; i < 3; ++i) {
    const Point2 p{points[i]->x - d.x, points[i]->y - d.y};
    const Point2 q{points[(i + 1) % 3]->x - d.x, points[(i + 1) % 3]->y - d.y};
    const Point2 r{points[(i + 2) % 3]->x - d.x, points[(i + 2) % 3]->y - d.y};
    if (!(std::fabs(p.x) < largest_in_circle_difference && std::fabs(p.y) < largest_in_circle_difference))
      return std::nullopt;
    const double lift = p.x * p.x + p.y * p.y;
    const double left = q.x * r.y;
    const double right = q.y * r.x;
    det += lift * (left - right);
    permanent += lift * (std::fabs(left) + std::fabs(right));
  }
  return decide(det, in_circle_bound * permanent + underflow_bound);
}

}  // namespace predicates::filter

namespace predicates::exact {

// With coordinates of B bits the differences have B + 1 and the determinant 3 (B + 1) + 3.
Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const HomogeneousPoint& d) {
  const std::array values{a.x(), a.y(), a.z(), b.x(),     b.y(),     b.z(),
                          c.x(), c.y(), c.z(), d.xyz.x(), d.xyz.y(), d.xyz.z()};
  const auto polynomial = [w = d.w](const auto& p) {
    using Integer = std::decay_t<decltype(p[0])>;
    const auto last = [&](std::size_t i) { return w == 0 ? p[9 + i] : Integer(p[9 + i] - p[i]); };
    return determinant<Integer>({Integer(p[3] - p[0]), Integer(p[4] - p[1]), Integer(p[5] - p[2]), Integer(p[6] - p[0]),
                                 Integer(p[7] - p[1]), Integer(p[8] - p[2]), last(0), last(1), last(2)});
  };
  return exact_sign(values, polynomial, [](int bits) { return 3 * (bits + 1) + 3; });
}

Sign orient2d(const Point2& a, const Point2& b, const Point2& c) {
  const std::array values{a.x, a.y, b.x, b.y, c.x, c.y};
  const auto polynomial = [](const auto& p) {
    using Integer = std::decay_t<decltype(p[0])>;
    return Integer((p[2] - p[0]) * (p[5] - p[1]) - (p[3] - p[1]) * (p[4] - p[0]));
  };
  return exact_sign(values, polynomial, [](int bits) { return 2 * (bits + 1) + 1; });
}

// Differences have B + 1 bits and are lifted to 2 (B + 1) + 1; these are multiplied by a minor of as many bits, and
// three such products are added.
Sign in_circle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const std::array values{a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y};
  const auto polynomial = [](const auto& p) {
    using Integer = std::decay_t<decltype(p[0])>;
    std::array<Integer, 9> m;
    for (std::size_t i = 0; i < 3; ++i) {
      m[3 * i] = p[2 * i] - p[6];
      m[3 * i + 1] = p[2 * i + 1] - p[7];
      m[3 * i + 2] = m[3 * i] * m[3 * i] + m[3 * i + 1] * m[3 * i + 1];
    }
    return determinant(m);
  };
  return exact_sign(values, polynomial, [](int bits) { return 4 * (bits + 1) + 4; });
}

}  // namespace predicates::exact

Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const HomogeneousPoint& d,
              predicates::Counts* counts) {
  const auto fast = predicates::filter::orient3d(a, b, c, d);
  if (counts != nullptr) {
    ++counts->calls;
    counts->filtered += fast.has_value() ? 1 : 0;
  }
  return fast ? *fast : predicates::exact::orient3d(a, b, c, d);
}

Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d, predicates::Counts* counts) {
  return orient3d(a, b, c, HomogeneousPoint{d, 1}, counts);
}

Sign orient2d(const Point2& a, const Point2& b, const Point2& c) {
  const auto fast = predicates::filter::orient2d(a, b, c);
  return fast ? *fast : predicates::exact::orient2d(a, b, c);
}

Sign in_circle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const auto fast = predicates::filter::in_circle(a, b, c, d);
  return fast ? *fast : predicates::exact::in_circle(a, b, c, d);
}

bool collinear(const Point3& a, const Point3& b, const Point3& c) {
  for (const int axis : {0, 1, 2}) {
    if (orient2d(drop_axis(a, axis), drop_axis(b, axis), drop_axis(c, axis)) != 0) return false;
  }
  return true;
}

}  // namespace sightline::inline geometry
