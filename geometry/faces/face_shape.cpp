#include "geometry/faces/face_shape.h"

#include <tuple>

namespace sightline::inline geometry {

namespace {

// This holds in every coordinate at the tip of a spike. Comparisons settle nearly every corner that is none.
bool is_turning_point(double a, double b, double c) {
  return (a < b && c < b) || (a > b && c > b) || (a == b && b == c);
}

// Returns the turn in the projection along `axis`. Points on an axis-parallel line, and there are many in models, need
// no arithmetic.
Sign turn_along(int axis, const Point3& a, const Point3& b, const Point3& c) {
  const Point2 p = drop_axis(a, axis);
  const Point2 q = drop_axis(b, axis);
  const Point2 r = drop_axis(c, axis);
  if ((p.x == q.x && q.x == r.x) || (p.y == q.y && q.y == r.y)) return 0;
  return orient2d(p, q, r);
}

// Returns the first axis along which three points are seen to turn; nullopt if they are on one line.
std::optional<int> axis_of_turn(const Point3& a, const Point3& b, const Point3& c) {
  for (const int axis : {0, 1, 2}) {
    if (turn_along(axis, a, b, c) != 0) return axis;
  }
  return std::nullopt;
}

// Returns whether all corners have the same value of one coordinate.
bool is_axis_parallel(const PolygonView& polygon) {
  std::array<bool, 3> same{true, true, true};
  for (std::size_t i = 1; i < polygon.size(); ++i) {
    same[0] = same[0] && polygon[i].x() == polygon[0].x();
    same[1] = same[1] && polygon[i].y() == polygon[0].y();
    same[2] = same[2] && polygon[i].z() == polygon[0].z();
  }
  return same[0] || same[1] || same[2];
}

// Removes corners that bound nothing from the end of an open boundary, as long as there are any.
void trim_end(std::vector<VertexId>& corners, std::span<const Point3> vertices) {
  const auto position = [&](std::size_t from_end) { return vertices[corners[corners.size() - from_end].index()]; };
  while (corners.size() >= 2) {
    if (position(1) == position(2)) {
      corners.pop_back();
    } else if (corners.size() >= 3 && bounds_nothing(position(3), position(2), position(1))) {
      corners.erase(corners.end() - 2);
    } else {
      return;
    }
  }
}

// Removes such corners where the boundary closes; between its ends it has none.
void trim_closure(std::vector<VertexId>& corners, std::span<const Point3> vertices) {
  std::size_t first = 0;
  const auto position = [&](std::size_t i) { return vertices[corners[i].index()]; };
  while (corners.size() - first >= 3) {
    const std::size_t last = corners.size() - 1;
    if (bounds_nothing(position(last - 1), position(last), position(first))) {
      corners.pop_back();
    } else if (bounds_nothing(position(last), position(first), position(first + 1))) {
      ++first;
    } else {
      break;
    }
  }
  corners.erase(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(first));
}

// Returns whether the turn at each corner is `turn` or straight, along this axis.
bool turns_only(const PolygonView& polygon, int axis, Sign turn) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Sign here = turn_along(axis, polygon[i], polygon[i + 1], polygon[i + 2]);
    if (here == -turn) return false;
  }
  return true;
}

// A boundary that turns to one side only runs up once and down once each time it goes round.
bool goes_round_once(const PolygonView& polygon) {
  std::size_t reversals = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const bool up = lexicographically_less(polygon[i], polygon[i + 1]);
    const bool up_next = lexicographically_less(polygon[i + 1], polygon[i + 2]);
    reversals += up != up_next ? 1 : 0;
  }
  return reversals == 2;
}

}  // namespace

bool lexicographically_less(const Point3& a, const Point3& b) {
  return std::tie(a.x(), a.y(), a.z()) < std::tie(b.x(), b.y(), b.z());
}

bool bounds_nothing(const Point3& a, const Point3& b, const Point3& c) {
  if (a == b || b == c) return true;
  const bool back = is_turning_point(a.x(), b.x(), c.x()) && is_turning_point(a.y(), b.y(), c.y()) &&
                    is_turning_point(a.z(), b.z(), c.z());
  return back && collinear(a, b, c);
}

void remove_spikes(std::vector<VertexId>& corners, std::span<const Point3> vertices) {
  std::vector<VertexId> kept;
  kept.reserve(corners.size());
  for (const VertexId corner : corners) {
    kept.push_back(corner);
    trim_end(kept, vertices);
  }
  trim_closure(kept, vertices);
  corners.swap(kept);
}

std::optional<std::array<std::size_t, 3>> corners_off_line(const PolygonView& polygon) {
  std::size_t second = 1;
  while (second < polygon.size() && polygon[second] == polygon[0]) ++second;
  for (std::size_t third = second + 1; third < polygon.size(); ++third) {
    if (axis_of_turn(polygon[0], polygon[second], polygon[third])) return {{0, second, third}};
  }
  return std::nullopt;
}

bool is_planar(const PolygonView& polygon) {
  if (polygon.size() <= 3 || is_axis_parallel(polygon)) return true;
  const auto base = corners_off_line(polygon);
  if (!base) return true;
  const auto [a, b, c] = *base;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (i == a || i == b || i == c) continue;
    if (orient3d(polygon[a], polygon[b], polygon[c], polygon[i]) != 0) return false;
  }
  return true;
}

bool is_convex(const PolygonView& polygon) {
  const auto base = corners_off_line(polygon);
  if (!base) return false;
  const auto [a, b, c] = *base;
  const int axis = *axis_of_turn(polygon[a], polygon[b], polygon[c]);
  return turns_only(polygon, axis, turn_along(axis, polygon[a], polygon[b], polygon[c])) && goes_round_once(polygon);
}

}  // namespace sightline::inline geometry
