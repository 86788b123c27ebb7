#include "peers/pixels/image_rectangle.h"

#include <algorithm>

namespace sightline::peers {
namespace {

struct Bounds {
  Point2 low;
  Point2 high;
};

bool are_apart(const Bounds& a, const Bounds& b) {
  return a.high.x <= b.low.x || b.high.x <= a.low.x || a.high.y <= b.low.y || b.high.y <= a.low.y;
}

Bounds bounds_of(const Corner& p, const Corner& q) {
  return {{std::min(p.x, q.x), std::min(p.y, q.y)}, {std::max(p.x, q.x), std::max(p.y, q.y)}};
}

// An edge passes through the inside if its bounds do, and the edge's line has vertices on both sides.
bool edge_intersects(const Corner& p, const Corner& q, const Vertices& rectangle) {
  if (are_apart(bounds_of(p, q), {rectangle[0], rectangle[2]})) return false;
  std::array<Sign, 4> sides{};
  for (std::size_t v = 0; v < 4; ++v) sides[v] = orient2d({p.x, p.y}, {q.x, q.y}, rectangle[v]);
  const auto [least, most] = std::minmax_element(sides.begin(), sides.end());
  return *least < 0 && *most > 0;
}

Point2 middle_of(const Vertices& rectangle) {
  return {(rectangle[0].x + rectangle[2].x) / 2, (rectangle[0].y + rectangle[2].y) / 2};
}

}  // namespace

std::array<Rectangle, 4> parts_of(const Rectangle& r) {
  const int column = r.columns.begin + r.columns.size() / 2;
  const int row = r.rows.begin + r.rows.size() / 2;
  const PixelRange left{r.columns.begin, column};
  const PixelRange right{column, r.columns.end};
  const PixelRange upper{r.rows.begin, row};
  const PixelRange lower{row, r.rows.end};
  return {Rectangle{left, upper}, {right, upper}, {left, lower}, {right, lower}};
}

Vertices vertices_of(const Rectangle& r, int resolution) {
  const double left = 2.0 * r.columns.begin / resolution - 1;
  const double right = 2.0 * r.columns.end / resolution - 1;
  const double top = 1 - 2.0 * r.rows.begin / resolution;
  const double bottom = 1 - 2.0 * r.rows.end / resolution;
  return {Point2{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

Overlap overlap_of(const std::vector<Corner>& corners, const Extent& extent, const Vertices& rectangle) {
  const Bounds bounds{{extent.least.x, extent.least.y}, {extent.most.x, extent.most.y}};
  if (are_apart(bounds, {rectangle[0], rectangle[2]})) return Overlap::disjoint;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (edge_intersects(corners[i], corners[(i + 1) % corners.size()], rectangle)) return Overlap::intersecting;
  }
  return covers(corners, middle_of(rectangle)) ? Overlap::enclosing : Overlap::disjoint;
}

}  // namespace sightline::peers
