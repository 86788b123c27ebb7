#include "reflect/mirror_cell.h"

#include <cmath>

namespace sightline {
namespace {

Point2 in_window(const ImagePoint& p, int grid_bits) {
  return {std::ldexp(static_cast<double>(p.x), -grid_bits), std::ldexp(static_cast<double>(p.y), -grid_bits)};
}

// > 0 where the ray passes the edge from p to q on the left, seen along the ray.
double passing_side(const MirroredRay& ray, const Point3& p, const Point3& q) {
  return -dot(ray.direction, cross(p - ray.point, q - ray.point));
}

// Two directions that span the plane across a unit vector.
std::array<Vector3, 2> spanning(const Vector3& normal) {
  const bool is_along_x = std::fabs(normal.x) > std::fabs(normal.y);
  const Vector3 first = cross(normal, is_along_x ? Vector3{0, 1, 0} : Vector3{1, 0, 0});
  return {first, cross(normal, first)};
}

}  // namespace

MirrorCell::MirrorCell(const ImagePoint& low, std::int64_t size, const SmoothRays& rays, const PolygonOutline& outline,
                       int grid_bits)
    : grid_bits_(grid_bits),
      outline_(outline),
      places_{low, {low.x + size, low.y}, {low.x + size, low.y + size}, {low.x, low.y + size}} {
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const Point2 place = in_window(places_[i], grid_bits);
    const std::optional<MirroredRay> ray = rays.at(place.x, place.y);
    is_known_ = is_known_ && ray.has_value();
    rays_[i] = ray.value_or(MirroredRay{});
  }
}

std::array<std::size_t, 3> MirrorCell::corners_of(std::size_t half) const {
  return half == 0 ? std::array<std::size_t, 3>{0, 1, 3} : std::array<std::size_t, 3>{2, 3, 1};
}

RightTriangle MirrorCell::half(std::size_t half) const {
  const auto [corner, along_x, along_y] = corners_of(half);
  return {places_[corner], places_[along_x], places_[along_y]};
}

LinearPart MirrorCell::reflecting(std::size_t half, const std::vector<Point3>& polygon, PolygonSide side) const {
  const std::array<std::size_t, 3> corners = corners_of(half);
  const auto values = [&](auto value_at) {
    return CornerValues{value_at(rays_[corners[0]]), value_at(rays_[corners[1]]), value_at(rays_[corners[2]])};
  };
  const double turn = side == PolygonSide::front ? 1 : -1;
  std::vector<CornerValues> functions{values([](const MirroredRay& ray) { return ray.rise; })};
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point3& p = polygon[i];
    const Point3& q = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    functions.push_back(values([&](const MirroredRay& ray) { return turn * passing_side(ray, p, q); }));
  }
  const RightTriangle triangle = this->half(half);
  std::vector<CornerValues> domain;
  for (const PolygonOutline::Side& bound : outline_.bounds()) {
    const auto distance = [&](const ImagePoint& p) {
      return bound.left_of({static_cast<double>(p.x), static_cast<double>(p.y)});
    };
    domain.push_back({distance(triangle[0]), distance(triangle[1]), distance(triangle[2])});
  }
  return linear_part(triangle, functions, domain, grid_bits_);
}

// Linear between the corners: what all corners' rays pass on one side, all the cell's rays do.
MirrorCell::Reach::Reach(const MirrorCell& cell, const Camera& camera, const std::array<Point3, 3>& mirror,
                         double scale) {
  for (std::size_t i = 0; i < cell.places_.size(); ++i) {
    const Point2 place = in_window(cell.places_[i], cell.grid_bits_);
    const WindowPart part{place.x, place.x, place.y, place.y};
    const MirroredRay& ray = cell.rays_[i];
    const auto [u, v] = spanning(ray.normal);
    const double unit = 1 / scale;
    corners_.emplace_back(camera, std::array{unit * ray.place, unit * (ray.place + u), unit * (ray.place + v)}, part);
  }
  const Point2 low = in_window(cell.places_[0], cell.grid_bits_);
  const Point2 high = in_window(cell.places_[2], cell.grid_bits_);
  corners_.emplace_back(camera, mirror, WindowPart{low.x, high.x, low.y, high.y});
}

bool MirrorCell::Reach::may_touch(const Box& box) const {
  if ((corners_.back().sides_before(box) & Pyramid::behind_mirror) != 0) return false;
  unsigned sides = Pyramid::behind_mirror - 1;
  for (std::size_t i = 0; i + 1 < corners_.size(); ++i) sides &= corners_[i].sides_before(box);
  return sides == 0;
}

}  // namespace sightline
