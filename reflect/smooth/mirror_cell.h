// A square of the image, small enough that between its corners a bent mirror is taken as linear; and what it reflects.
//
// In:  a square on the grid, the mirrored rays through its corners; convex polygons of space in front of the mirror.
// Out: what of the square mirrors a polygon into the camera, in two convex polygons of the image, one per half of the
//      square (linear_part.h says how far they reach beyond it). Empty where that is beyond the outline of what is
//      looked at.
// Method: a ray meets a convex polygon where it passes all its edges on the same side. On which side is the sign of a
//      number, known at the corners and linear between them: for a flat mirror exactly so.
// Units: positions are those of the input times the world's scale.
#pragma once

#include <optional>

#include "reflect/exact/linear_part.h"
#include "reflect/regions/polygon_outline.h"
#include "reflect/smooth/smooth_rays.h"
#include "reflect/world/plane_form.h"

namespace sightline::inline reflect {

// The ray meets the polygon from one side: its front is where its corners are seen counter-clockwise.
enum class PolygonSide : std::uint8_t { front, back };

class MirrorCell {
 public:
  MirrorCell(const ImagePoint& low, std::int64_t size, const SmoothRays& rays, const PolygonOutline& outline,
             int grid_bits);

  // The cell is not known where a corner's ray does not meet the mirror: then nothing is known of it.
  [[nodiscard]] bool is_known() const { return is_known_; }

  static constexpr std::size_t halves = 2;
  [[nodiscard]] RightTriangle half(std::size_t half) const;
  [[nodiscard]] LinearPart reflecting(std::size_t half, const std::vector<Point3>& polygon, PolygonSide side) const;

  // Returns whether a box may have a point that one of the cell's mirrored rays meets.
  [[nodiscard]] bool may_reach(const Box& box) const;

 private:
  int grid_bits_;
  const PolygonOutline& outline_;
  bool is_known_ = true;
  std::array<ImagePoint, 4> places_;  // counter-clockwise from the lowest
  std::array<MirroredRay, 4> rays_;
  // Each ray has the planes through it that are upright, and level, in the image; in front is what is to the right, or
  // above.
  std::array<PlaneForm, 4> upright_;
  std::array<PlaneForm, 4> level_;
};

}  // namespace sightline::inline reflect
