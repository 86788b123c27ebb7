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

// What is known of cells together.
struct CellsFound {
  double lit_area = 0;  // about, and beyond the polygon, too
  double uncertain_area = 0;
  double distance = 0;
  double largest_uncertain_area = 0;  // of a cell that can be divided
  bool is_all_lit = true;

  CellsFound& operator+=(const CellsFound& more);
};

class LitCells {
 public:
  // Adds a cell, divided until its parts are precise.
  void add(LitCell cell, const PolygonOutline& outline, const CellPrecision& precision);
  // Divides those that are not as precise.
  void divide(const PolygonOutline& outline, const CellPrecision& precision);

  // Those that are not divided, and not dark.
  [[nodiscard]] const std::vector<LitCell>& cells() const { return cells_; }
  [[nodiscard]] CellsFound found() const;
  [[nodiscard]] RegionBorder border() const { return border_of_cells(cells_, halved_); }
  // So many cells were looked at.
  [[nodiscard]] std::uint64_t count() const { return count_; }

 private:
  struct Known {
    CellPrecision uncertain;
    double lit_area = 0;
    bool is_least = false;  // it cannot be divided
  };

  [[nodiscard]] bool divide(const LitCell& cell, const PolygonOutline& outline, const CellPrecision& precision);
  void look_at(LitCell cell, const PolygonOutline& outline, const CellPrecision& precision);

  std::vector<LitCell> cells_;
  std::vector<Known> known_;  // parallel to the cells
  CellSides halved_;
  bool has_dark_ = false;
  std::uint32_t number_count_ = 0;
  std::uint64_t count_ = 0;
};

// Leaves out of the cell the parts that are nowhere. Returns false where nothing is lit for certain.
[[nodiscard]] bool narrow_to_lit(LitCell& cell);

// Returns whether a place of the cell is lit for certain.
[[nodiscard]] bool is_lit_at(const LitCell& cell, const Point2& place);

// Says of a condition what its coefficients say of all of the triangle.
enum class Standing : std::uint8_t { holds, fails, open };
[[nodiscard]] Standing standing(const Condition& condition);

}  // namespace sightline::inline reflect
