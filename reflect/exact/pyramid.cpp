#include "reflect/exact/pyramid.h"

#include <algorithm>

namespace sightline::inline reflect {

WindowPart common_part(const WindowPart& a, const WindowPart& b) {
  return {std::max(a.left, b.left), std::min(a.right, b.right), std::max(a.bottom, b.bottom), std::min(a.top, b.top)};
}

Pyramid::Pyramid(const MirroredForms& forms, const WindowPart& part)
    : forms_{forms.x - exactly(part.left) * forms.w, exactly(part.right) * forms.w - forms.x,
             forms.y - exactly(part.bottom) * forms.w, exactly(part.top) * forms.w - forms.y, forms.mirror} {}

bool Pyramid::may_touch(const Box& box) const {
  const BallVector ball = ball_around(box);
  return std::none_of(forms_.begin(), forms_.end(), [&](const BallForm& form) { return form.at(ball).is_negative(); });
}

}  // namespace sightline::inline reflect
