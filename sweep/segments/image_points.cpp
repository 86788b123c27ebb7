#include "sweep/segments/image_points.h"

#include <cmath>

namespace sightline::inline sweep {
namespace {

ExactPoint homogeneous(const CrossingPoint& c) {
  return {Wide512(c.base.x * c.denominator + c.offset_x), Wide512(c.base.y * c.denominator + c.offset_y),
          Wide512(c.denominator)};
}

Sign exact_orientation(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) {
  const auto minor = [](const ExactPoint& p, const ExactPoint& q) { return Wide512(p.x * q.y - p.y * q.x); };
  return sign_of(Wide512(minor(a, b) * c.denominator + minor(b, c) * a.denominator + minor(c, a) * b.denominator));
}

}  // namespace

ImagePoints::ImagePoints(const ProjectedScene& scene, const VisibleSegments& segments)
    : scene_(&scene), order_(scene, segments) {
  crossings_.reserve(segments.crossings.size());
  for (const Crossing& crossing : segments.crossings)
    crossings_.push_back(crossing_point(scene, crossing.a, crossing.b));
}

Point2 ImagePoints::in_window(PointId p) const {
  if (p.index() < scene_->points.size()) {
    const Point2 grid = approximate(p);
    return {std::ldexp(grid.x, -scene_->grid_bits), std::ldexp(grid.y, -scene_->grid_bits)};
  }
  const ExactPoint exact_place = exact(p);
  return {std::ldexp(rounded_quotient(exact_place.x, exact_place.denominator), -scene_->grid_bits),
          std::ldexp(rounded_quotient(exact_place.y, exact_place.denominator), -scene_->grid_bits)};
}

ExactPoint ImagePoints::exact(PointId p) const {
  const std::size_t vertices = scene_->points.size();
  if (p.index() >= vertices) return homogeneous(crossings_[p.index() - vertices]);
  return {Wide512(scene_->point(p).x), Wide512(scene_->point(p).y), Wide512(1)};
}

Sign ImagePoints::orientation(PointId a, PointId b, PointId c) const {
  if (a == b || b == c || a == c) return 0;
  // A difference of two approximate coordinates is off by two crossing errors and its own rounding.
  constexpr double difference_error = 2 * crossing_error + 0x1p-11;
  const Point2 pa = approximate(a);
  const Point2 pb = approximate(b);
  const Point2 pc = approximate(c);
  const double ux = pb.x - pa.x;
  const double uy = pb.y - pa.y;
  const double vx = pc.x - pa.x;
  const double vy = pc.y - pa.y;
  const double left = ux * vy;
  const double right = uy * vx;
  const double bound =
      difference_error * ((std::fabs(ux) + std::fabs(uy)) + (std::fabs(vx) + std::fabs(vy))) * (1 + 0x1p-20) +
      2 * difference_error * difference_error + 0x1p-51 * (std::fabs(left) + std::fabs(right));
  if (std::fabs(left - right) > bound) return left > right ? 1 : -1;
  return exact_orientation(exact(a), exact(b), exact(c));
}

ExactPoint exact_point(const ProjectedScene& scene, const VisibleSegments& segments, PointId p) {
  const std::size_t vertices = scene.points.size();
  if (p.index() >= vertices) {
    const Crossing& crossing = segments.crossings[p.index() - vertices];
    return homogeneous(crossing_point(scene, crossing.a, crossing.b));
  }
  return {Wide512(scene.point(p).x), Wide512(scene.point(p).y), Wide512(1)};
}

}  // namespace sightline::inline sweep
