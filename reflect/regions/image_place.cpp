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

// On the grid's lines a place is a fraction of grid coordinates.
bool is_on_grid_lines(const ImagePlace& p) {
  return p.image == nullptr && p.a.image == nullptr && p.b.image == nullptr;
}

// The unrounded image that a line or place knows of, if it does.
const ImagePoints* image_of(const ImageLine& line) { return line.image; }
const ImagePoints* image_of(const ImagePlace& p) {
  return p.image != nullptr ? p.image : p.a.image != nullptr ? p.a.image : p.b.image;
}
template <class A, class B>
const ImagePoints& image_of(const A& a, const B& b) {
  return image_of(a) != nullptr ? *image_of(a) : *image_of(b);
}

// What follows is in the window's units, half of which has 2^bits spacings.
int bits_of(const ImagePoints& image) { return image.scene().grid_bits; }

CertifiedPlace certified(const ImagePoint& p, int bits) {
  return {std::ldexp(static_cast<double>(p.x), -bits), std::ldexp(static_cast<double>(p.y), -bits), 0};
}
CertifiedPlace certified(const ImagePlace& p, int bits) {
  return {std::ldexp(p.at.x, -bits), std::ldexp(p.at.y, -bits), std::ldexp(p.radius, -bits)};
}

ExactPlace exact(const ImagePoint& p, int bits) { return {p.x, p.y, BigInteger(1) << static_cast<unsigned>(bits)}; }
ExactLine exact(const ImageLine& line, int bits) {
  if (line.image != nullptr) return line.image->unrounded()->exact_line(line.edge);
  return line_through(exact(line.top, bits), exact(line.bottom, bits));
}
ExactPlace exact(const ImagePlace& p, int bits) {
  if (p.image != nullptr) return p.image->exact(p.point);
  return p.on_grid ? exact(p.at.base, bits) : meeting_place(exact(p.a, bits), exact(p.b, bits));
}

UnroundedImage::Way direction(const ImageLine& line, int bits) {
  if (line.image != nullptr) return line.image->unrounded()->direction(line.edge);
  return UnroundedImage::way(certified(line.top, bits), certified(line.bottom, bits));
}

Sign unrounded_side(const ImageLine& line, const ImagePlace& p, int bits) {
  const CertifiedPlace place = certified(p, bits);
  const Bounded distance =
      line.image != nullptr
          ? line.image->unrounded()->distance_right_of(line.edge, place)
          : UnroundedImage::determinant(direction(line, bits), UnroundedImage::way(certified(line.top, bits), place));
  const auto sign = certain_sign(distance);
  return sign ? *sign : geometry::side(exact(line, bits), exact(p, bits));
}

ImagePlace unrounded_crossing(const ImageLine& a, const ImageLine& b, int bits) {
  const CertifiedPlace place = geometry::certified(meeting_place(exact(a, bits), exact(b, bits)));
  ImagePlace result;
  result.at.x = std::ldexp(place.x, bits);
  result.at.y = std::ldexp(place.y, bits);
  result.radius = std::ldexp(place.radius, bits);
  result.a = a;
  result.b = b;
  return result;
}

bool is_crossing_of(const ImagePlace& p, const ImageLine& line) {
  return p.image == nullptr && !p.on_grid && (p.a == line || p.b == line);
}

}  // namespace

ImagePlace grid_place(const ImagePoint& p) {
  ImagePlace place;
  place.at = {p, 0, 0, 1, static_cast<double>(p.x), static_cast<double>(p.y)};
  place.on_grid = true;
  return place;
}

ImageLine image_line(const ImagePoints& image, EdgeId e) {
  if (image.unrounded() != nullptr) return {{}, {}, &image, e};
  const SceneEdge& edge = image.scene().edge(e);
  return {image.scene().point(edge.top), image.scene().point(edge.bottom), nullptr, {}};
}

ImagePlace image_place(const ImagePoints& image, PointId p) {
  const ProjectedScene& scene = image.scene();
  if (image.unrounded() == nullptr) {
    if (p.index() < scene.points.size()) return grid_place(scene.point(p));
    const Crossing& crossing = image.segments().crossings[p.index() - scene.points.size()];
    return crossing_place(image_line(image, crossing.a), image_line(image, crossing.b));
  }
  const CertifiedPlace place = image.certified(p);
  ImagePlace result;
  result.at.x = std::ldexp(place.x, scene.grid_bits);
  result.at.y = std::ldexp(place.y, scene.grid_bits);
  result.radius = std::ldexp(place.radius, scene.grid_bits);
  result.image = &image;
  result.point = p;
  return result;
}

ImagePlace crossing_place(const ImageLine& a, const ImageLine& b) {
  if (a.image != nullptr || b.image != nullptr) return unrounded_crossing(a, b, bits_of(image_of(a, b)));
  ImagePlace place;
  place.at = crossing_point(a.top, a.bottom, b.top, b.bottom);
  place.a = a;
  place.b = b;
  return place;
}

int sweep_compare(const ImagePlace& a, const ImagePlace& b) {
  if (is_on_grid_lines(a) && is_on_grid_lines(b)) return sweep_compare(a.at, b.at);
  if (a.image != nullptr && a.image == b.image && a.point == b.point) return 0;
  const int by_height = compare_heights(Bounded(a.at.y, a.radius), Bounded(b.at.y, b.radius));
  if (by_height != 0) return by_height;
  const int bits = bits_of(image_of(a, b));
  return sweep_compare(exact(a, bits), exact(b, bits));
}

// The filter's bound follows from |u| <= 2^42 in each coordinate; v is off by crossing_error = 2^-10 in each and by the
// rounding of a difference, at most 2^42 * 2^-53; so a product is off by 2^42 (2^-10 + 2^-11) and by its own rounding
// of at most 2^84 * 2^-53, the difference of two products by twice that and one more rounding of 2^85 * 2^-53: 2^33 +
// 2^32 + 2^32 + 2^32 < 2^35.
Sign side(const ImageLine& line, const ImagePlace& p) {
  if (is_crossing_of(p, line)) return 0;
  if (line.image != nullptr && line.image == p.image) return line.image->side(line.edge, p.point);
  if (line.image != nullptr || !is_on_grid_lines(p)) return unrounded_side(line, p, bits_of(image_of(line, p)));
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
  if (a.image == nullptr && b.image == nullptr)
    return ExactDecisions::turn(ExactDecisions::direction(a.top, a.bottom), ExactDecisions::direction(b.top, b.bottom));
  if (a.image == b.image) return a.image->turn(a.edge, b.edge);
  const int bits = bits_of(image_of(a, b));
  const auto sign = certain_sign(UnroundedImage::determinant(direction(a, bits), direction(b, bits)));
  return sign ? *sign : geometry::turn(exact(a, bits), exact(b, bits));
}

}  // namespace sightline::inline reflect
