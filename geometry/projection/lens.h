// A lens that bends rays: the models of distortion that calibrations are given in.
//
// A point whose place in the camera's frame (x right, y down, z forward) is (x, y) = (X / Z, Y / Z) comes to the pixel
// K (x', y', 1), where, with r^2 = x^2 + y^2:
//
//   brown    f = (1 + k1 r^2 + k2 r^4 + k3 r^6) / (1 + k4 r^2 + k5 r^4 + k6 r^6)
//            x' = x f + 2 p1 x y + p2 (r^2 + 2 x^2)      y' = y f + p1 (r^2 + 2 y^2) + 2 p2 x y
//   fisheye  a = arctan r, d = a (1 + k1 a^2 + k2 a^4 + k3 a^6 + k4 a^8)
//            (x', y') = (x, y) d / r
//
// Sources: Brown 1966; Kannala and Brandt 2006; both as OpenCV's documentation has them.
#pragma once

#include <array>
#include <cstdint>

namespace sightline::inline geometry {

enum class LensModel : std::uint8_t { brown, fisheye };

struct Lens {
  LensModel model = LensModel::brown;
  std::array<double, 6> radial{};      // k1, k2, ...: six of brown, four of fisheye
  std::array<double, 2> tangential{};  // p1, p2, of brown
};

}  // namespace sightline::inline geometry
