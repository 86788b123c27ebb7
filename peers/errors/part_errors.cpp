#include "peers/errors/part_errors.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "peers/scene/convex_ring.h"
#include "peers/scene/ring_grid.h"

namespace sightline::peers {
namespace {

using Ring = std::vector<Point2>;

// Returns twice the area of a, b, p.
double side(const Point2& a, const Point2& b, const Point2& p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

void clip_to_left(const Ring& ring, const Point2& a, const Point2& b, Ring& clipped) {
  clipped.clear();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point2& p = ring[i];
    const Point2& q = ring[(i + 1) % ring.size()];
    const double of_p = side(a, b, p);
    const double of_q = side(a, b, q);
    if (of_p >= 0) clipped.push_back(p);
    if ((of_p >= 0) == (of_q >= 0)) continue;
    const double t = of_p / (of_p - of_q);
    clipped.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
  }
}

// The triangle is counter-clockwise.
double clipped_area(const Ring& ring, const std::array<Point2, 3>& triangle) {
  Ring clipped = ring;
  Ring rest;
  for (std::size_t i = 0; i < 3 && !clipped.empty(); ++i) {
    clip_to_left(clipped, triangle.at(i), triangle.at((i + 1) % 3), rest);
    clipped.swap(rest);
  }
  return signed_area(clipped);
}

FaceAreas areas_of(const VisibleParts& parts) {
  FaceAreas areas;
  for (const VisiblePart& part : parts) areas[part.face] += signed_area(part.ring);
  return areas;
}

// These are the areas that the seen parts have in common with the exact ones.
struct CommonAreas {
  double of_same_face = 0;
  double of_any_face = 0;
};

CommonAreas common_areas(const VisibleParts& seen, const VisibleParts& exact) {
  CommonAreas common;
  RingGrid grid(exact);
  for (const VisiblePart& part : seen) {
    for (const std::size_t other : grid.near(part.ring)) {
      const double area = common_area(part.ring, exact[other].ring);
      common.of_any_face += area;
      if (exact[other].face == part.face) common.of_same_face += area;
    }
  }
  return common;
}

double sum_of(const FaceAreas& areas) {
  double sum = 0;
  for (const auto& [face, area] : areas) sum += area;
  return sum;
}

}  // namespace

double common_area(const Ring& a, const Ring& b) {
  const Ring& fan = a.size() <= b.size() ? a : b;
  const Ring& other = a.size() <= b.size() ? b : a;
  double area = 0;
  for (std::size_t i = 1; i + 1 < fan.size(); ++i) {
    const double turn = side(fan[0], fan[i], fan[i + 1]);
    if (turn > 0) area += clipped_area(other, {fan[0], fan[i], fan[i + 1]});
    if (turn < 0) area -= clipped_area(other, {fan[0], fan[i + 1], fan[i]});
  }
  return area;
}

AreaErrors errors_of(const VisibleParts& seen, const ExactParts& exact) {
  const FaceAreas shown = areas_of(seen);
  AreaErrors errors = compare_faces(shown, exact.areas);
  const CommonAreas common = common_areas(seen, exact.parts);
  const double over_nothing = sum_of(shown) - common.of_any_face;
  const double missing = sum_of(areas_of(exact.parts)) - common.of_same_face;
  const double of_wrong_faces = common.of_any_face - common.of_same_face;
  errors.wrong_share = std::max(0.0, over_nothing + std::max(missing, of_wrong_faces)) / 4;
  return errors;
}

}  // namespace sightline::peers
