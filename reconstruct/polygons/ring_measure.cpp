#include "reconstruct/polygons/ring_measure.h"

#include <algorithm>
#include <cmath>

#include "geometry/mesh/facet_plane.h"

namespace sightline::inline reconstruct {
namespace {

struct Difference {
  Bounded x;
  Bounded y;
};

// Both coordinates have the radius of the longer one.
Difference operator-(const CertifiedPlace& b, const CertifiedPlace& a) {
  const double x = b.x - a.x;
  const double y = b.y - a.y;
  const double rounding = unit_roundoff * std::max(std::fabs(x), std::fabs(y));
  const double radius = Bounded::widened(a.radius + b.radius + rounding);
  return {{x, radius}, {y, radius}};
}

Bounded length(const Difference& d) {
  const double value = std::hypot(d.x.value, d.y.value);
  return {value, Bounded::widened(d.x.radius + d.y.radius + 0x1p-52 * value)};
}

}  // namespace

RingMeasure& RingMeasure::operator+=(const RingMeasure& other) {
  twice_area += other.twice_area;
  perimeter += other.perimeter;
  return *this;
}

RingMeasure measure(const ImagePoints& points, const VisibleSegments& segments, std::span<const SegmentId> ring) {
  RingMeasure m;
  const CertifiedPlace origin = points.certified(segments.segments[ring.front().index()].start);
  for (const SegmentId s : ring) {
    const CertifiedPlace a = points.certified(segments.segments[s.index()].start);
    const CertifiedPlace b = points.certified(segments.segments[s.index()].end);
    const Difference u = a - origin;
    const Difference v = b - origin;
    m.twice_area += u.x * v.y - u.y * v.x;
    m.perimeter += length(b - a);
  }
  return m;
}

namespace {

// Returns twice the area of what is in view of a surface over its perimeter. Precondition: nothing is rounded.
double width_in_view(const ProjectedScene& scene, FacetId surface) {
  double twice_area = 0;
  double perimeter = 0;
  for (std::size_t f = surface.index(); f < end_of_surface(scene.mesh(), surface).index(); ++f) {
    const auto polygon = scene.polygon(FacetId(f));
    const auto place = [&](std::size_t i) {
      return scene.unrounded.places[polygon[i == polygon.size() ? 0 : i].point.index()];
    };
    Bounded twice_of_facet;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      perimeter += length(place(i + 1) - place(i)).value;
      const Difference u = place(i) - place(0);
      const Difference v = place(i + 1) - place(0);
      twice_of_facet += u.x * v.y - u.y * v.x;
    }
    twice_area += std::fabs(twice_of_facet.value);
  }
  return twice_area / perimeter;
}

}  // namespace

bool is_below_resolution(const ProjectedScene& scene, FacetId surface, double area, double perimeter) {
  constexpr double least_part = 0x1p-10;
  const double twice_area = 2 * area;
  if (!(twice_area < std::ldexp(perimeter, -scene.grid_bits))) return false;
  return !scene.is_unrounded() || twice_area < least_part * width_in_view(scene, surface) * perimeter;
}

// The sum is taken by halves, so that most of the integers stay short.
ExactArea exact_twice_area(const ImagePoints& points, const VisibleSegments& segments,
                           std::span<const SegmentId> rings) {
  if (rings.empty()) return {};
  if (rings.size() == 1) {
    const VisibleSegment& segment = segments.segments[rings.front().index()];
    const ExactPlace a = points.exact(segment.start);
    const ExactPlace b = points.exact(segment.end);
    return {a.x * b.y - a.y * b.x, a.w * b.w};
  }
  const std::size_t half = rings.size() / 2;
  const ExactArea a = exact_twice_area(points, segments, rings.first(half));
  const ExactArea b = exact_twice_area(points, segments, rings.subspan(half));
  return {a.numerator * b.denominator + b.numerator * a.denominator, a.denominator * b.denominator};
}

Sign area_sign(const ImagePoints& points, const VisibleSegments& segments, std::span<const SegmentId> ring) {
  const auto sign = certain_sign(measure(points, segments, ring).twice_area);
  return sign ? *sign : sign_of(exact_twice_area(points, segments, ring).numerator);
}

}  // namespace sightline::inline reconstruct
