#include "tests/reflect/reflecting_region.h"

#include <algorithm>
#include <cmath>

#include "sweep/segments/image_points.h"

namespace sightline::tests {
namespace {

double side_of(const Point2& a, const Point2& b, const Point2& p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

bool is_near(const Point2& a, const Point2& b, const Point2& p, double near) {
  if (p.x < std::min(a.x, b.x) - near || p.x > std::max(a.x, b.x) + near) return false;
  if (p.y < std::min(a.y, b.y) - near || p.y > std::max(a.y, b.y) + near) return false;
  return std::fabs(side_of(a, b, p)) <= near * std::hypot(b.x - a.x, b.y - a.y);
}

}  // namespace

ReflectingRegion::ReflectingRegion(const View& view, std::size_t panel) {
  const VisibleSegments& segments = view.reflections.panels[panel].segments;
  const ImagePoints points(view.scene, segments);
  for (const VisibleSegment& s : segments.segments)
    borders_.push_back({points.in_window(s.start), points.in_window(s.end)});
}

std::optional<int> ReflectingRegion::winding(const Point2& place, double near) const {
  int winding = 0;
  for (const auto& [a, b] : borders_) {
    if (is_near(a, b, place, near)) return std::nullopt;
    if (a.y <= place.y && b.y > place.y && side_of(a, b, place) > 0) ++winding;
    if (b.y <= place.y && a.y > place.y && side_of(a, b, place) < 0) --winding;
  }
  return winding;
}

}  // namespace sightline::tests
