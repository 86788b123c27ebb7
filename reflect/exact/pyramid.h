// The pyramid from the mirror camera through a part of the window, cut off at the mirror: a test that may say
// "perhaps".
//
// In:  the camera's forms in the mirror; a rectangle of the window.
// Out: whether a box may have a point in the pyramid. False is proven: every number (bounded.h) holds the true one. What is true may yet have no point in it.
// Complexity: O(1).
// Source: Koucky 2014, 3.9 (pyramid C_r, figure 3.10).
#pragma once

#include <array>

#include "geometry/mesh/box_hierarchy.h"
#include "reflect/exact/mirrored_forms.h"

namespace sightline::inline reflect {

// The part is in units of the window, and closed.
struct WindowPart {
  double left = 0;
  double right = 0;
  double bottom = 0;
  double top = 0;

  [[nodiscard]] bool is_empty() const { return left > right || bottom > top; }
};

[[nodiscard]] WindowPart common_part(const WindowPart& a, const WindowPart& b);

class Pyramid {
 public:
  Pyramid(const MirroredForms& forms, const WindowPart& part);

  [[nodiscard]] bool may_touch(const Box& box) const;

 private:
  std::array<BoundedForm, 5> forms_;  // left, right, bottom, top, mirror: what is in the pyramid has no negative value
};

}  // namespace sightline::inline reflect
