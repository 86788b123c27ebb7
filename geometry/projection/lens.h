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
// (x, y) is the ideal place, (x', y') the bent one.
// Sources: Brown 1966; Kannala and Brandt 2006; both as OpenCV's documentation has them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "geometry/numbers/export.h"
#include "geometry/numbers/predicates.h"

namespace sightline::inline geometry {

enum class LensModel : std::uint8_t { brown, fisheye };

struct Lens {
  LensModel model = LensModel::brown;
  std::array<double, 6> radial{};      // k1, k2, ...: six of brown, four of fisheye
  std::array<double, 2> tangential{};  // p1, p2, of brown
};

// Returns whether the lens does anything: a fisheye always does.
[[nodiscard]] SIGHTLINE_EXPORT bool bends(const Lens& lens);

[[nodiscard]] SIGHTLINE_EXPORT Point2 bent_place(const Lens& lens, const Point2& ideal);

// A disc around the axis, of ideal places, on which no two places are bent to one.
struct LensDisc {
  enum class End : std::uint8_t { reaches, folds, too_wide };

  double radius = 0;       // of ideal places
  double bent_radius = 0;  // what is bent to places nearer to the axis than this lies in the disc
  End end = End::reaches;  // why it is no larger: it reaches far enough; the model folds; rays 89 degrees off the axis
};

// Returns a disc that reaches the bent radius, or the largest one for which this can be proven.
// Proof: the Jacobian of the map is symmetric, for both models. Where it is positive definite all over a convex region, no two
// places of it have one image, since (J (b - a)) . (b - a) > 0 all along the segment between them. Without p1 and p2 its
// eigenvalues are f and f + 2 r^2 f', a prime for the derivative by r^2; these two change them by at most 6 |p| r. Numbers with
// proven radii (bounded.h) show for one interval of r^2 after the other that both stay above that. The border of the disc is bent to
// places at least r f - 3 |p| r^2 off the axis, so that all within come from the disc.
// Of a fisheye the same is asked of d, which has to grow with a.
[[nodiscard]] SIGHTLINE_EXPORT LensDisc proven_disc(const Lens& lens, double bent_radius);

// Returns the ideal place in the disc that is bent to this one, by Newton's method: bent again, it is off by less than
// 1e-14 (1 + its distance from the axis). Nothing where there is none.
[[nodiscard]] SIGHTLINE_EXPORT std::optional<Point2> ideal_place(const Lens& lens, const LensDisc& disc,
                                                                 const Point2& bent);

}  // namespace sightline::inline geometry
