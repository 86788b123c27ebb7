#include "peers/scene/polygon_split.h"

#include <cmath>

namespace sightline::peers {
namespace {

double size_of(const DepthPlane& plane) { return std::abs(plane.a) + std::abs(plane.b) + std::abs(plane.c); }

// The gap says by how much one plane is farther than another one.
class Gap {
 public:
  Gap(const DepthPlane& plane, const DepthPlane& other)
      : difference_{plane.a - other.a, plane.b - other.b, plane.c - other.c},
        tolerance_(touching * (size_of(plane) + size_of(other))) {}

  // The gap is 0 where they touch.
  [[nodiscard]] double at(const Corner& corner) const {
    const double gap = difference_.at(corner.x, corner.y);
    return std::abs(gap) <= tolerance_ ? 0 : gap;
  }

 private:
  DepthPlane difference_;
  double tolerance_;
};

// Returns the place where the gap along the edge is 0. The depth is the polygon's own plane's.
Corner cut_point(const DepthPlane& plane, const Corner& from, double gap_from, const Corner& to, double gap_to) {
  const double share = gap_from / (gap_from - gap_to);
  const double x = from.x + share * (to.x - from.x);
  const double y = from.y + share * (to.y - from.y);
  return {x, y, plane.at(x, y)};
}

}  // namespace

Side side_of(const FlatPolygon& polygon, const DepthPlane& plane) {
  const Gap gap(polygon.plane, plane);
  bool some_nearer = false;
  bool some_farther = false;
  for (const Corner& corner : polygon.corners) {
    const double at_corner = gap.at(corner);
    some_nearer |= at_corner < 0;
    some_farther |= at_corner > 0;
  }
  if (some_nearer) return some_farther ? Side::across : Side::nearer;
  return some_farther ? Side::farther : Side::within;
}

Halves split(const FlatPolygon& polygon, const DepthPlane& plane) {
  const Gap gap(polygon.plane, plane);
  Halves halves{polygon, polygon};
  halves.nearer.corners.clear();
  halves.farther.corners.clear();
  const auto add = [&halves](const Corner& corner, double at_corner) {
    if (at_corner <= 0) halves.nearer.corners.push_back(corner);
    if (at_corner >= 0) halves.farther.corners.push_back(corner);
  };
  for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
    const Corner& from = polygon.corners[i];
    const Corner& to = polygon.corners[(i + 1) % polygon.corners.size()];
    const double gap_from = gap.at(from);
    const double gap_to = gap.at(to);
    add(from, gap_from);
    if (gap_from * gap_to < 0) add(cut_point(polygon.plane, from, gap_from, to, gap_to), 0);
  }
  return halves;
}

}  // namespace sightline::peers
