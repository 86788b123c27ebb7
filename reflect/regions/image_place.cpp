#include "reflect/regions/image_place.h"

#include <cmath>

#include "sweep/segments/image_decisions.h"

namespace sightline::inline reflect {
namespace {

// Returns the sign of u x v, where v = (x, y) / denominator is a place less the line's top.
Sign exact_side(const ImageLine& line, const CrossingPoint& p) {
  const Wide256 denominator(p.denominator);
  const Wide256 x = Wide256(p.base.x - line.top.x) * denominator + Wide256(p.offset_x);
  const Wide256 y = Wide256(p.base.y - line.top.y) * denominator + Wide256(p.offset_y);
  return sign_of(Wide256(Wide256(line.bottom.x - line.top.x) * y - Wide256(line.bottom.y - line.top.y) * x));
}

}  // namespace

ImagePlace grid_place(const ImagePoint& p) {
  return {{p, 0, 0, 1, static_cast<double>(p.x), static_cast<double>(p.y)}, true, {}, {}};
}

ImagePlace crossing_place(const ImageLine& a, const ImageLine& b) {
  return {crossing_point(a.top, a.bottom, b.top, b.bottom), false, a, b};
}

int sweep_compare(const ImagePlace& a, const ImagePlace& b) { return sweep_compare(a.at, b.at); }

// The filter's bound follows from |u| <= 2^42 in each coordinate; v is off by crossing_error = 2^-10 in each and by the
// rounding of a difference, at most 2^42 * 2^-53; so a product is off by 2^42 (2^-10 + 2^-11) and by its own rounding
// of at most 2^84 * 2^-53, the difference of two products by twice that and one more rounding of 2^85 * 2^-53: 2^33 +
// 2^32 + 2^32 + 2^32 < 2^35.
Sign side(const ImageLine& line, const ImagePlace& p) {
  constexpr double bound = 0x1p35;
  const auto ux = static_cast<double>(line.bottom.x - line.top.x);
  const auto uy = static_cast<double>(line.bottom.y - line.top.y);
  const double vx = p.at.x - static_cast<double>(line.top.x);
  const double vy = p.at.y - static_cast<double>(line.top.y);
  const double cross = ux * vy - uy * vx;
  if (std::fabs(cross) > bound) return cross > 0 ? 1 : -1;
  return exact_side(line, p.at);
}

Sign turn(const ImageLine& a, const ImageLine& b) {
  return ExactDecisions::turn(ExactDecisions::direction(a.top, a.bottom), ExactDecisions::direction(b.top, b.bottom));
}

}  // namespace sightline::inline reflect
