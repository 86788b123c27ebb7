#include "reconstruct/polygons/ring_measure.h"

#include <algorithm>
#include <cmath>

#include "sweep/unrounded/unrounded_sweep.h"

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

template <class PlaceOf>
RingMeasure measured(const VisibleSegments& segments, std::span<const SegmentId> ring, PlaceOf place_of) {
  RingMeasure m;
  const CertifiedPlace origin = place_of(segments.segments[ring.front().index()].start);
  for (const SegmentId s : ring) {
    const CertifiedPlace a = place_of(segments.segments[s.index()].start);
    const CertifiedPlace b = place_of(segments.segments[s.index()].end);
    const Difference u = a - origin;
    const Difference v = b - origin;
    m.twice_area += u.x * v.y - u.y * v.x;
    m.perimeter += length(b - a);
  }
  return m;
}

}  // namespace

RingMeasure& RingMeasure::operator+=(const RingMeasure& other) {
  twice_area += other.twice_area;
  perimeter += other.perimeter;
  return *this;
}

RingMeasure measure(const ImagePoints& points, const VisibleSegments& segments, std::span<const SegmentId> ring) {
  return measured(segments, ring, [&](PointId p) {
    const Point2 place = points.approximate(p);
    return CertifiedPlace{place.x, place.y, crossing_error};
  });
}

RingMeasure measure(const UnroundedSegments& found, std::span<const SegmentId> ring) {
  return measured(found.segments, ring, [&](PointId p) { return found.certified(p); });
}

// The sum is taken by halves, so that most of the integers stay short.
ExactArea exact_twice_area(const ImagePoints& points, const VisibleSegments& segments,
                           std::span<const SegmentId> rings) {
  if (rings.empty()) return {};
  if (rings.size() == 1) {
    const VisibleSegment& segment = segments.segments[rings.front().index()];
    const ExactPoint a = points.exact(segment.start);
    const ExactPoint b = points.exact(segment.end);
    return {BigInteger(Wide512(a.x * b.y - a.y * b.x)), BigInteger(Wide512(a.denominator * b.denominator))};
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
