#include "reflect/smooth/mirror_cell.h"

#include <algorithm>
#include <cmath>

namespace sightline::inline reflect {
namespace {

Point2 in_window(const ImagePoint& p, int grid_bits) {
  return {std::ldexp(static_cast<double>(p.x), -grid_bits), std::ldexp(static_cast<double>(p.y), -grid_bits)};
}

// Returns the corners of a half of the cell: the right angle's, then its neighbours along x and along y.
std::array<std::size_t, 3> corners_of(std::size_t half) {
  return half == 0 ? std::array<std::size_t, 3>{0, 1, 3} : std::array<std::size_t, 3>{2, 3, 1};
}

// Returns a number > 0 where the ray passes the edge from p to q on the left, seen along the ray.
double passing_side(const MirroredRay& ray, const Point3& p, const Point3& q) {
  return -ray.direction.dot((p - ray.point).cross(q - ray.point));
}

// Returns the plane through the ray and a direction beside it, with another direction in front.
PlaneForm plane_beside(const MirroredRay& ray, const Vector3& direction, const Vector3& front) {
  const Vector3 normal = ray.direction.cross(direction);
  return plane_across(normal.dot(front) < 0 ? -1 * normal : normal, ray.point);
}

}  // namespace

MirrorCell::MirrorCell(const ImagePoint& low, std::int64_t size, const SmoothRays& rays, const PolygonOutline& outline,
                       int grid_bits)
    : grid_bits_(grid_bits),
      outline_(outline),
      places_{low, {low.x + size, low.y}, {low.x + size, low.y + size}, {low.x, low.y + size}} {
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const Point2 place = in_window(places_[i], grid_bits);
    const std::optional<MirroredRay> ray = rays.ray_at(place.x, place.y);
    is_known_ = is_known_ && ray.has_value();
    rays_[i] = ray.value_or(MirroredRay{});
    upright_[i] = plane_beside(rays_[i], rays_[i].upward, rays_[i].rightward);
    level_[i] = plane_beside(rays_[i], rays_[i].rightward, rays_[i].upward);
  }
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

// Everything is linear between the corners: what all corners' rays pass on one side, all the cell's rays do.
bool MirrorCell::may_reach(const Box& box) const {
  const auto is_behind = [&](const PlaneForm& plane) { return plane.highest(box) < 0; };
  const auto is_in_front = [&](const PlaneForm& plane) { return plane.lowest(box) > 0; };
  return !std::ranges::all_of(upright_, is_behind) && !std::ranges::all_of(upright_, is_in_front) &&
         !std::ranges::all_of(level_, is_behind) && !std::ranges::all_of(level_, is_in_front);
}

}  // namespace sightline::inline reflect
