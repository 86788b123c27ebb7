// A plane's form, certified: its value at a point holds the true one.
#pragma once

#include <algorithm>
#include <span>

#include "geometry/numbers/bounded.h"

namespace sightline::inline reflect {

// normal . v + constant.
struct BoundedForm {
  BoundedVector normal = BoundedVector::Zero();
  Bounded constant;

  [[nodiscard]] Bounded at(const BoundedVector& v) const { return normal.dot(v) + constant; }
  [[nodiscard]] bool is_positive_at(std::span<const Point3> points) const {
    return std::all_of(points.begin(), points.end(), [this](const Point3& p) { return at(bounded(p)).is_positive(); });
  }
  friend BoundedForm operator-(const BoundedForm& f) { return {-f.normal, -f.constant}; }
  friend BoundedForm operator-(const BoundedForm& f, const BoundedForm& g) {
    return {f.normal - g.normal, f.constant - g.constant};
  }
  friend BoundedForm operator*(const Bounded& s, const BoundedForm& f) { return {s * f.normal, s * f.constant}; }
};

}  // namespace sightline::inline reflect
