#include "reconstruct/polygons/ring_measure.h"

#include <cmath>

namespace sightline::inline reconstruct {
namespace {

constexpr double difference_error = 2 * crossing_error + 0x1p-11;
// This is what the bounds' own rounding may take away.
constexpr double bound_margin = 1 + 0x1p-20;

}  // namespace

RingMeasure& RingMeasure::operator+=(const RingMeasure& other) {
  twice_area += other.twice_area;
  perimeter += other.perimeter;
  differences += other.differences;
  products += other.products;
  terms += other.terms;
  return *this;
}

double RingMeasure::area_error() const {
  const auto n = static_cast<double>(terms);
  const double of_points = difference_error * differences + 2 * difference_error * difference_error * n;
  return bound_margin * (of_points + (n + 2) * 0x1p-53 * products);
}

double RingMeasure::perimeter_error() const {
  const auto n = static_cast<double>(terms);
  return bound_margin * (2 * difference_error * n + (n + 2) * 0x1p-53 * perimeter);
}

RingMeasure measure(const ImagePoints& points, const VisibleSegments& segments, std::span<const SegmentId> ring) {
  RingMeasure m;
  const Point2 origin = points.approximate(segments.segments[ring.front().index()].start);
  for (const SegmentId s : ring) {
    const Point2 a = points.approximate(segments.segments[s.index()].start);
    const Point2 b = points.approximate(segments.segments[s.index()].end);
    const Point2 u{a.x - origin.x, a.y - origin.y};
    const Point2 v{b.x - origin.x, b.y - origin.y};
    m.twice_area += u.x * v.y - u.y * v.x;
    m.perimeter += std::hypot(b.x - a.x, b.y - a.y);
    m.differences += (std::fabs(u.x) + std::fabs(u.y)) + (std::fabs(v.x) + std::fabs(v.y));
    m.products += std::fabs(u.x * v.y) + std::fabs(u.y * v.x);
  }
  m.terms = ring.size();
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
  const RingMeasure m = measure(points, segments, ring);
  if (std::fabs(m.twice_area) > m.area_error()) return sign_of(m.twice_area);
  return sign_of(exact_twice_area(points, segments, ring).numerator);
}

}  // namespace sightline::inline reconstruct
