// A lens that bends rays: the models of distortion that calibrations are given in.
//
// A point whose place in the camera's frame (x right, y down, z forward) is (X / Z, Y / Z), the ideal place, comes to the pixel
// K (x', y', 1) of the bent place (x', y'). First its distance r from the axis becomes that of the base place (x, y):
//
//   brown          r
//   fisheye        arctan r
//   field_of_view  arctan(2 r tan(w / 2)) / w
//
// Then, with a the base place's distance from the axis,
//
//            x' = x f + 2 p1 x y + p2 (a^2 + 2 x^2) + s1 a^2      y' = y f + p1 (a^2 + 2 y^2) + 2 p2 x y + s2 a^2
//   brown    f = (1 + k1 a^2 + k2 a^4 + k3 a^6) / (1 + k4 a^2 + k5 a^4 + k6 a^6)
//   fisheye  f = 1 + k1 a^2 + k2 a^4 + k3 a^6 + k4 a^8
//   field_of_view  f = 1
//
// Sources: Brown 1966; Kannala and Brandt 2006; Devernay and Faugeras 2001; as the documentation of OpenCV and COLMAP has them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "geometry/numbers/export.h"
#include "geometry/numbers/predicates.h"

namespace sightline::inline geometry {

enum class LensModel : std::uint8_t { brown, fisheye, field_of_view };
[[nodiscard]] SIGHTLINE_EXPORT const char* to_string(LensModel model);

struct Lens {
  LensModel model = LensModel::brown;
  std::array<double, 6> radial{};  // k1, k2, ...: six of brown, four of fisheye; w alone of field_of_view, in (0, pi)
  std::array<double, 2> tangential{};  // p1, p2; not of field_of_view
  std::array<double, 2> prism{};       // s1, s2; not of field_of_view
};

// Returns whether the lens does anything: a brown one without coefficients does nothing.
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
// Proof: base places are one to one with ideal places, and a disc of these is a disc of those. Of the map from there, let J be the
// Jacobian. Where (J v) . v > 0 for all v all over a convex region, no two places b and c of it have one image, since (J (c - b)) .
// (c - b) > 0 all along the segment between them. Without p and s it is symmetric, and its eigenvalues are f and f + 2 a^2 f', a
// prime for the derivative by a^2; p1 and p2 change (J v) . v by at most 6 |p| a of v . v, s1 and s2 by 2 |s| a. Numbers with
// proven radii (bounded.h) show for one interval of a^2 after the other that both eigenvalues stay above these. The border of the
// disc is bent to places at least a f - (3 |p| + |s|) a^2 off the axis, so that all within come from the disc.
[[nodiscard]] SIGHTLINE_EXPORT LensDisc proven_disc(const Lens& lens, double bent_radius);

// Returns the ideal place in the disc that is bent to this one, by Newton's method: bent again, it is off by less than
// 1e-14 (1 + its distance from the axis). Nothing where there is none.
[[nodiscard]] SIGHTLINE_EXPORT std::optional<Point2> ideal_place(const Lens& lens, const LensDisc& disc,
                                                                 const Point2& bent);

}  // namespace sightline::inline geometry
