#include "geometry/faces/ear_clipper.h"

#include <algorithm>
#include <array>
#include <tuple>

namespace sightline::inline geometry {

namespace {

struct Corner {
  VertexId vertex;
  Point3 at = Point3::Zero();
  std::size_t previous = 0;
  std::size_t next = 0;
  bool alive = true;
  bool turns_left = false;
  bool is_ear = false;
};

// The ring has the corners that are left of the polygon.
struct Ring {
  FaceView view;
  std::vector<Corner> corners;
  std::size_t size = 0;
  std::vector<std::size_t> not_left;  // the corners that do not turn left

  const Corner& before(const Corner& c) const { return corners[c.previous]; }
  const Corner& after(const Corner& c) const { return corners[c.next]; }
};

Ring make_ring(const PolygonView& polygon, const FaceView& view) {
  Ring ring{view, {}, polygon.size(), {}};
  const std::size_t k = polygon.size();
  for (std::size_t i = 0; i < k; ++i) {
    ring.corners.push_back({polygon.corners[i], polygon[i], (i + k - 1) % k, (i + 1) % k});
  }
  for (std::size_t i = 0; i < k; ++i) ring.not_left.push_back(i);
  return ring;
}

using Corners = std::array<Point3, 3>;
using EdgeSigns = std::array<Sign, 3>;  // on which side of the edges ab, bc, ca a point is

// Returns whether an edge from a point of the closed triangle leads into its inside: at the lines that the point is on,
// the edge goes to the left.
bool leads_inside(const FaceView& view, const Corners& t, const EdgeSigns& start, const Point3& end) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (start[i] == 0 && view.turn(t[i], t[(i + 1) % 3], end) <= 0) return false;
  }
  return true;
}

bool in_the_way(const Ring& ring, const Corners& t, const Corner& corner) {
  EdgeSigns start;
  for (std::size_t i = 0; i < 3; ++i) {
    start[i] = ring.view.turn(t[i], t[(i + 1) % 3], corner.at);
    if (start[i] < 0) return false;
  }
  const bool on_open_diagonal = start[2] == 0 && start[0] > 0 && start[1] > 0;
  const auto enters = [&](const Corner& end) { return leads_inside(ring.view, t, start, end.at); };
  return on_open_diagonal || enters(ring.before(corner)) || enters(ring.after(corner));
}

bool is_ear(const Ring& ring, const Corner& tip) {
  if (!tip.turns_left) return false;
  const Corners triangle{ring.before(tip).at, tip.at, ring.after(tip).at};
  return std::ranges::none_of(ring.not_left, [&](std::size_t i) {
    const Corner& corner = ring.corners[i];
    return i != tip.previous && i != tip.next && in_the_way(ring, triangle, corner);
  });
}

// Clipping an ear can only make a corner turn left; removing a spike can do either.
void update_turn(Ring& ring, std::size_t i) {
  Corner& corner = ring.corners[i];
  const bool turned_left = corner.turns_left;
  corner.turns_left = ring.view.turn(ring.before(corner).at, corner.at, ring.after(corner).at) > 0;
  if (turned_left && !corner.turns_left) ring.not_left.push_back(i);
}

void forget_left_turns(Ring& ring) {
  std::erase_if(ring.not_left, [&](std::size_t i) { return !ring.corners[i].alive || ring.corners[i].turns_left; });
}

void find_ears(Ring& ring) {
  for (std::size_t i = 0; i < ring.corners.size(); ++i) update_turn(ring, i);
  forget_left_turns(ring);
  for (Corner& corner : ring.corners) corner.is_ear = is_ear(ring, corner);
}

void remove(Ring& ring, std::size_t i) {
  Corner& corner = ring.corners[i];
  ring.corners[corner.previous].next = corner.next;
  ring.corners[corner.next].previous = corner.previous;
  corner.alive = corner.is_ear = false;
  --ring.size;
}

// Removes spikes that start at these corners; returns the corners whose neighbours are new.
std::vector<std::size_t> remove_spikes_at(Ring& ring, std::vector<std::size_t> pending) {
  std::vector<std::size_t> changed;
  while (!pending.empty()) {
    const std::size_t i = pending.back();
    pending.pop_back();
    const Corner& corner = ring.corners[i];
    if (!corner.alive || ring.size < 3) continue;
    if (bounds_nothing(ring.before(corner).at, corner.at, ring.after(corner).at)) {
      remove(ring, i);
      pending.insert(pending.end(), {corner.previous, corner.next});
    } else {
      changed.push_back(i);
    }
  }
  return changed;
}

void clip(Ring& ring, std::size_t tip) {
  const Corner& corner = ring.corners[tip];
  remove(ring, tip);
  const auto changed = remove_spikes_at(ring, {corner.previous, corner.next});
  for (const std::size_t i : changed) update_turn(ring, i);
  forget_left_turns(ring);
  for (const std::size_t i : changed) ring.corners[i].is_ear = ring.corners[i].alive && is_ear(ring, ring.corners[i]);
}

// Vertex indices come first; the neighbours tell apart corners of one vertex.
auto priority(const Ring& ring, const Corner& c) {
  const auto [low, high] = std::minmax({ring.before(c).vertex, ring.after(c).vertex});
  return std::tuple(c.vertex, high, low);
}

std::optional<std::size_t> first_ear(const Ring& ring) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < ring.corners.size(); ++i) {
    if (!ring.corners[i].is_ear) continue;
    if (!best || priority(ring, ring.corners[i]) > priority(ring, ring.corners[*best])) best = i;
  }
  return best;
}

}  // namespace

std::optional<std::vector<Triangle>> clip_ears(const PolygonView& polygon, const FaceView& view) {
  Ring ring = make_ring(polygon, view);
  find_ears(ring);
  std::vector<Triangle> triangles;
  while (ring.size >= 3) {
    const auto ear = first_ear(ring);
    if (!ear) return std::nullopt;
    const Corner& tip = ring.corners[*ear];
    triangles.push_back({ring.before(tip).vertex, tip.vertex, ring.after(tip).vertex});
    clip(ring, *ear);
  }
  return triangles;
}

}  // namespace sightline::inline geometry
