#include "reflect/pyramid.h"

#include <algorithm>
#include <cmath>

namespace sightline {
namespace {

// A result rounded to nearest is off by at most half a unit in the last place: 2^-53 of its size, or half the smallest
// denormal. Twice that, and what this subtraction rounds, are covered by 2^-51 and 2^-1073.
double lower(double x) { return x - (std::abs(x) * 0x1p-51 + 0x1p-1073); }
double upper(double x) { return x + (std::abs(x) * 0x1p-51 + 0x1p-1073); }

Interval exactly(double x) { return {x, x}; }
Interval operator+(const Interval& a, const Interval& b) { return {lower(a.low + b.low), upper(a.high + b.high)}; }
Interval operator-(const Interval& a, const Interval& b) { return {lower(a.low - b.high), upper(a.high - b.low)}; }
Interval operator*(const Interval& a, const Interval& b) {
  const std::array products{a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
  // A product that is no number must not vanish in a comparison.
  for (const double product : products) {
    if (product != product) return {product, product};
  }
  const auto [low, high] = std::minmax_element(products.begin(), products.end());
  return {lower(*low), upper(*high)};
}

using Triple = std::array<Interval, 3>;

Triple exactly(const Vector3& v) { return {exactly(v.x), exactly(v.y), exactly(v.z)}; }
Interval dot(const Triple& u, const Triple& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }
Triple operator-(const Triple& u, const Triple& v) { return {u[0] - v[0], u[1] - v[1], u[2] - v[2]}; }
Triple operator*(const Interval& s, const Triple& v) { return {s * v[0], s * v[1], s * v[2]}; }
Triple cross(const Triple& u, const Triple& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

// A bound of the window as a form: `row` is X or Y, turned to point inwards, and the bound is at `place` (turned, too).
struct Bound {
  Vector3 row;
  double turn;
  double place;
};

}  // namespace

WindowPart common_part(const WindowPart& a, const WindowPart& b) {
  return {std::max(a.left, b.left), std::min(a.right, b.right), std::max(a.bottom, b.bottom), std::min(a.top, b.top)};
}

// As mirror_view.cpp has it exactly: a form l . v + d of the camera becomes l' . v + d' with n . n as a factor, where
// n . v + m is the mirror's form, l' = (n . n) l - 2 (l . n) n and d' = (n . n) d - 2 (l . n) m.
Pyramid::Pyramid(const Camera& camera, const std::array<Point3, 3>& mirror, const WindowPart& part) {
  const Triple origin = exactly(mirror[0]);
  const Triple normal = cross(exactly(mirror[1]) - origin, exactly(mirror[2]) - origin);
  const Interval height = exactly(0) - dot(normal, origin);
  const Interval norm = dot(normal, normal);
  const bool perspective = camera.projection == Projection::perspective;
  const std::array bounds{Bound{camera.right, 1, part.left}, Bound{camera.right, -1, part.right},
                          Bound{camera.up, 1, part.bottom}, Bound{camera.up, -1, part.top}};
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    // turn * (X - place * W), where W is forward . (v - origin), or 1.
    const Interval turn = exactly(bounds[i].turn);
    const Interval place = exactly(bounds[i].place);
    Triple row = exactly(bounds[i].row);
    if (perspective) row = row - place * exactly(camera.forward);
    row = turn * row;
    Interval constant = exactly(0) - dot(row, exactly(camera.origin));
    if (!perspective) constant = constant - turn * place;
    const Interval twice = exactly(2) * dot(row, normal);
    const Triple mirrored = norm * row - twice * normal;
    forms_[i] = {mirrored[0], mirrored[1], mirrored[2], norm * constant - twice * height};
  }
  forms_[4] = {normal[0], normal[1], normal[2], height};
}

bool Pyramid::is_beyond(const Form& form, const Box& box) {
  const Interval value = form[0] * Interval{box.low.x, box.high.x} + form[1] * Interval{box.low.y, box.high.y} +
                         form[2] * Interval{box.low.z, box.high.z} + form[3];
  return value.high < 0;
}

bool Pyramid::may_touch(const Box& box) const {
  return std::ranges::none_of(forms_, [&](const Form& form) { return is_beyond(form, box); });
}

}  // namespace sightline
