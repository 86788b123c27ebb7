#include "oracle/lattice/camera_space.h"

#include <cmath>
#include <numeric>
#include <stdexcept>

namespace sightline::lattice {
namespace {

// Coordinates and camera rows are whole multiples of 1/16 below 2^12; a camera coordinate is then a multiple of 1/256.
constexpr double input_unit = 16;

std::int64_t fixed(double value) {
  const double scaled = value * input_unit;
  if (scaled != std::floor(scaled) || std::fabs(scaled) >= 0x1p16)
    throw std::logic_error("not a small multiple of 1/16");
  return static_cast<std::int64_t>(scaled);
}

std::int64_t form(const Vector3& row, const Vector3& offset) {
  return fixed(row.x()) * fixed(offset.x()) + fixed(row.y()) * fixed(offset.y()) + fixed(row.z()) * fixed(offset.z());
}

using Row = std::array<Int128, 3>;

std::int64_t determinant(const Row& p, const Row& q, const Row& r) {
  const Int128 value =
      p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) + p[2] * (q[0] * r[1] - q[1] * r[0]);
  if (value > INT64_MAX || value < -INT64_MAX) throw std::overflow_error("determinant of camera points");
  return static_cast<std::int64_t>(value);
}

Plane plane_through(const CameraPoint& p, const CameraPoint& q, const CameraPoint& r) {
  return {determinant({p.y, p.nearness, p.w}, {q.y, q.nearness, q.w}, {r.y, r.nearness, r.w}),
          -determinant({p.x, p.nearness, p.w}, {q.x, q.nearness, q.w}, {r.x, r.nearness, r.w}),
          determinant({p.x, p.y, p.w}, {q.x, q.y, q.w}, {r.x, r.y, r.w}),
          -determinant({p.x, p.y, p.nearness}, {q.x, q.y, q.nearness}, {r.x, r.y, r.nearness})};
}

Int128 magnitude(Int128 value) { return value < 0 ? -value : value; }

Int128 greatest_common_divisor(Int128 a, Int128 b) {
  a = magnitude(a);
  b = magnitude(b);
  while (b != 0) {
    const Int128 rest = a % b;
    a = b;
    b = rest;
  }
  return a;
}

struct Homogeneous {
  Int128 x;
  Int128 y;
  Int128 w;
};

Homogeneous reduced(const Homogeneous& p) {
  const Int128 divisor = greatest_common_divisor(greatest_common_divisor(p.x, p.y), p.w);
  return divisor == 0 ? p : Homogeneous{p.x / divisor, p.y / divisor, p.w / divisor};
}

// Returns the distance to one of the four planes of the view volume; >= 0 inside.
Int128 border(const Homogeneous& p, int which) {
  const Int128 coordinate = which < 2 ? p.x : p.y;
  return which % 2 == 0 ? p.w - coordinate : p.w + coordinate;
}

std::vector<Homogeneous> cut(const std::vector<Homogeneous>& ring, int which) {
  std::vector<Homogeneous> result;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Homogeneous& p = ring[i];
    const Homogeneous& q = ring[(i + 1) % ring.size()];
    const Int128 fp = border(p, which);
    const Int128 fq = border(q, which);
    if (fp >= 0) result.push_back(p);
    if ((fp < 0 && fq > 0) || (fp > 0 && fq < 0)) {
      const Int128 s = magnitude(fq);
      const Int128 t = magnitude(fp);
      result.push_back(reduced({p.x * s + q.x * t, p.y * s + q.y * t, p.w * s + q.w * t}));
    }
  }
  return result;
}

std::optional<Ring> to_grid(const std::vector<Homogeneous>& ring) {
  Ring result;
  for (const Homogeneous& p : ring) {
    if (p.w <= 0 || p.x * half_window % p.w != 0 || p.y * half_window % p.w != 0) return std::nullopt;
    const GridPoint point{static_cast<std::int64_t>(p.x * half_window / p.w),
                          static_cast<std::int64_t>(p.y * half_window / p.w)};
    if (result.empty() || result.back() != point) result.push_back(point);
  }
  while (result.size() > 1 && result.front() == result.back()) result.pop_back();
  return result;
}

std::vector<Homogeneous> homogeneous(std::span<const CameraPoint> corners) {
  std::vector<Homogeneous> ring;
  for (const CameraPoint& p : corners) ring.push_back({p.x, p.y, p.w});
  return ring;
}

}  // namespace

CameraPoint to_camera_space(const Camera& camera, const Point3& v) {
  const Vector3 offset = v - camera.origin;
  constexpr auto one = static_cast<std::int64_t>(input_unit * input_unit);
  const std::int64_t depth = form(camera.forward, offset);
  const bool pinhole = camera.projection == Projection::perspective;
  return {form(camera.right, offset), form(camera.up, offset), pinhole ? one : -depth, pinhole ? depth : one};
}

std::optional<Plane> plane_of(std::span<const CameraPoint> corners) {
  for (std::size_t j = 1; j < corners.size(); ++j) {
    for (std::size_t k = j + 1; k < corners.size(); ++k) {
      const Plane plane = plane_through(corners[0], corners[j], corners[k]);
      if (plane.a != 0 || plane.b != 0 || plane.c != 0 || plane.d != 0) return plane;
    }
  }
  return std::nullopt;
}

Wide side(const Plane& plane, const CameraPoint& p) {
  return Wide(plane.a) * p.x + Wide(plane.b) * p.y + Wide(plane.c) * p.nearness + Wide(plane.d) * p.w;
}

int facing(std::span<const CameraPoint> corners) {
  std::int64_t volume = 0;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    volume += plane_through(corners[0], corners[i], corners[i + 1]).c;
  }
  return volume > 0 ? 1 : (volume < 0 ? -1 : 0);
}

std::optional<Ring> image_of(std::span<const CameraPoint> corners) { return to_grid(homogeneous(corners)); }

std::optional<Ring> clipped_image_of(std::span<const CameraPoint> corners) {
  std::vector<Homogeneous> ring = homogeneous(corners);
  for (int which = 0; which < 4; ++which) ring = cut(ring, which);
  return to_grid(ring);
}

}  // namespace sightline::lattice
