// The pyramid from the mirror camera through a part of the window, cut off at the mirror: a test that may say "perhaps".
//
// In:  a mirror's plane, by three of its points, with the eye in front; a rectangle of the window.
// Out: whether a box may have a point in the pyramid. False is proven: every number is an interval that holds the true
//      one, its ends moved outwards after each operation. What is true may yet have no point in it.
// Complexity: O(1).
// Source: Koucky 2014, 3.9 (pyramid C_r, figure 3.10).
#pragma once

#include <array>

#include "geometry/box_hierarchy.h"
#include "geometry/camera.h"

namespace sightline {

// In units of the window; closed.
struct WindowPart {
  double left = 0;
  double right = 0;
  double bottom = 0;
  double top = 0;

  [[nodiscard]] bool is_empty() const { return left > right || bottom > top; }
};

[[nodiscard]] WindowPart common_part(const WindowPart& a, const WindowPart& b);

// Holds the true value: low <= value <= high. Not a number in either: nothing is known.
struct Interval {
  double low = 0;
  double high = 0;
};

class Pyramid {
 public:
  Pyramid(const Camera& camera, const std::array<Point3, 3>& mirror, const WindowPart& part);

  [[nodiscard]] bool may_touch(const Box& box) const;

 private:
  // x, y, z and constant: what is in the pyramid has no negative value.
  using Form = std::array<Interval, 4>;
  [[nodiscard]] static bool is_beyond(const Form& form, const Box& box);
  std::array<Form, 5> forms_;  // left, right, bottom, top, mirror
};

}  // namespace sightline
