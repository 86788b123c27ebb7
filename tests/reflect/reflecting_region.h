// This is a panel's reflecting region in floating point.
#pragma once

#include <optional>
#include <vector>

#include "tests/tools/analyzed.h"

namespace sightline::tests {

class ReflectingRegion {
 public:
  ReflectingRegion(const View& view, std::size_t panel);

  // Returns how often the border winds around the place; nothing where that is within `near` of it.
  [[nodiscard]] std::optional<int> winding(const Point2& place, double near = 1e-9) const;

 private:
  struct Border {
    Point2 a;
    Point2 b;
  };
  std::vector<Border> borders_;
};

}  // namespace sightline::tests
