#include "sweep/segments/crossing_point.h"

#include <cmath>

namespace sightline::inline sweep {
namespace {

Int128 cross(std::int64_t ax, std::int64_t ay, std::int64_t bx, std::int64_t by) {
  return static_cast<Int128>(ax) * by - static_cast<Int128>(ay) * bx;
}

// Returns the sign of a coordinate of a minus that of b, each base + offset / denominator.
Sign compare_coordinate(std::int64_t base_difference, Int128 offset_a, Int128 denominator_a, Int128 offset_b,
                        Int128 denominator_b) {
  const Wide256 da(denominator_a);
  const Wide256 db(denominator_b);
  return sign_of(Wide256(Wide256(base_difference) * da * db + Wide256(offset_a) * db - Wide256(offset_b) * da));
}

// The share says how far along the first edge the edges cross.
struct Share {
  Int128 numerator;
  Int128 denominator;  // > 0
};

Share share_of_first(const ImagePoint& top_a, const ImagePoint& bottom_a, const ImagePoint& top_b,
                     const ImagePoint& bottom_b) {
  const std::int64_t bx = bottom_b.x - top_b.x;
  const std::int64_t by = bottom_b.y - top_b.y;
  Int128 denominator = cross(bottom_a.x - top_a.x, bottom_a.y - top_a.y, bx, by);
  Int128 numerator = cross(top_b.x - top_a.x, top_b.y - top_a.y, bx, by);
  if (denominator < 0) {
    denominator = -denominator;
    numerator = -numerator;
  }
  return {numerator, denominator};
}

// Returns whether the ends of b lie strictly on different sides of a.
bool separates(const ProjectedScene& scene, EdgeId a, EdgeId b) {
  const auto side = [&](PointId p) {
    return orientation(scene.point(scene.edge(a).top), scene.point(scene.edge(a).bottom), scene.point(p));
  };
  return side(scene.edge(b).top) * side(scene.edge(b).bottom) < 0;
}

double rounded(std::int64_t base, Int128 offset, Int128 denominator) {
  return static_cast<double>(base) + static_cast<double>(offset) / static_cast<double>(denominator);
}

}  // namespace

CrossingPoint crossing_point(const ImagePoint& top_a, const ImagePoint& bottom_a, const ImagePoint& top_b,
                             const ImagePoint& bottom_b) {
  const auto [numerator, denominator] = share_of_first(top_a, bottom_a, top_b, bottom_b);
  CrossingPoint c{top_a, (bottom_a.x - top_a.x) * numerator, (bottom_a.y - top_a.y) * numerator, denominator, 0, 0};
  c.x = rounded(top_a.x, c.offset_x, denominator);
  c.y = rounded(top_a.y, c.offset_y, denominator);
  return c;
}

CrossingPoint crossing_point(const ProjectedScene& scene, EdgeId a, EdgeId b) {
  const SceneEdge& of_a = scene.edge(a);
  const SceneEdge& of_b = scene.edge(b);
  return crossing_point(scene.point(of_a.top), scene.point(of_a.bottom), scene.point(of_b.top),
                        scene.point(of_b.bottom));
}

bool cross_inside_both(const ProjectedScene& scene, EdgeId a, EdgeId b) {
  return separates(scene, a, b) && separates(scene, b, a);
}

double crossing_height(const ImagePoint& top_a, const ImagePoint& bottom_a, const ImagePoint& top_b,
                       const ImagePoint& bottom_b) {
  const auto [numerator, denominator] = share_of_first(top_a, bottom_a, top_b, bottom_b);
  return rounded(top_a.y, (bottom_a.y - top_a.y) * numerator, denominator);
}

int sweep_compare(const CrossingPoint& crossing, const ImagePoint& point) {
  const Sign y = sign_of(static_cast<Int128>(point.y - crossing.base.y) * crossing.denominator - crossing.offset_y);
  if (y != 0) return y;
  return sign_of(crossing.offset_x - static_cast<Int128>(point.x - crossing.base.x) * crossing.denominator);
}

int crossing_tiers::exact(const CrossingPoint& a, const CrossingPoint& b) {
  const Sign y = compare_coordinate(b.base.y - a.base.y, b.offset_y, b.denominator, a.offset_y, a.denominator);
  if (y != 0) return y;
  return compare_coordinate(a.base.x - b.base.x, a.offset_x, a.denominator, b.offset_x, b.denominator);
}

int sweep_compare(const CrossingPoint& a, const CrossingPoint& b) {
  const double y = b.y - a.y;
  if (std::fabs(y) > crossing_order_bound) return y > 0 ? 1 : -1;
  return crossing_tiers::exact(a, b);
}

}  // namespace sightline::inline sweep
