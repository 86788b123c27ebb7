// A peer says what is seen: an item buffer, visible polygons, or visible lines.
#pragma once

#include <variant>
#include <vector>

#include "geometry/numbers/ids.h"
#include "geometry/numbers/predicates.h"

namespace sightline::peers {

// Returns where a pixel stands in an array of all: row by row from the top.
[[nodiscard]] constexpr std::size_t pixel_index(int column, int row, int resolution) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(resolution) + static_cast<std::size_t>(column);
}

[[nodiscard]] constexpr std::size_t pixel_count(int resolution) { return pixel_index(0, resolution, resolution); }

// An item buffer has a face per pixel, as seen at the pixel's centre. The window's left upper corner is that of the
// first pixel; rows go down.
class ItemBuffer {
 public:
  explicit ItemBuffer(int resolution) : resolution_(resolution), faces_(pixel_count(resolution)) {}

  [[nodiscard]] int resolution() const { return resolution_; }  // pixels along each side
  [[nodiscard]] FaceId at(int column, int row) const { return faces_[index(column, row)]; }
  void paint(int column, int row, FaceId face) { faces_[index(column, row)] = face; }

  // Returns the place of a pixel's centre, exactly for resolutions that are powers of two.
  [[nodiscard]] double x_of(int column) const { return (2 * column + 1.0) / resolution_ - 1; }
  [[nodiscard]] double y_of(int row) const { return 1 - (2 * row + 1.0) / resolution_; }

 private:
  [[nodiscard]] std::size_t index(int column, int row) const { return pixel_index(column, row, resolution_); }

  int resolution_;
  std::vector<FaceId> faces_;  // invalid: nothing is seen
};

// A ring bounds what is seen of a face, in the window's coordinates: counter-clockwise it adds its inside, clockwise it
// takes it away.
struct VisiblePart {
  FaceId face;
  std::vector<Point2> ring;
};
using VisibleParts = std::vector<VisiblePart>;

// This is a part of an edge, or of a profile, that is seen.
struct VisibleLine {
  Point2 from;
  Point2 to;
};
using VisibleLines = std::vector<VisibleLine>;

using Seen = std::variant<ItemBuffer, VisibleParts, VisibleLines>;

}  // namespace sightline::peers
