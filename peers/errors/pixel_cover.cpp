#include "peers/errors/pixel_cover.h"

namespace sightline::peers {
namespace {

// Returns a positive sign where the place is left of the edge as it goes.
Sign side_of(const Corner& from, const Corner& to, const Point2& place) {
  return orient2d({from.x, from.y}, {to.x, to.y}, place);
}

bool goes_down_at(const Corner& from, const Corner& to, double y) { return to.y <= y && y < from.y; }
bool goes_up_at(const Corner& from, const Corner& to, double y) { return from.y <= y && y < to.y; }

}  // namespace

bool covers(const std::vector<Corner>& corners, const Point2& place) {
  bool is_at_height = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Corner& from = corners[i];
    const Corner& to = corners[(i + 1) % corners.size()];
    const bool down = goes_down_at(from, to, place.y);
    const bool up = goes_up_at(from, to, place.y);
    if ((down && side_of(from, to, place) < 0) || (up && side_of(from, to, place) <= 0)) return false;
    is_at_height = is_at_height || down || up;
  }
  return is_at_height;
}

int first_column_from(const ItemBuffer& buffer, double x) {
  return first_not_before({0, buffer.resolution()}, [&](int column) { return buffer.x_of(column) < x; });
}

PixelRange rows_between(const ItemBuffer& buffer, double bottom, double top) {
  const PixelRange all{0, buffer.resolution()};
  return {first_not_before(all, [&](int row) { return buffer.y_of(row) >= top; }),
          first_not_before(all, [&](int row) { return buffer.y_of(row) >= bottom; })};
}

PixelRange columns_covered(const ItemBuffer& buffer, const std::vector<Corner>& corners, int row, PixelRange columns) {
  const double y = buffer.y_of(row);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Corner& from = corners[i];
    const Corner& to = corners[(i + 1) % corners.size()];
    const auto side = [&](int column) { return side_of(from, to, {buffer.x_of(column), y}); };
    if (goes_down_at(from, to, y)) columns.begin = first_not_before(columns, [&](int c) { return side(c) < 0; });
    if (goes_up_at(from, to, y)) columns.end = first_not_before(columns, [&](int c) { return side(c) > 0; });
  }
  return columns;
}

}  // namespace sightline::peers
