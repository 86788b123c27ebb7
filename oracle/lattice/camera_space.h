// The oracle's own projection: exact integers from the scene to the image, for scenes made of small dyadic numbers.
//
// A vertex v becomes (X, Y, N, W): its image is (X / W, Y / W) and its nearness N / W, the larger the nearer to the
// eye: 1 / W of the camera for a pinhole, minus the depth for an orthographic camera. Both are affine in the image over
// a plane, so a face is a plane a x + b y + c nearness + d = 0 over the image, and it is edge-on where c = 0. Units:
// the window [-1, 1]^2 is [-half_window, half_window]^2 in oracle units. Errors: std::logic_error where a coordinate is
// not a small multiple of 1/16 (the generator's promise is broken).
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/numbers/image_point.h"
#include "geometry/projection/camera.h"

namespace sightline::lattice {

// It throws std::overflow_error instead of being wrong.
using Wide = boost::multiprecision::checked_int256_t;

constexpr std::int64_t half_window = 512;

struct CameraPoint {
  std::int64_t x = 0;
  std::int64_t y = 0;
  std::int64_t nearness = 0;
  std::int64_t w = 0;
};

struct Plane {
  std::int64_t a = 0;
  std::int64_t b = 0;
  std::int64_t c = 0;
  std::int64_t d = 0;
};

struct GridPoint {
  std::int64_t x = 0;
  std::int64_t y = 0;
  friend constexpr auto operator<=>(const GridPoint&, const GridPoint&) = default;
};
using Ring = std::vector<GridPoint>;

[[nodiscard]] CameraPoint to_camera_space(const Camera& camera, const Point3& v);

// Returns the plane through all corners, which are known to be coplanar; nothing where they are collinear.
[[nodiscard]] std::optional<Plane> plane_of(std::span<const CameraPoint> corners);

// Returns > 0 where p lies on one side of the plane, < 0 on the other, 0 in it.
[[nodiscard]] Wide side(const Plane& plane, const CameraPoint& p);

// Returns +1 where the corners run counter-clockwise seen from the eye, -1 where clockwise, 0 where edge-on.
[[nodiscard]] int facing(std::span<const CameraPoint> corners);

// Returns the image of a polygon; nothing where a corner is behind the eye or is not a whole number of oracle units.
[[nodiscard]] std::optional<Ring> image_of(std::span<const CameraPoint> corners);

// Returns the image of the part in the view volume (empty: none). The eye is not in the polygon's plane. A concave
// polygon may come back with pieces joined along the border, where the ring runs to and fro: even-odd is still right.
// There is nothing where a corner is not a whole number of oracle units.
[[nodiscard]] std::optional<Ring> clipped_image_of(std::span<const CameraPoint> corners);

}  // namespace sightline::lattice
