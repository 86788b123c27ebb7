#include "sweep/segments/image_points.h"

#include <algorithm>
#include <cmath>

#include "geometry/numbers/parallel.h"
#include "geometry/projection/unrounded_points.h"
#include "sweep/segments/image_decisions.h"

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

// On the grid a difference of two approximate coordinates is off by two crossing errors and its own rounding.
std::optional<Sign> certain_orientation_on_grid(const Point2& a, const Point2& b, const Point2& c) {
  constexpr double difference_error = 2 * crossing_error + 0x1p-11;
  const double ux = b.x - a.x;
  const double uy = b.y - a.y;
  const double vx = c.x - a.x;
  const double vy = c.y - a.y;
  const double left = ux * vy;
  const double right = uy * vx;
  const double bound =
      difference_error * ((std::fabs(ux) + std::fabs(uy)) + (std::fabs(vx) + std::fabs(vy))) * (1 + 0x1p-20) +
      2 * difference_error * difference_error + 0x1p-51 * (std::fabs(left) + std::fabs(right));
  if (std::fabs(left - right) > bound) return left > right ? 1 : -1;
  return std::nullopt;
}

ImagePoint direction(const ProjectedScene& scene, EdgeId e) {
  return ExactDecisions::direction(scene.point(scene.edge(e).top), scene.point(scene.edge(e).bottom));
}

}  // namespace

ImagePoints::ImagePoints(const ProjectedScene& scene, const VisibleSegments& segments)
    : scene_(&scene), segments_(&segments), order_(scene, segments) {
  const std::size_t count = segments.crossings.size();
  if (scene.is_unrounded()) {
    unrounded_ = std::make_unique<UnroundedImage>(scene, segments.swap_edges);
    places_.resize(count);
    parallel_for_each(count, [&](std::size_t c) {
      places_[c] = unrounded_->certified(UnroundedImage::Place{segments.crossings[c].a, segments.crossings[c].b});
    });
    return;
  }
  crossings_.reserve(count);
  for (const Crossing& crossing : segments.crossings)
    crossings_.push_back(crossing_point(scene, crossing.a, crossing.b));
}

const Crossing* ImagePoints::crossing(PointId p) const {
  const std::size_t vertices = scene_->points.size();
  return p.index() < vertices ? nullptr : &segments_->crossings[p.index() - vertices];
}

CertifiedPlace ImagePoints::certified(PointId p) const {
  const std::size_t vertices = scene_->points.size();
  if (unrounded_) return p.index() < vertices ? unrounded_->certified(p) : places_[p.index() - vertices];
  const Point2 grid = approximate(p);
  const auto in_window_units = [this](double value) { return std::ldexp(value, -scene_->grid_bits); };
  return {in_window_units(grid.x), in_window_units(grid.y), in_window_units(crossing_error)};
}

Point2 ImagePoints::in_window(PointId p) const {
  if (p.index() < scene_->points.size() && !unrounded_) {
    const CertifiedPlace place = certified(p);
    return {place.x, place.y};
  }
  if (const Crossing* const made = crossing(p); made != nullptr && unrounded_) {
    if (const auto rounded = unrounded_->rounded({made->a, made->b})) return *rounded;
  }
  const ExactPlace place = exact(p);
  return {rounded_quotient(place.x, place.w), rounded_quotient(place.y, place.w)};
}

ExactPlace ImagePoints::exact(PointId p) const {
  const Crossing* const made = crossing(p);
  if (made == nullptr) return unrounded_ ? unrounded_->exact(p) : exact_place(*scene_, p);
  return unrounded_ ? unrounded_->exact(UnroundedImage::Place{made->a, made->b}) : exact_place(*scene_, *segments_, p);
}

bool ImagePoints::is_named_by(EdgeId e, PointId p) const {
  if (const Crossing* const made = crossing(p)) return made->a == e || made->b == e;
  return e.index() < scene_->edge_count() && (scene_->edge(e).top == p || scene_->edge(e).bottom == p);
}

// Crossings of one edge are on one line, which no filter finds.
bool ImagePoints::are_on_one_edge(PointId a, PointId b, PointId c) const {
  for (const PointId p : {a, b, c}) {
    const Crossing* const made = crossing(p);
    if (made == nullptr) continue;
    const auto has_all = [&](EdgeId e) { return is_named_by(e, a) && is_named_by(e, b) && is_named_by(e, c); };
    return has_all(made->a) || has_all(made->b);
  }
  return false;
}

Sign ImagePoints::orientation(PointId a, PointId b, PointId c) const {
  if (a == b || b == c || a == c) return 0;
  if (unrounded_) {
    if (const auto sign = certain_orientation(certified(a), certified(b), certified(c))) return *sign;
    return are_on_one_edge(a, b, c) ? 0 : geometry::orientation(exact(a), exact(b), exact(c));
  }
  const auto sign = certain_orientation_on_grid(approximate(a), approximate(b), approximate(c));
  if (sign) return *sign;
  const auto place = [this](PointId p) { return exact_point(*scene_, *segments_, p); };
  return exact_orientation(place(a), place(b), place(c));
}

Sign ImagePoints::turn(EdgeId a, EdgeId b) const {
  return unrounded_ ? unrounded_->turn(a, b) : ExactDecisions::turn(direction(*scene_, a), direction(*scene_, b));
}

Sign ImagePoints::side(EdgeId e, PointId p) const {
  const Crossing* const made = crossing(p);
  if (made != nullptr && (made->a == e || made->b == e)) return 0;
  if (!unrounded_) return orientation(scene_->edge(e).top, scene_->edge(e).bottom, p);
  return made == nullptr ? unrounded_->side(e, p) : unrounded_->side(e, UnroundedImage::Place{made->a, made->b});
}

ExactPlace exact_place(const ProjectedScene& scene, const VisibleSegments& segments, PointId p) {
  if (p.index() < scene.points.size()) return exact_place(scene, p);
  if (scene.is_unrounded()) {
    const Crossing& crossing = segments.crossings[p.index() - scene.points.size()];
    return UnroundedImage(scene, segments.swap_edges).exact(UnroundedImage::Place{crossing.a, crossing.b});
  }
  const ExactPoint on_grid = exact_point(scene, segments, p);
  return {BigInteger(on_grid.x), BigInteger(on_grid.y),
          BigInteger(on_grid.denominator) << static_cast<unsigned>(scene.grid_bits)};
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
