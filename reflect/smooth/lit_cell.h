// A triangle of the image, and in it what may be seen of a panel, and the shadows of what is before the panel: each where a set of
// conditions holds (bent_mirror.h).
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "reflect/smooth/barycentric_polygon.h"
#include "reflect/smooth/bent_mirror.h"

namespace sightline::inline reflect {

// An edge of a facet, as a ray meets the facet from one side. Where two facets share it, each on its own side of it, there is no border of both
// together.
struct Seam {
  std::uint32_t object = 0;
  bool from_front = true;
  std::uint32_t start = 0;
  std::uint32_t end = 0;
  friend constexpr auto operator<=>(const Seam&, const Seam&) = default;
};

struct SeamedCondition {
  Condition condition;
  std::optional<Seam> seam;
  std::uint32_t line = 0;    // where they have the same one, conditions are zero at the same places
  std::uint32_t number = 0;  // of the seam
};

// Returns the number of the seam as the facet beyond it has it.
[[nodiscard]] constexpr std::uint32_t other_side(std::uint32_t seam) { return seam ^ 1U; }

// All of the conditions hold there: those that are open; the others are settled.
using ConvexPart = std::vector<SeamedCondition>;

struct LitCell {
  ImageTriangle corners;  // counter-clockwise; the first two have the older side between them
  std::vector<ConvexPart> images;
  std::vector<ConvexPart> shadows;
};

// A condition as the linear function of its values at the corners has it: it may fail where the function is at most `below`, and hold
// where it is at least `-above`. Neither is negative.
struct LinearCondition {
  CornerValues values;
  double below = 0;
  double above = 0;
};

[[nodiscard]] inline LinearCondition linear(const Condition& condition) {
  const Quartic::Departure departure = condition.value.departure();
  return {condition.value.corners(), departure.below + condition.noise, departure.above + condition.noise};
}

}  // namespace sightline::inline reflect
