#include "peers/pixel_cover.h"

namespace sightline::peers {
namespace {

// Of a place against a polygon's edge: positive where it is on the edge's inner side.
Sign side_of(const Corner& from, const Corner& to, const Point2& place) {
  return orient2d({from.x, from.y}, {to.x, to.y}, place);
}

// Whether a place on the edge, shifted to the right and less far up, is on the edge's inner side.
bool has_its_places(const Corner& from, const Corner& to) { return from.y != to.y ? to.y < from.y : to.x >= from.x; }

}  // namespace

bool covers(const std::vector<Corner>& corners, const Point2& place) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Corner& from = corners[i];
    const Corner& to = corners[(i + 1) % corners.size()];
    const Sign side = side_of(from, to, place);
    if (side < 0 || (side == 0 && !has_its_places(from, to))) return false;
  }
  return true;
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
    if (to.y <= y && y < from.y) columns.begin = first_not_before(columns, [&](int c) { return side(c) < 0; });
    if (from.y <= y && y < to.y) columns.end = first_not_before(columns, [&](int c) { return side(c) > 0; });
  }
  return columns;
}

}  // namespace sightline::peers
