#include "geometry/faces/face_triangulation.h"

#include <algorithm>
#include <bit>

#include "geometry/faces/ear_clipper.h"

namespace sightline::inline geometry {

namespace {

// Returns twice the signed areas of the projections along x, y, z, over a common power of two.
template <class Integer>
std::array<Integer, 3> newell_normal(const PolygonView& polygon, int lowest_exponent) {
  const auto corner = [&](std::size_t i) {
    return scaled<Integer>(std::array{polygon[i].x(), polygon[i].y(), polygon[i].z()}, lowest_exponent);
  };
  std::array<Integer, 3> normal{0, 0, 0};
  std::array<Integer, 3> a = corner(polygon.size() - 1);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::array<Integer, 3> b = corner(i);
    normal[0] += a[1] * b[2] - b[1] * a[2];
    normal[1] += a[2] * b[0] - b[2] * a[0];
    normal[2] += a[0] * b[1] - b[0] * a[1];
    a = b;
  }
  return normal;
}

// Returns the direction of an integer vector: its components over a common power of two, cut to integers below 2^53.
template <class Integer>
std::optional<Vector3> direction_of(const std::array<Integer, 3>& normal) {
  std::array<Integer, 3> size;
  std::ranges::transform(normal, size.begin(), [](const Integer& n) { return n < 0 ? Integer(-n) : n; });
  const Integer& largest = std::ranges::max(size);
  if (largest == 0) return std::nullopt;
  const unsigned highest_bit = msb(largest);
  const unsigned shift = highest_bit < 53 ? 0 : highest_bit - 52;
  const auto component = [&](std::size_t i) {
    return sign_of(normal[i]) * static_cast<double>(static_cast<std::int64_t>(Integer(size[i] >> shift)));
  };
  return Vector3{component(0), component(1), component(2)};
}

using Corners = std::array<Point3, 3>;

// Returns whether the line along an edge of `t` has all of `u` on its right or on it.
bool edge_separates(const FaceView& view, const Corners& t, const Corners& u) {
  for (std::size_t i = 0; i < 3; ++i) {
    const auto beyond = [&](const Point3& p) { return view.turn(t[i], t[(i + 1) % 3], p) <= 0; };
    if (std::ranges::all_of(u, beyond)) return true;
  }
  return false;
}

std::optional<Vector3> newell_direction(const PolygonView& polygon) {
  std::vector<double> values;
  values.reserve(3 * polygon.size());
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    values.insert(values.end(), {polygon[i].x(), polygon[i].y(), polygon[i].z()});
  }
  const ExponentRange range = exponent_range(values);
  const auto bits_needed = 2 * range.bits + 1 + static_cast<int>(std::bit_width(polygon.size()));
  if (bits_needed < 255) return direction_of(newell_normal<Wide256>(polygon, range.lowest));
  return direction_of(newell_normal<BigInteger>(polygon, range.lowest));
}

const std::array<Vector3, 6> tilts{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};

}  // namespace

Sign FaceView::turn(const Point3& a, const Point3& b, const Point3& c) const {
  if (a == b || b == c || c == a) return 0;
  for (const Vector3& direction : {normal, tilt, second_tilt}) {
    const Sign sign = direction == Vector3::Zero() ? 0 : orient3d(a, b, c, HomogeneousPoint{direction, 0});
    if (sign != 0) return sign;
  }
  return 0;
}

std::vector<FaceView> face_views(const PolygonView& polygon) {
  const auto normal = newell_direction(polygon);
  if (!normal) return {};
  std::vector<FaceView> views{{*normal, Vector3::Zero(), Vector3::Zero()}};
  if (is_planar(polygon)) return views;
  for (const Vector3& t : tilts) views.push_back({*normal, t, {t.z(), t.x(), t.y()}});
  return views;
}

bool interiors_disjoint(const FaceView& view, std::span<const Triangle> triangles, std::span<const Point3> vertices) {
  const auto corners = [&](const Triangle& t) {
    return Corners{vertices[t[0].index()], vertices[t[1].index()], vertices[t[2].index()]};
  };
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Corners t = corners(triangles[i]);
    for (std::size_t j = 0; j < i; ++j) {
      const Corners u = corners(triangles[j]);
      if (!edge_separates(view, t, u) && !edge_separates(view, u, t)) return false;
    }
  }
  return true;
}

std::optional<std::vector<Triangle>> triangulate(const PolygonView& polygon) {
  for (const FaceView& view : face_views(polygon)) {
    auto triangles = clip_ears(polygon, view);
    if (triangles && interiors_disjoint(view, *triangles, polygon.vertices)) return triangles;
  }
  return std::nullopt;
}

}  // namespace sightline::inline geometry
