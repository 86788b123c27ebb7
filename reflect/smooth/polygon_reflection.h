// What of one visible polygon reflects one panel, as it becomes known.
//
// In:  the polygon's border; per patch of its surface, and side of the panel, the cells that cover it (smooth_mirror.h).
// Out: about how much is lit, and how much of that may be wrong; once that is little enough, the border of what is lit. Where no ray
//      is known to meet the panel, nothing is.
// Complexity: that of lit_cells.h; the border's that of overlay.h.
#pragma once

#include <optional>
#include <vector>

#include "reflect/regions/polygon_outline.h"
#include "reflect/regions/sheets.h"
#include "reflect/smooth/lit_cells.h"

namespace sightline::inline reflect {

struct Reflecting {
  RegionBorder border;
  double area = 0;            // in spacings of the grid, squared
  double uncertain_area = 0;  // of it and of what may be missing
  double distance = 0;        // of a border from where it should be, in spacings
};

class PolygonReflection {
 public:
  explicit PolygonReflection(const RegionBorder& polygon);

  // Beyond the half planes what is lit is another patch's. Cells that may be whole cover all of the polygon.
  void add(std::vector<LitCell> covers, const std::vector<ImagePolygon>& half_planes, bool may_be_whole,
           const CellPrecision& precision);
  void divide(const CellPrecision& precision);

  [[nodiscard]] bool is_dark() const;
  // Returns the area that is most uncertain of a cell that can be divided.
  [[nodiscard]] double largest_uncertain_area() const;
  // Returns what is known without a border; its area is an estimate.
  [[nodiscard]] Reflecting measured() const;
  // Precondition: `polygon` is the border that this was made with.
  [[nodiscard]] Reflecting bordered(const RegionBorder& polygon, int grid_bits) const;

  [[nodiscard]] std::uint64_t cell_count() const;
  // So many cells have shadows.
  [[nodiscard]] std::uint64_t shadowed_count() const;

 private:
  struct PatchCells {
    LitCells cells;
    std::vector<ImagePolygon> half_planes;
    bool may_be_whole = false;
  };

  [[nodiscard]] bool is_whole() const;
  [[nodiscard]] bool has_witness(const RegionBorder& border) const;

  PolygonOutline outline_;
  double area_;
  std::vector<PatchCells> patches_;
};

// Closed rings that run counter-clockwise count positive.
[[nodiscard]] double area_of(const RegionBorder& border);

}  // namespace sightline::inline reflect
