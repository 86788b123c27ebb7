#include "reflect/exact/pyramid.h"

#include <algorithm>

namespace sightline::inline reflect {

WindowPart common_part(const WindowPart& a, const WindowPart& b) {
  return {std::max(a.left, b.left), std::min(a.right, b.right), std::max(a.bottom, b.bottom), std::min(a.top, b.top)};
}

Pyramid::Pyramid(const MirroredForms& forms, const WindowPart& part)
    : forms_{forms.x - part.left * forms.w, part.right * forms.w - forms.x, forms.y - part.bottom * forms.w,
             part.top * forms.w - forms.y, forms.mirror} {}

bool Pyramid::may_touch(const Box& box) const {
  const BoundedVector place{bounded_around(box.low.x(), box.high.x()), bounded_around(box.low.y(), box.high.y()),
                            bounded_around(box.low.z(), box.high.z())};
  return std::none_of(forms_.begin(), forms_.end(),
                      [&](const BoundedForm& form) { return form.at(place).is_negative(); });
}

}  // namespace sightline::inline reflect
