// Which part of a triangle of the image mirrors a panel: by dividing it until each cell's border is known well enough.
//
// In:  a triangle with what may be seen of the panel in it, and shadows of what is before the panel: each where a set of conditions
//      holds (bent_mirror.h); the polygon of the image that is looked at; how much may stay uncertain.
// Out: the border of what is lit, cell by cell; how much of the area may be wrong, and how far its border may be from where it
//      should be. Both are bounds: where coefficients have one sign, nothing is uncertain; else a condition is taken as linear, and
//      what it departs from that by is a strip along its border, as is noise.
// Method: a condition that holds in a cell is no more asked in its parts, and what contradicts one is left out. Cells are halved
//      at their older side (newest-vertex bisection), whose middle is a grid point as long as it divides.
//      A condition that is noise everywhere in a cell, as that of a ray along the plane of an obstacle, does not hold.
// Complexity: O(k) per cell for k conditions that are open there; cell_borders.h's where the border is.
// Source: Farin 1986 (Bernstein's basis); Sewell 1972, Mitchell 1989 (newest-vertex bisection).
#pragma once

#include <vector>

#include "reflect/regions/polygon_outline.h"
#include "reflect/smooth/cell_borders.h"

namespace sightline::inline reflect {

// In spacings of the grid: what area of a cell may stay uncertain, and how far its border may be from where it should be.
struct CellPrecision {
  double area = 0;
  double distance = 0;
};

// Whether borders are wanted, or only how much is lit, about, and how well that is known.
enum class CellResult : std::uint8_t { measure, border };

class LitCells {
 public:
  LitCells(const PolygonOutline& outline, const CellPrecision& precision, CellResult wanted)
      : outline_(outline), precision_(precision), wanted_(wanted) {}

  void look_at(LitCell cell);

  [[nodiscard]] const RegionBorder& border() const { return border_; }
  [[nodiscard]] bool is_all_lit() const { return !has_dark_; }
  [[nodiscard]] double uncertain_area() const { return uncertain_area_; }
  // About so much is lit; beyond the polygon, too.
  [[nodiscard]] double estimated_area() const { return estimated_area_; }
  // So many cells have uncertain parts.
  [[nodiscard]] std::uint64_t uncertain_count() const { return uncertain_count_; }
  [[nodiscard]] double distance() const { return distance_; }
  [[nodiscard]] std::uint64_t cell_count() const { return cell_count_; }
  // In so many of the cells that are not divided further there are shadows.
  [[nodiscard]] std::uint64_t shadow_count() const { return shadow_count_; }

 private:
  [[nodiscard]] bool is_outside(const ImageTriangle& t) const;
  [[nodiscard]] bool is_precise(const CellPrecision& uncertain) const {
    return uncertain.area <= precision_.area && uncertain.distance <= precision_.distance;
  }
  void divide(LitCell cell);
  void keep(LitCell cell, const CellPrecision& uncertain, double lit_share);

  const PolygonOutline& outline_;
  CellPrecision precision_;
  CellResult wanted_;
  std::vector<LitCell> kept_;
  CellSides halved_;
  RegionBorder border_;
  bool has_dark_ = false;
  double uncertain_area_ = 0;
  double estimated_area_ = 0;
  std::uint64_t uncertain_count_ = 0;
  double distance_ = 0;
  std::uint64_t cell_count_ = 0;
  std::uint64_t shadow_count_ = 0;
};

// Leaves out of the cell what holds everywhere, and parts that are nowhere. Returns false where nothing is lit for certain.
[[nodiscard]] bool narrow_to_lit(LitCell& cell);

// Returns whether a place of the cell is lit for certain.
[[nodiscard]] bool is_lit_at(const LitCell& cell, const Point2& place);

// Says of a condition what its coefficients say of all of the triangle.
enum class Standing : std::uint8_t { holds, fails, open };
[[nodiscard]] Standing standing(const Condition& condition);

}  // namespace sightline::inline reflect
