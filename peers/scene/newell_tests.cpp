#include "peers/scene/newell_tests.h"

#include <algorithm>
#include <cmath>

namespace sightline::peers {
namespace {

using Corners = std::vector<Corner>;

// Returns whether the corner is right of the line, on it, or less than a touch left of it.
bool is_outside(const Corner& from, const Corner& to, const Corner& corner) {
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  const double left = dx * (corner.y - from.y) - dy * (corner.x - from.x);
  return left <= touching * (std::abs(dx) + std::abs(dy));
}

bool has_edge_between(const Corners& corners, const Corners& other) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Corner& from = corners[i];
    const Corner& to = corners[(i + 1) % corners.size()];
    if (std::all_of(other.begin(), other.end(), [&](const Corner& c) { return is_outside(from, to, c); })) return true;
  }
  return false;
}

}  // namespace

bool is_nearer_throughout(const Surface& q, const Surface& p) {
  const double nearest = p.extent.least.depth;
  return q.extent.most.depth < nearest - touching * std::abs(nearest);
}

bool x_extents_apart(const Surface& p, const Surface& q) {
  return p.extent.most.x <= q.extent.least.x || q.extent.most.x <= p.extent.least.x;
}

bool y_extents_apart(const Surface& p, const Surface& q) {
  return p.extent.most.y <= q.extent.least.y || q.extent.most.y <= p.extent.least.y;
}

bool is_behind(const Surface& p, const Surface& q) {
  const Side side = side_of(p.polygon, q.polygon.plane);
  return side == Side::farther || (side == Side::within && !is_in_front_in_plane(p.polygon, q.polygon));
}

bool is_before(const Surface& q, const Surface& p) {
  const Side side = side_of(q.polygon, p.polygon.plane);
  return side == Side::nearer || (side == Side::within && !is_in_front_in_plane(p.polygon, q.polygon));
}

bool images_apart(const Surface& p, const Surface& q) {
  return has_edge_between(p.polygon.corners, q.polygon.corners) ||
         has_edge_between(q.polygon.corners, p.polygon.corners);
}

}  // namespace sightline::peers
