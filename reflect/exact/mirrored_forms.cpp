#include "reflect/exact/mirrored_forms.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "geometry/projection/camera_forms.h"
#include "reflect/exact/mirror_view.h"

namespace sightline::inline reflect {
namespace {

struct BoundedCorner {
  Bounded height;  // over the mirror
  Bounded x, y, w;
  bool is_on_mirror = false;  // known

  // Returns where a line meets a bound over which `inside` and `outside` have these heights, > 0 and < 0.
  [[nodiscard]] static BoundedCorner between(const BoundedCorner& inside, const Bounded& height_inside,
                                             const BoundedCorner& outside, const Bounded& height_outside) {
    const auto blend = [&](Bounded BoundedCorner::*value) {
      return outside.*value * height_inside - inside.*value * height_outside;
    };
    return {blend(&BoundedCorner::height), blend(&BoundedCorner::x), blend(&BoundedCorner::y),
            blend(&BoundedCorner::w)};
  }
};

// A corner's place relative to a bound is computed from these: nothing below zero is inside.
using Height = Bounded (*)(const BoundedCorner&);
constexpr std::array<Height, 5> bounds{
    [](const BoundedCorner& c) { return c.is_on_mirror ? Bounded{} : c.height; },
    [](const BoundedCorner& c) { return c.w + c.x; }, [](const BoundedCorner& c) { return c.w - c.x; },
    [](const BoundedCorner& c) { return c.w + c.y; }, [](const BoundedCorner& c) { return c.w - c.y; }};

// This is Sutherland and Hodgman's step, in the order of part_in_front (facet_cutter.h).
std::optional<std::vector<BoundedCorner>> certain_part(const std::vector<BoundedCorner>& polygon, Height height) {
  std::vector<Sign> sides;
  for (const BoundedCorner& corner : polygon) {
    const auto side = certain_sign(height(corner));
    if (!side) return std::nullopt;
    sides.push_back(*side);
  }
  std::vector<BoundedCorner> part;
  if (std::none_of(sides.begin(), sides.end(), [](Sign side) { return side > 0; })) return part;
  for (std::size_t u = 0; u < polygon.size(); ++u) {
    const std::size_t v = u + 1 == polygon.size() ? 0 : u + 1;
    if (sides[u] >= 0) part.push_back(polygon[u]);
    if (sides[u] * sides[v] >= 0) continue;
    const auto [inside, outside] = sides[u] > 0 ? std::pair(u, v) : std::pair(v, u);
    part.push_back(
        BoundedCorner::between(polygon[inside], height(polygon[inside]), polygon[outside], height(polygon[outside])));
  }
  return part;
}

// With differences of points first: so the radii stay small, and a grid point is nearly always certain.
BoundedCorner seen(const MirroredForms& forms, const CameraForms<Bounded>& camera, const Point3& corner) {
  const bool is_on_mirror = std::find(forms.plane.begin(), forms.plane.end(), corner) != forms.plane.end();
  const BoundedVector from_plane = bounded(corner) - bounded(forms.plane[0]);
  const Bounded height = is_on_mirror ? Bounded{} : forms.mirror.normal.dot(from_plane);
  const CameraPlace<Bounded> place = camera.at(bounded(corner));
  const Bounded w = camera.perspective ? place.w - forms.factors[2] * height : place.w;
  return {height, place.x - forms.factors[0] * height, place.y - forms.factors[1] * height, w, is_on_mirror};
}

}  // namespace

BoundedForm bounded_form(const std::array<Point3, 3>& points) {
  const BoundedVector origin = bounded(points[0]);
  const BoundedVector u = bounded(points[1]) - origin;
  const BoundedVector v = bounded(points[2]) - origin;
  const BoundedVector normal = u.cross(v);
  return {normal, -normal.dot(origin)};
}

// mirror_view.cpp does the same exactly. A point v has the mirror image v - 2 h(v) / (n . n) n, with the mirror's form
// h and its normal n, and so a camera's form l becomes l - 2 (l . n) / (n . n) h.
MirroredForms mirrored_forms(const Camera& camera, const std::array<Point3, 3>& plane) {
  MirroredForms forms{plane, bounded_form(plane), {}, {}, {}, {}, {}};
  const BoundedVector& normal = forms.mirror.normal;
  forms.twice = 2.0 / normal.dot(normal);
  const CameraForms<Bounded> rows(camera);
  const auto form = [&](const BoundedVector& row) { return BoundedForm{row, -row.dot(rows.origin)}; };
  const std::array camera_forms{form(rows.right), form(rows.up),
                                rows.perspective ? form(rows.forward) : BoundedForm{BoundedVector::Zero(), 1.0}};
  for (std::size_t i = 0; i < 3; ++i) forms.factors[i] = forms.twice * camera_forms[i].normal.dot(normal);
  forms.x = camera_forms[0] - forms.factors[0] * forms.mirror;
  forms.y = camera_forms[1] - forms.factors[1] * forms.mirror;
  forms.w = camera_forms[2] - forms.factors[2] * forms.mirror;
  return forms;
}

// The centre is the eye's mirror image; the weight of a direction is 0.
std::optional<Sign> certain_side_of_centre(const MirroredForms& forms, const Camera& camera, const BoundedForm& plane) {
  const BoundedVector eye = bounded(camera.eye.xyz);
  const Bounded weight = camera.eye.w == 0 ? 0 : 1;
  const Bounded height = forms.mirror.normal.dot(eye) + weight * forms.mirror.constant;
  const BoundedVector centre = eye - (forms.twice * height) * forms.mirror.normal;
  return certain_sign(plane.normal.dot(centre) + weight * plane.constant);
}

std::optional<ImagePolygon> certain_image(const MirroredForms& forms, const Camera& camera,
                                          std::span<const Point3> corners, int grid_bits) {
  const CameraForms<Bounded> camera_forms(camera);
  std::optional<std::vector<BoundedCorner>> polygon{std::in_place};
  for (const Point3& corner : corners) polygon->push_back(seen(forms, camera_forms, corner));
  for (const Height height : bounds) {
    polygon = certain_part(*polygon, height);
    if (!polygon) return std::nullopt;
    if (polygon->empty()) return ImagePolygon{};
  }
  ImagePolygon image;
  for (const BoundedCorner& corner : *polygon) {
    if (!corner.w.is_positive()) return std::nullopt;
    const auto x = certain_integer(corner.x / corner.w, grid_bits);
    const auto y = certain_integer(corner.y / corner.w, grid_bits);
    if (!x || !y) return std::nullopt;
    image.push_back({*x, *y});
  }
  return distinct_corners(image);
}

}  // namespace sightline::inline reflect
