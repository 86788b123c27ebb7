// How much of each pixel lies inside rings: areas, integrated exactly but for the rounding of double.
//
// In:  rings in the window's coordinates (seen.h), as many as one likes; counter-clockwise adds, clockwise takes away.
// Out: the covered area of every pixel of the rectangle of pixels around them, in pixels.
// Method: each side covers what is to the right of it, with the sign of its direction in y. Where it runs through a
//      pixel it gives that pixel a trapezoid, and every pixel further to the right its height: this is noted once, and
//      a sum along the row spreads it.
// Complexity: O(pixels of the rectangle + pixels that sides run through).
#pragma once

#include <span>
#include <vector>

#include "peers/scene/seen.h"

namespace sightline::peers {

class PixelAreas {
 public:
  PixelAreas(int resolution, std::span<const VisiblePart> parts);

  // Calls what(column, row, area) for each pixel of the rectangle, row by row.
  template <class What>
  void for_each(What what) const {
    for (int row = 0; row < rows_; ++row) {
      double height = 0;
      for (int column = 0; column < columns_; ++column) {
        const Pixel& pixel = pixels_[index(column, row)];
        what(first_column_ + column, first_row_ + row, height + pixel.trapezoids);
        height += pixel.height;
      }
    }
  }

 private:
  // The sides that run through a pixel add these: to itself, and to each pixel to the right.
  struct Pixel {
    double trapezoids = 0;
    double height = 0;
  };

  void add_side(const Point2& from, const Point2& to);
  void add_in_row(int row, const Point2& from, const Point2& to);
  void add_in_pixel(int column, int row, const Point2& from, const Point2& to);
  [[nodiscard]] Point2 in_pixels(const Point2& p) const;
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }

  int resolution_;
  int first_column_ = 0;
  int first_row_ = 0;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<Pixel> pixels_;
};

}  // namespace sightline::peers
