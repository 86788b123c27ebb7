#include "reflect/smooth/bent_mirror.h"

#include <cmath>

#include "geometry/numbers/bounded.h"

namespace sightline::inline reflect {
namespace {

constexpr double roundings = 64 * unit_roundoff;

constexpr auto times = [](const auto& a, const auto& b) { return a * b; };
constexpr auto inner = [](const Vector3& a, const Vector3& b) { return a.dot(b); };
constexpr auto scaled = [](double a, const Vector3& b) { return Vector3(a * b); };

// The window's axes in space: right . first = 1, up . first = 0, and so on.
std::array<Vector3, 3> axes_of(const Camera& camera) {
  const std::array across{camera.up.cross(camera.forward), camera.forward.cross(camera.right),
                          camera.right.cross(camera.up)};
  const double determinant = camera.right.dot(across[0]);
  return {across[0] / determinant, across[1] / determinant, across[2] / determinant};
}

template <class Value>
double largest(const LinearForm<Value>& form) {
  double result = 0;
  for (const Value& value : form.coefficients) {
    if constexpr (std::is_same_v<Value, double>)
      result = std::max(result, std::fabs(value));
    else
      result = std::max(result, value.norm());
  }
  return result;
}

// The form that is 1 everywhere.
template <std::size_t degree>
BarycentricForm<degree, double> ones() {
  const LinearForm<double> one{{1, 1, 1}};
  if constexpr (degree == 1)
    return one;
  else
    return product(ones<degree - 1>(), one, times);
}

// Returns normals at the places, times the weight: linear, and at the triangle's corners those given.
LinearForm<Vector3> normals_at(const LinearForm<Vector3>& place, const LinearForm<double>& weight,
                               const std::array<Vector3, 3>& corners, const std::array<Vector3, 3>& normals) {
  const Vector3 second = corners[1] - corners[0];
  const Vector3 third = corners[2] - corners[0];
  const Vector3 across = second.cross(third);
  const Vector3 to_second = third.cross(across) / across.squaredNorm();
  const Vector3 to_third = across.cross(second) / across.squaredNorm();
  LinearForm<Vector3> result;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3 from_first = place.coefficients[i] - weight.coefficients[i] * corners[0];
    const double b = from_first.dot(to_second);
    const double c = from_first.dot(to_third);
    result.coefficients[i] = (weight.coefficients[i] - b - c) * normals[0] + b * normals[1] + c * normals[2];
  }
  return result;
}

// A plane that all rays stay on the far side of, leaning from `outwards` towards the mean direction as they do.
PlaneForm side_plane(const Vector3& outwards, const Vector3& mean, const std::vector<Vector3>& directions,
                     const std::array<Point3, 3>& starts) {
  double lean = -std::numeric_limits<double>::infinity();
  for (const Vector3& d : directions) lean = std::max(lean, outwards.dot(d) / mean.dot(d));
  const Vector3 normal = outwards - lean * mean;
  PlaneForm plane{normal, -std::numeric_limits<double>::infinity()};
  for (const Point3& start : starts) plane.offset = std::max(plane.offset, normal.dot(start));
  return plane;
}

}  // namespace

BentMirror::BentMirror(const Camera& camera, double scale, const BentTriangle& triangle, const WindowTriangle& window)
    : towards_eye_(triangle.towards_eye) {
  const bool has_eye = camera.projection == Projection::perspective;
  const std::array<Vector3, 3> axes = axes_of(camera);
  origin_ = scale * (has_eye ? camera.eye.xyz : camera.origin);
  std::array<Point3, 3> corners = triangle.corners;
  for (Point3& corner : corners) corner -= origin_;
  LinearForm<Vector3> direction;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3 beside = window[i].x * axes[0] + window[i].y * axes[1];
    direction.coefficients[i] = has_eye ? Vector3(beside + axes[2]) : axes[2];
    const double sinking = -towards_eye_.dot(direction.coefficients[i]);
    if (has_eye) {
      place_.coefficients[i] = -towards_eye_.dot(corners[0]) * direction.coefficients[i];
      weight_.coefficients[i] = sinking;
    } else {
      const Vector3 start = scale * beside;
      place_.coefficients[i] = start + towards_eye_.dot(start - corners[0]) / sinking * axes[2];
      weight_.coefficients[i] = 1;
    }
  }
  const LinearForm<Vector3> normal = normals_at(place_, weight_, corners, triangle.normals);
  mirrored_ = product(product(normal, normal, inner), direction, scaled) -
              product(product(direction, normal, inner).mapped([](double d) { return 2 * d; }), normal, scaled);
  largest_place_ = largest(place_);
  largest_weight_ = largest(weight_);
  largest_mirrored_ = 3 * largest(normal) * largest(normal) * largest(direction);
}

Condition BentMirror::rises() const {
  const Cubic<double> rise = mirrored_.mapped([&](const Vector3& r) { return towards_eye_.dot(r); });
  return {Quartic(product(rise, ones<1>(), times)), roundings * largest_mirrored_};
}

LinearForm<double> BentMirror::height_over(const Plane& plane) const {
  LinearForm<double> height;
  for (std::size_t i = 0; i < 3; ++i)
    height.coefficients[i] =
        plane.normal.dot(place_.coefficients[i] - weight_.coefficients[i] * (plane.point - origin_));
  return height;
}

double BentMirror::largest_height(const Plane& plane) const {
  return plane.normal.norm() * (largest_place_ + largest_weight_ * (plane.point - origin_).norm());
}

Condition BentMirror::starts_before(const Plane& plane) const {
  return {Quartic(product(height_over(plane), ones<3>(), times)), roundings * largest_height(plane)};
}

Condition BentMirror::passes_left_of(const Point3& p, const Point3& q) const {
  const Vector3 from = p - origin_;
  const Vector3 to = q - origin_;
  const Vector3 along = to - from;
  const Vector3 across = from.cross(along);
  LinearForm<Vector3> line;
  for (std::size_t i = 0; i < 3; ++i)
    line.coefficients[i] = place_.coefficients[i].cross(along) - weight_.coefficients[i] * across;
  const double largest_line = (largest_place_ + largest_weight_ * from.norm()) * along.norm();
  return {Quartic(product(mirrored_, line, inner)), roundings * largest_mirrored_ * largest_line};
}

Condition BentMirror::meets_before(const Plane& first, const Plane& second) const {
  const auto along = [&](const Plane& plane) {
    return mirrored_.mapped([&](const Vector3& r) { return plane.normal.dot(r); });
  };
  const double largest_product =
      largest_mirrored_ * (first.normal.norm() * largest_height(second) + second.normal.norm() * largest_height(first));
  return {
      Quartic(product(along(second), height_over(first), times) - product(along(first), height_over(second), times)),
      roundings * largest_product};
}

// Returns where the rays of the corners start; nothing where one does not meet the plane.
std::optional<std::array<Point3, 3>> BentMirror::starts() const {
  std::array<Point3, 3> result;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(weight_.coefficients[i] > 0)) return std::nullopt;
    result[i] = place_.coefficients[i] / weight_.coefficients[i] + origin_;
  }
  return result;
}

std::vector<PlaneForm> BentMirror::sides_along(const std::vector<Vector3>& directions,
                                               const std::array<Point3, 3>& starts) const {
  std::vector<PlaneForm> sides{{-towards_eye_, -towards_eye_.dot(starts[0])}};
  Vector3 mean = Vector3::Zero();
  for (const Vector3& d : directions) mean += d / d.norm();
  mean = unit(mean);
  const Vector3 beside = unit(mean.cross(std::fabs(mean.x()) < 0.5 ? Vector3(1, 0, 0) : Vector3(0, 1, 0)));
  const Vector3 across = mean.cross(beside);
  if (std::ranges::all_of(directions, [&](const Vector3& d) { return mean.dot(d) > 0x1p-10 * d.norm(); })) {
    for (const Vector3& outwards : {beside, Vector3(-beside), across, Vector3(-across)})
      sides.push_back(side_plane(outwards, mean, directions, starts));
  }
  // Far more than rounding has moved a plane, and far less than a box that matters.
  for (PlaneForm& side : sides) side.offset += 0x1p-40 * side.normal.norm() * (1 + origin_.norm());
  return sides;
}

// Bernstein's coefficients, up to positive factors, span all directions.
RayBeam BentMirror::beam() const {
  const auto starts = this->starts();
  if (!starts) return RayBeam({});
  return RayBeam(sides_along({mirrored_.coefficients.begin(), mirrored_.coefficients.end()}, *starts));
}

RayBeam BentMirror::beam_to(const std::vector<Point3>& polygon) const {
  const auto starts = this->starts();
  if (!starts) return RayBeam({});
  std::vector<Vector3> directions;
  for (const Point3& start : *starts) {
    for (const Point3& p : polygon) directions.push_back(p - start);
  }
  return RayBeam(sides_along(directions, *starts));
}

}  // namespace sightline::inline reflect
