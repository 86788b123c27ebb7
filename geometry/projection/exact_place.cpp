#include "geometry/projection/exact_place.h"

#include <algorithm>
#include <cmath>

#include "geometry/numbers/bounded.h"

namespace sightline::inline geometry {

ImagePoint near_grid_point(const CertifiedPlace& place, int grid_bits) {
  return {std::llround(std::ldexp(place.x, grid_bits)), std::llround(std::ldexp(place.y, grid_bits))};
}

ExactPlace place_of(const ExactCorner& corner) { return {corner.x, corner.y, corner.w}; }

int sweep_compare(const ExactPlace& a, const ExactPlace& b) {
  const Sign by_height = sign_of(BigInteger(b.y * a.w - a.y * b.w));
  return by_height != 0 ? by_height : sign_of(BigInteger(a.x * b.w - b.x * a.w));
}

ExactLine line_through(const ExactPlace& top, const ExactPlace& bottom) {
  return {top.y * bottom.w - top.w * bottom.y, top.w * bottom.x - top.x * bottom.w,
          top.x * bottom.y - top.y * bottom.x};
}

Sign side(const ExactLine& line, const ExactPlace& place) {
  return sign_of(BigInteger(line.a * place.x + line.b * place.y + line.c * place.w));
}

// The line runs in the direction (b, -a).
Sign turn(const ExactLine& a, const ExactLine& b) { return sign_of(BigInteger(a.a * b.b - a.b * b.a)); }

ExactPlace meeting_place(const ExactLine& a, const ExactLine& b) {
  const BigInteger w = a.a * b.b - a.b * b.a;
  const BigInteger x = a.b * b.c - a.c * b.b;
  const BigInteger y = a.c * b.a - a.a * b.c;
  return w > 0 ? ExactPlace{x, y, w} : ExactPlace{-x, -y, -w};
}

// A difference of two coordinates is off by both radii, and rounds; the rest is Bounded's.
std::optional<Sign> certain_orientation(const CertifiedPlace& a, const CertifiedPlace& b, const CertifiedPlace& c) {
  const Bounded ux = Bounded(b.x, b.radius) - Bounded(a.x, a.radius);
  const Bounded uy = Bounded(b.y, b.radius) - Bounded(a.y, a.radius);
  const Bounded vx = Bounded(c.x, c.radius) - Bounded(a.x, a.radius);
  const Bounded vy = Bounded(c.y, c.radius) - Bounded(a.y, a.radius);
  return certain_sign(ux * vy - uy * vx);
}

Sign orientation(const ExactPlace& a, const ExactPlace& b, const ExactPlace& c) { return side(line_through(a, b), c); }

// A quotient below 1 is off by at most 2^-54, and every other one by 2^-53 of itself.
CertifiedPlace certified(const ExactPlace& place) {
  const double x = rounded_quotient(place.x, place.w);
  const double y = rounded_quotient(place.y, place.w);
  return {x, y, 0x1p-53 * std::max({1.0, std::fabs(x), std::fabs(y)})};
}

}  // namespace sightline::inline geometry
