#include "geometry/projection/lens.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/numbers/bounded.h"

namespace sightline::inline geometry {
namespace {

constexpr double widest_angle = 89 * std::numbers::pi / 180;  // off the axis

using Polynomial = std::array<double, 5>;  // the constant first

template <class Number>
Number value_at(const Polynomial& polynomial, const Number& s) {
  Number sum = 0.0;
  for (std::size_t i = polynomial.size(); i-- > 0;) sum = sum * s + Number(polynomial[i]);
  return sum;
}

Polynomial derivative(const Polynomial& p) {
  Polynomial result{};
  for (std::size_t i = 1; i < p.size(); ++i) result[i - 1] = static_cast<double>(i) * p[i];
  return result;
}

// How far from the axis a base place is bent, a n(s) / d(s), s = a^2, without p and s of the lens.
struct RadialForm {
  Polynomial numerator, denominator;
  double tangential = 0;  // |p|
  double prism = 0;       // |s|

  explicit RadialForm(const Lens& lens) : numerator{1}, denominator{1} {
    if (lens.model == LensModel::field_of_view) return;
    const auto& k = lens.radial;
    const bool is_brown = lens.model == LensModel::brown;
    std::copy(k.begin(), k.begin() + (is_brown ? 3 : 4), numerator.begin() + 1);
    if (is_brown) std::copy(k.begin() + 3, k.end(), denominator.begin() + 1);
    tangential = std::hypot(lens.tangential[0], lens.tangential[1]);
    prism = std::hypot(lens.prism[0], lens.prism[1]);
  }

  [[nodiscard]] double factor(double s) const { return value_at(numerator, s) / value_at(denominator, s); }

  // The derivative of the factor by s.
  template <class Number>
  [[nodiscard]] Number slope(const Number& s) const {
    const Number n = value_at(numerator, s);
    const Number d = value_at(denominator, s);
    return (value_at(derivative(numerator), s) * d - n * value_at(derivative(denominator), s)) / (d * d);
  }

  // Returns whether (J v) . v is proven to be positive for all s of the interval.
  [[nodiscard]] bool grows_on(double low, double high) const {
    const Bounded s = bounded_around(low, high);
    const Bounded d = value_at(denominator, s);
    if (!d.is_positive()) return false;
    const Bounded across = value_at(numerator, s) / d;
    const Bounded along = across + Bounded(2) * s * slope(s);
    const Bounded least = (Bounded(6) * Bounded(tangential, hypot_radius(tangential)) +
                           Bounded(2) * Bounded(prism, hypot_radius(prism))) *
                          Bounded(std::sqrt(high) * (1 + 0x1p-48));
    return (across - least).is_positive() && (along - least).is_positive();
  }

  [[nodiscard]] double reach(double s) const { return std::sqrt(s) * factor(s) - 3 * tangential * s - prism * s; }

 private:
  // A length of two is off by a few roundings.
  static double hypot_radius(double length) { return 0x1p-50 * length; }
};

// From base places to bent ones: xy is of x' by y.
struct Jacobian {
  double xx, xy, yx, yy;
};

Jacobian jacobian(const Lens& lens, const RadialForm& form, const Point2& p) {
  const double s = p.x * p.x + p.y * p.y;
  const double f = form.factor(s);
  const double slope = form.slope(s);
  const auto& [p1, p2] = lens.tangential;
  const auto& [s1, s2] = lens.prism;
  const double across = 2 * p.x * p.y * slope + 2 * p1 * p.x + 2 * p2 * p.y;
  return {f + 2 * p.x * p.x * slope + 2 * p1 * p.y + 6 * p2 * p.x + 2 * s1 * p.x, across + 2 * s1 * p.y,
          across + 2 * s2 * p.x, f + 2 * p.y * p.y * slope + 6 * p1 * p.y + 2 * p2 * p.x + 2 * s2 * p.y};
}

double base_distance(const Lens& lens, double ideal) {
  switch (lens.model) {
    case LensModel::brown:
      return ideal;
    case LensModel::fisheye:
      return std::atan(ideal);
    case LensModel::field_of_view:
      return std::atan(2 * ideal * std::tan(lens.radial[0] / 2)) / lens.radial[0];
  }
  return 0;
}

double ideal_distance(const Lens& lens, double base) {
  switch (lens.model) {
    case LensModel::brown:
      return base;
    case LensModel::fisheye:
      return std::tan(base);
    case LensModel::field_of_view:
      return std::tan(base * lens.radial[0]) / (2 * std::tan(lens.radial[0] / 2));
  }
  return 0;
}

bool is_radial(const Lens& lens) {
  const auto is_set = [](double c) { return c != 0; };
  return std::ranges::none_of(lens.tangential, is_set) && std::ranges::none_of(lens.prism, is_set);
}

double length(const Point2& p) { return std::hypot(p.x, p.y); }

double allowed_residual(const Point2& bent) { return 1e-14 * (1 + length(bent)); }

Point2 scaled(const Point2& p, double from, double to) {
  if (from == to || from == 0) return p;
  return {to / from * p.x, to / from * p.y};
}

Point2 bent_base(const Lens& lens, const RadialForm& form, const Point2& base) {
  const auto& [x, y] = base;
  const double s = x * x + y * y;
  const double f = form.factor(s);
  const auto& [p1, p2] = lens.tangential;
  return {x * f + 2 * p1 * x * y + p2 * (s + 2 * x * x) + lens.prism[0] * s,
          y * f + p1 * (s + 2 * y * y) + 2 * p2 * x * y + lens.prism[1] * s};
}

// A step that leaves the disc of base places, or comes no nearer, is halved.
std::optional<Point2> base_place(const Lens& lens, double radius, const Point2& bent) {
  const RadialForm form(lens);
  const auto residual_at = [&](const Point2& p) {
    const Point2 q = bent_base(lens, form, p);
    return Point2{bent.x - q.x, bent.y - q.y};
  };
  const double start = std::min(1.0, 0.5 * radius / std::max(length(bent), 0x1p-500));
  Point2 p{start * bent.x, start * bent.y};
  Point2 residual = residual_at(p);
  for (int iteration = 0; iteration < 200; ++iteration) {
    const auto [xx, xy, yx, yy] = jacobian(lens, form, p);
    const double determinant = xx * yy - xy * yx;
    const Point2 step{(yy * residual.x - xy * residual.y) / determinant,
                      (xx * residual.y - yx * residual.x) / determinant};
    double share = 1;
    Point2 next;
    Point2 next_residual;
    for (; share > 0x1p-40; share /= 2) {
      next = {p.x + share * step.x, p.y + share * step.y};
      next_residual = residual_at(next);
      if (length(next) <= radius && length(next_residual) < length(residual)) break;
    }
    if (share <= 0x1p-40) break;
    p = next;
    residual = next_residual;
  }
  if (!(length(residual) <= allowed_residual(bent))) return std::nullopt;
  return p;
}

// Where there are neither p nor s, the bent distance grows with a, so halving finds a; one step of Newton's method makes it as right as doubles are.
std::optional<Point2> ideal_place_of_fisheye(const Lens& lens, const LensDisc& disc, const Point2& bent) {
  const RadialForm form(lens);
  const double distance = length(bent);
  if (distance == 0) return Point2{0, 0};
  const auto bent_distance = [&](double a) { return a * form.factor(a * a); };
  double low = 0;
  double high = std::atan(disc.radius);
  if (bent_distance(high) < distance) return std::nullopt;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (bent_distance(middle) < distance ? low : high) = middle;
  }
  const double s = high * high;
  const double angle = high + (distance - bent_distance(high)) / (form.factor(s) + 2 * s * form.slope(s));
  const double scale = std::tan(angle) / distance;
  return Point2{scale * bent.x, scale * bent.y};
}

}  // namespace

bool bends(const Lens& lens) {
  const auto is_set = [](double c) { return c != 0; };
  return lens.model != LensModel::brown || std::ranges::any_of(lens.radial, is_set) || !is_radial(lens);
}

const char* to_string(LensModel model) {
  switch (model) {
    case LensModel::brown:
      return "brown";
    case LensModel::fisheye:
      return "fisheye";
    case LensModel::field_of_view:
      return "field_of_view";
  }
  return "";
}

Point2 bent_place(const Lens& lens, const Point2& ideal) {
  const RadialForm form(lens);
  const double r = std::sqrt(ideal.x * ideal.x + ideal.y * ideal.y);
  if (lens.model == LensModel::fisheye && is_radial(lens)) {
    const double angle = std::atan(r);
    const double scale = r > 0 ? angle * form.factor(angle * angle) / r : 1;
    return {scale * ideal.x, scale * ideal.y};
  }
  return bent_base(lens, form, scaled(ideal, r, base_distance(lens, r)));
}

LensDisc proven_disc(const Lens& lens, double bent_radius) {
  const RadialForm form(lens);
  const double widest = lens.model == LensModel::fisheye ? widest_angle : base_distance(lens, std::tan(widest_angle));
  const auto disc = [&](double s, LensDisc::End end) {
    return LensDisc{ideal_distance(lens, std::sqrt(s)), form.reach(s), end};
  };
  double proven = 0;
  double step = 0x1p-6;
  while (proven < widest * widest) {
    const double next = std::min(proven + step, widest * widest);
    if (!form.grows_on(proven, next)) {
      step /= 2;
      if (step < 0x1p-40 * std::max(proven, 0x1p-40)) return disc(proven, LensDisc::End::folds);
      continue;
    }
    proven = next;
    step *= 2;
    if (form.reach(proven) >= bent_radius) return disc(proven, LensDisc::End::reaches);
  }
  return disc(proven, LensDisc::End::too_wide);
}

std::optional<Point2> ideal_place(const Lens& lens, const LensDisc& disc, const Point2& bent) {
  if (lens.model == LensModel::fisheye && is_radial(lens)) return ideal_place_of_fisheye(lens, disc, bent);
  const auto base = base_place(lens, base_distance(lens, disc.radius), bent);
  if (!base) return std::nullopt;
  return scaled(*base, length(*base), ideal_distance(lens, length(*base)));
}

}  // namespace sightline::inline geometry
