#include "reflect/regions/band_index.h"

#include <algorithm>

namespace sightline::inline reflect {
namespace {

constexpr std::size_t pieces_per_band = 4;

double low_of(const BorderPiece& piece) { return std::min(piece.start.at.y, piece.end.at.y) - 1; }
double high_of(const BorderPiece& piece) { return std::max(piece.start.at.y, piece.end.at.y) + 1; }

}  // namespace

BandIndex::BandIndex(const RegionBorder& border) : bands_(border.size() / pieces_per_band + 1) {
  if (border.empty()) return;
  bottom_ = low_of(border.front());
  double top = high_of(border.front());
  for (const BorderPiece& piece : border) {
    bottom_ = std::min(bottom_, low_of(piece));
    top = std::max(top, high_of(piece));
  }
  bands_per_unit_ = static_cast<double>(bands_.size()) / (top - bottom_);
  for (std::size_t i = 0; i < border.size(); ++i) {
    const auto [low, high] = bands_beside(border[i]);
    for (std::size_t band = low; band <= high; ++band) bands_[band].push_back(static_cast<std::uint32_t>(i));
  }
}

BandIndex::BandRange BandIndex::bands_beside(const BorderPiece& piece) const {
  return {band_of(low_of(piece)), band_of(high_of(piece))};
}

std::size_t BandIndex::band_of(double y) const {
  const double band = (y - bottom_) * bands_per_unit_;
  return band <= 0 ? 0 : std::min(static_cast<std::size_t>(band), bands_.size() - 1);
}

}  // namespace sightline::inline reflect
