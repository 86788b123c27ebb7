// Which pieces of a border may be met at a height of the image.
//
// In:  directed pieces of a border. Out: per height, or range of heights, the pieces that reach it, and some more.
// Method: bands of equal height; a piece is in all that it touches, widened by a spacing, so that approximate places
//      do.
// Complexity: O(n + k) for n pieces that touch k bands together; there are no more than n bands.
#pragma once

#include <span>
#include <vector>

#include "reflect/regions/border_piece.h"

namespace sightline::inline reflect {

class BandIndex {
 public:
  explicit BandIndex(const RegionBorder& border);

  // Returns the pieces, by their place in the border, that may reach the height of p.
  [[nodiscard]] std::span<const std::uint32_t> at(const ImagePlace& p) const { return bands_[band_of(p.at.y)]; }

  // Calls visit(i) for the pieces that may reach a height of the piece; some more than once.
  template <class Visit>
  void for_each_beside(const BorderPiece& piece, Visit visit) const {
    const auto [low, high] = bands_beside(piece);
    for (std::size_t band = low; band <= high; ++band) {
      for (const std::uint32_t i : bands_[band]) visit(std::size_t{i});
    }
  }

 private:
  struct BandRange {
    std::size_t low;
    std::size_t high;
  };
  [[nodiscard]] BandRange bands_beside(const BorderPiece& piece) const;
  [[nodiscard]] std::size_t band_of(double y) const;

  double bottom_ = 0;
  double bands_per_unit_ = 0;
  std::vector<std::vector<std::uint32_t>> bands_;
};

}  // namespace sightline::inline reflect
