#include "reflect/exact/mirrored_forms.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "reflect/exact/mirror_view.h"

namespace sightline::inline reflect {
namespace {

bool is_perspective(const Camera& camera) { return camera.projection == Projection::perspective; }

// Returns the integer nearest to 2^grid_bits ratio, ties away from zero, if all of the ball has the same. The sum with
// 1/2 has twice the radius that its rounding needs: the ends' own rounding is no larger.
std::optional<std::int64_t> certain_coordinate(const Ball& ratio, int grid_bits) {
  const Ball size{std::ldexp(std::abs(ratio.middle), grid_bits), std::ldexp(ratio.radius, grid_bits)};
  const Ball shifted = size + exactly(0.5);
  const double low = std::floor(shifted.middle - Ball::widened(shifted.radius));
  const double high = std::floor(shifted.middle + Ball::widened(shifted.radius));
  if (!(low == high)) return std::nullopt;
  const auto rounded = static_cast<std::int64_t>(low);
  return ratio.middle < 0 ? -rounded : rounded;
}

struct BallCorner {
  Ball height;  // over the mirror
  Ball x, y, w;
  bool is_on_mirror = false;  // known

  // Returns where a line meets a bound over which `inside` and `outside` have these heights, > 0 and < 0.
  [[nodiscard]] static BallCorner between(const BallCorner& inside, const Ball& height_inside,
                                          const BallCorner& outside, const Ball& height_outside) {
    const auto blend = [&](Ball BallCorner::*value) {
      return outside.*value * height_inside - inside.*value * height_outside;
    };
    return {blend(&BallCorner::height), blend(&BallCorner::x), blend(&BallCorner::y), blend(&BallCorner::w)};
  }
};

// A corner's place relative to a bound is computed from these: nothing below zero is inside.
using Height = Ball (*)(const BallCorner&);
constexpr std::array<Height, 5> bounds{
    [](const BallCorner& c) { return c.is_on_mirror ? Ball{} : c.height; },
    [](const BallCorner& c) { return c.w + c.x; }, [](const BallCorner& c) { return c.w - c.x; },
    [](const BallCorner& c) { return c.w + c.y; }, [](const BallCorner& c) { return c.w - c.y; }};

std::optional<Sign> certain_sign(const Ball& ball) {
  if (ball.is_positive()) return 1;
  if (ball.is_negative()) return -1;
  if (ball.middle == 0 && ball.radius == 0) return 0;
  return std::nullopt;
}

// This is Sutherland and Hodgman's step, in the order of part_in_front (facet_cutter.h).
std::optional<std::vector<BallCorner>> certain_part(const std::vector<BallCorner>& polygon, Height height) {
  std::vector<Sign> sides;
  for (const BallCorner& corner : polygon) {
    const auto side = certain_sign(height(corner));
    if (!side) return std::nullopt;
    sides.push_back(*side);
  }
  std::vector<BallCorner> part;
  if (std::none_of(sides.begin(), sides.end(), [](Sign side) { return side > 0; })) return part;
  for (std::size_t u = 0; u < polygon.size(); ++u) {
    const std::size_t v = u + 1 == polygon.size() ? 0 : u + 1;
    if (sides[u] >= 0) part.push_back(polygon[u]);
    if (sides[u] * sides[v] >= 0) continue;
    const auto [inside, outside] = sides[u] > 0 ? std::pair(u, v) : std::pair(v, u);
    part.push_back(
        BallCorner::between(polygon[inside], height(polygon[inside]), polygon[outside], height(polygon[outside])));
  }
  return part;
}

// Differences of points are taken first: so the balls stay small, and a grid point is nearly always certain.
BallCorner seen(const MirroredForms& forms, const Camera& camera, const Point3& corner) {
  const bool is_on_mirror = std::find(forms.plane.begin(), forms.plane.end(), corner) != forms.plane.end();
  const Ball height = is_on_mirror ? Ball{} : dot(forms.mirror.normal, exactly(corner) - exactly(forms.plane[0]));
  const BallVector from_origin = exactly(corner) - exactly(camera.origin);
  const auto value = [&](const Vector3& row, const Ball& factor) {
    return dot(exactly(row), from_origin) - factor * height;
  };
  const Ball w = is_perspective(camera) ? value(camera.forward, forms.factors[2]) : exactly(1);
  return {height, value(camera.right, forms.factors[0]), value(camera.up, forms.factors[1]), w, is_on_mirror};
}

}  // namespace

BallForm ball_form(const std::array<Point3, 3>& points) {
  const BallVector origin = exactly(points[0]);
  const BallVector normal = cross(exactly(points[1]) - origin, exactly(points[2]) - origin);
  return {normal, -dot(normal, origin)};
}

// mirror_view.cpp does the same exactly. A point v has the mirror image v - 2 h(v) / (n . n) n, with the mirror's form
// h and its normal n, and so a camera's form l becomes l - 2 (l . n) / (n . n) h.
MirroredForms mirrored_forms(const Camera& camera, const std::array<Point3, 3>& plane) {
  MirroredForms forms{plane, ball_form(plane), {}, {}, {}, {}, {}};
  const BallVector& normal = forms.mirror.normal;
  forms.twice = exactly(2) / dot(normal, normal);
  const BallVector origin = exactly(camera.origin);
  const auto form = [&](const Vector3& row) { return BallForm{exactly(row), -dot(exactly(row), origin)}; };
  const auto factor = [&](const BallForm& f) { return forms.twice * dot(f.normal, normal); };
  const std::array camera_forms{form(camera.right), form(camera.up),
                                is_perspective(camera) ? form(camera.forward) : BallForm{{}, exactly(1)}};
  for (std::size_t i = 0; i < 3; ++i) forms.factors[i] = factor(camera_forms[i]);
  forms.x = camera_forms[0] - forms.factors[0] * forms.mirror;
  forms.y = camera_forms[1] - forms.factors[1] * forms.mirror;
  forms.w = camera_forms[2] - forms.factors[2] * forms.mirror;
  return forms;
}

// The centre is the eye's mirror image; the weight of a direction is 0.
std::optional<Sign> certain_side_of_centre(const MirroredForms& forms, const Camera& camera, const BallForm& plane) {
  const BallVector eye = exactly(camera.eye.xyz);
  const Ball weight = exactly(camera.eye.w == 0 ? 0 : 1);
  const Ball height = dot(forms.mirror.normal, eye) + weight * forms.mirror.constant;
  const BallVector centre = eye - (forms.twice * height) * forms.mirror.normal;
  return certain_sign(dot(plane.normal, centre) + weight * plane.constant);
}

std::optional<ImagePolygon> certain_image(const MirroredForms& forms, const Camera& camera,
                                          std::span<const Point3> corners, int grid_bits) {
  std::optional<std::vector<BallCorner>> polygon{std::in_place};
  for (const Point3& corner : corners) polygon->push_back(seen(forms, camera, corner));
  for (const Height height : bounds) {
    polygon = certain_part(*polygon, height);
    if (!polygon) return std::nullopt;
    if (polygon->empty()) return ImagePolygon{};
  }
  ImagePolygon image;
  for (const BallCorner& corner : *polygon) {
    if (!corner.w.is_positive()) return std::nullopt;
    const auto x = certain_coordinate(corner.x / corner.w, grid_bits);
    const auto y = certain_coordinate(corner.y / corner.w, grid_bits);
    if (!x || !y) return std::nullopt;
    image.push_back({*x, *y});
  }
  return distinct_corners(image);
}

}  // namespace sightline::inline reflect
