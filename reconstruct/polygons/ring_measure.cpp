#include "reconstruct/polygons/ring_measure.h"

#include <cmath>

namespace sightline::inline reconstruct {
namespace {

constexpr double difference_error = 2 * crossing_error + 0x1p-11;

struct Difference {
  Bounded x;
  Bounded y;
};

Difference operator-(const Point2& b, const Point2& a) {
  return {{b.x - a.x, difference_error}, {b.y - a.y, difference_error}};
}

Bounded length(const Difference& d) {
  const double value = std::hypot(d.x.value, d.y.value);
  return {value, Bounded::widened(2 * difference_error + 0x1p-52 * value)};
}

}  // namespace

RingMeasure& RingMeasure::operator+=(const RingMeasure& other) {
  twice_area += other.twice_area;
  perimeter += other.perimeter;
  return *this;
}

RingMeasure measure(const ImagePoints& points, const VisibleSegments& segments, std::span<const SegmentId> ring) {
  RingMeasure m;
  const Point2 origin = points.approximate(segments.segments[ring.front().index()].start);
  for (const SegmentId s : ring) {
    const Point2 a = points.approximate(segments.segments[s.index()].start);
    const Point2 b = points.approximate(segments.segments[s.index()].end);
    const Difference u = a - origin;
    const Difference v = b - origin;
    m.twice_area += u.x * v.y - u.y * v.x;
    m.perimeter += length(b - a);
  }
  return m;
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
