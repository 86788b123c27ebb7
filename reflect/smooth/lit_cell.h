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

  [[nodiscard]] constexpr Seam from_beyond() const { return {object, from_front, end, start}; }
};

struct SeamedCondition {
  Condition condition;
  std::optional<Seam> seam;
  std::uint32_t line = 0;  // conditions with the same number are zero at the same places
};

// All of the conditions hold there: those that are open; the others are settled.
using ConvexPart = std::vector<SeamedCondition>;

struct LitCell {
  ImageTriangle corners;  // counter-clockwise; the first two have the older side between them
  std::vector<ConvexPart> images;
  std::vector<ConvexPart> shadows;
};

}  // namespace sightline::inline reflect
