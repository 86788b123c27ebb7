// Each line of "Holds" in visible_segments.h is checked here as far as it can be seen without the mesh. What depends on
// which facets are one surface (balance of start and end points, no two segments of a surface meet but in end points)
// is checked per point and per facet here, and per surface in validate(polygons, ...).
#include <algorithm>
#include <utility>

#include "geometry/numbers/id_names.h"
#include "sweep/segments/crossing_order.h"
#include "sweep/segments/edge_sides.h"
#include "sweep/segments/visible_segments.h"

namespace sightline::inline sweep {
namespace {

using Messages = std::vector<std::string>;

std::string crossing_name(std::size_t c) { return "crossing " + std::to_string(c); }
std::string thread_name(std::size_t t) { return "thread " + std::to_string(t); }
std::string split_name(std::size_t s) { return "split " + std::to_string(s); }

// Ranges come first: the other checks need them in order to look at anything.
Messages check_ranges(const VisibleSegments& segments, const ProjectedScene& scene) {
  Messages messages;
  const auto is_scene_edge = [&](EdgeId e) { return e.index() < scene.edge_count(); };
  const auto is_edge = [&](EdgeId e) { return e.index() < scene.edge_count() + segments.swap_edges.size(); };
  const auto is_point = [&](PointId p) { return p.index() < scene.points.size() + segments.crossings.size(); };
  const auto is_facet = [&](FacetId f) { return f.index() < scene.status.size(); };
  const auto require = [&](bool holds, const std::string& what) {
    if (!holds) messages.push_back(what + " names what does not exist");
  };
  for (std::size_t c = 0; c < segments.crossings.size(); ++c) {
    const Crossing& crossing = segments.crossings[c];
    require(is_edge(crossing.a) && is_edge(crossing.b) && crossing.after.index() <= scene.points.size(),
            crossing_name(c));
  }
  for (std::size_t i = 0; i < segments.segments.size(); ++i) {
    const VisibleSegment& s = segments.segments[i];
    require(is_point(s.start) && is_point(s.end) && is_edge(s.edge) && is_facet(s.facet) &&
                (is_facet(s.other) || !s.other.valid()),
            name(SegmentId(i)));
  }
  for (std::size_t t = 0; t < segments.threads.size(); ++t) {
    const Thread& thread = segments.threads[t];
    require(is_point(thread.top) && is_facet(thread.facet) && thread.segment.index() < segments.segments.size(),
            thread_name(t));
  }
  for (std::size_t s = 0; s < segments.splits.size(); ++s) {
    const EdgeSplit& split = segments.splits[s];
    require(is_point(split.point) && is_facet(split.facet) && is_scene_edge(split.edge), split_name(s));
  }
  return messages;
}

// Returns whether the ends of b lie strictly on different sides of a. Swap edges have no ends, and cross where they are not
// parallel.
bool separates(const EdgeSides& sides, const ProjectedScene& scene, EdgeId a, EdgeId b) {
  if (sides.is_swap_edge(b)) return sides.turn(a, b) != 0;
  return sides.side(a, scene.edge(b).top) * sides.side(a, scene.edge(b).bottom) < 0;
}

bool is_between(const CrossingOrder& order, const Crossing& crossing, std::size_t points) {
  const std::size_t after = crossing.after.index();
  return (after == 0 || order.compare(crossing, PointId(after - 1)) > 0) &&
         (after == points || order.compare(crossing, PointId(after)) < 0);
}

// A crossing is of two edges that cross strictly inside both, its place among the scene's points is the one it names,
// and crossings follow each other in sweep order: this is checked exactly, with the scene's points alone. Everything
// else may rely on it.
void check_crossings(const VisibleSegments& segments, const ProjectedScene& scene, Messages& messages) {
  VisibleSegments lines;
  lines.swap_edges = segments.swap_edges;
  const EdgeSides sides(scene, lines);
  const CrossingOrder order(scene, segments.swap_edges);
  const Crossing* previous = nullptr;
  for (std::size_t c = 0; c < segments.crossings.size(); ++c) {
    const Crossing& crossing = segments.crossings[c];
    const auto& [a, b, after] = crossing;
    if (!separates(sides, scene, a, b) || !separates(sides, scene, b, a)) {
      messages.push_back(crossing_name(c) + " is of " + name(a) + " and " + name(b) +
                         ", which do not cross inside both");
      continue;
    }
    if (!is_between(order, crossing, scene.points.size()))
      messages.push_back(crossing_name(c) + " is not where it should be between the scene's points");
    if (previous != nullptr && order.compare(*previous, crossing) >= 0)
      messages.push_back(crossing_name(c) + " does not follow the one before it in sweep order");
    previous = &crossing;
  }
}

class SegmentCheck {
 public:
  SegmentCheck(const VisibleSegments& segments, const ProjectedScene& scene, Messages& messages)
      : segments_(segments), scene_(scene), sides_(scene, segments), messages_(messages) {}

  void run() {
    for (std::size_t s = 0; s < segments_.segments.size(); ++s) check_ends(SegmentId(s));
    if (!messages_.empty()) return;
    for (std::size_t s = 0; s < segments_.segments.size(); ++s) {
      check_facets(SegmentId(s));
      check_splits_at_ends(SegmentId(s));
      if (s > 0) check_order(SegmentId(s - 1), SegmentId(s));
    }
    check_balance();
    check_overlaps();
    for (std::size_t t = 0; t < segments_.threads.size(); ++t) check_thread(t);
    for (std::size_t s = 0; s < segments_.splits.size(); ++s) check_split(s);
  }

 private:
  [[nodiscard]] const VisibleSegment& segment(SegmentId s) const { return segments_.segments[s.index()]; }
  [[nodiscard]] EdgeId line(SegmentId s) const { return segment(s).edge; }

  [[nodiscard]] bool is_inside(EdgeId e, PointId p) const {
    return sides_.is_on(e, p) && p != scene_.edge(e).top && p != scene_.edge(e).bottom;
  }

  void check_ends(SegmentId s) {
    const VisibleSegment& segment = this->segment(s);
    if (segment.start == segment.end) messages_.push_back(name(s) + " starts where it ends");
    for (const PointId p : {segment.start, segment.end}) {
      if (!sides_.is_on(segment.edge, p))
        messages_.push_back(name(s) + ": " + name(p) + " is not on " + name(segment.edge));
    }
  }

  // Returns the winding number of a facet right or left of an edge, just below a point of the edge.
  [[nodiscard]] int winding_beside(FacetId facet, PointId p, EdgeId edge, bool right) const {
    const auto polygon = scene_.polygon(facet);
    int winding = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const PointId from = polygon[i].point;
      const PointId to = polygon[i + 1 == polygon.size() ? 0 : i + 1].point;
      if (from == to) continue;
      const EdgeId side = sides_.edge_between(std::min(from, to), std::max(from, to));
      if (!sides_.crosses_below(side, p)) continue;
      const Sign place = sides_.place_beside(side, p, edge);
      if (place < 0 || (place == 0 && right)) winding += from < to ? 1 : -1;
    }
    return winding;
  }

  // The topmost facets beside a segment are recorded where it opens, at its upper end.
  void check_facets(SegmentId s) {
    const VisibleSegment& segment = this->segment(s);
    const PointId upper = sides_.upper(segment);
    const bool facet_is_right = sides_.runs_down(segment);
    if (segment.facet == segment.other) messages_.push_back(name(s) + " has " + name(segment.facet) + " on both sides");
    if (winding_beside(segment.facet, upper, segment.edge, facet_is_right) == 0)
      messages_.push_back(name(s) + ": " + name(segment.facet) + " is not to its left");
    if (segment.other.valid() && winding_beside(segment.other, upper, segment.edge, !facet_is_right) == 0)
      messages_.push_back(name(s) + ": " + name(segment.other) + " is not to its right");
  }

  // Where a segment ends inside an edge of its own facet, that edge is split.
  void check_splits_at_ends(SegmentId s) {
    const VisibleSegment& segment = this->segment(s);
    for (const EdgeSide& side : sides_along(scene_, segment)) {
      if (side.facet != segment.facet) continue;
      for (const PointId p : {segment.start, segment.end}) {
        const EdgeSplit split{side.mesh_edge, side.facet, segment.edge, p};
        if (is_inside(segment.edge, p) && !std::ranges::binary_search(segments_.splits, split))
          messages_.push_back(name(s) + ": no split of " + name(segment.edge) + " at " + name(p));
      }
    }
  }

  // Segments are ordered by the point where they open, then left to right; on one line the segment of the facet to the
  // left comes first.
  void check_order(SegmentId a, SegmentId b) {
    const PointId upper_a = sides_.upper(segment(a));
    const PointId upper_b = sides_.upper(segment(b));
    const Sign turn = sides_.turn(line(a), line(b));
    const bool left_to_right = turn > 0 || (turn == 0 && !sides_.runs_down(segment(a)) && sides_.runs_down(segment(b)));
    if (upper_a == upper_b ? !left_to_right : sides_.before(upper_b, upper_a))
      messages_.push_back(name(b) + " should come before " + name(a));
  }

  void check_balance() {
    std::vector<std::int64_t> balance(scene_.points.size() + segments_.crossings.size(), 0);
    for (const VisibleSegment& s : segments_.segments) {
      ++balance[s.start.index()];
      --balance[s.end.index()];
    }
    for (std::size_t p = 0; p < balance.size(); ++p) {
      if (balance[p] != 0) messages_.push_back("as many segments do not start as end at " + name(PointId(p)));
    }
  }

  // No two segments of one facet may overlap along one edge.
  void check_overlaps() {
    std::vector<SegmentId> order;
    for (std::size_t s = 0; s < segments_.segments.size(); ++s) order.emplace_back(s);
    const auto key = [this](SegmentId s) { return std::pair(segment(s).edge, segment(s).facet); };
    std::ranges::sort(order, [&](SegmentId a, SegmentId b) {
      if (key(a) != key(b)) return key(a) < key(b);
      const PointId upper_a = sides_.upper(segment(a));
      const PointId upper_b = sides_.upper(segment(b));
      return upper_a != upper_b ? sides_.before(upper_a, upper_b) : a < b;
    });
    for (std::size_t i = 1; i < order.size(); ++i) {
      if (key(order[i - 1]) == key(order[i]) &&
          sides_.before(sides_.upper(segment(order[i])), sides_.lower(segment(order[i - 1]))))
        messages_.push_back(name(order[i - 1]) + " and " + name(order[i]) + " overlap");
    }
  }

  // The segment a thread leads to is open at the thread's top, lies left of it and has its face to the right.
  void check_thread(std::size_t t) {
    const Thread& thread = segments_.threads[t];
    const VisibleSegment& s = segment(thread.segment);
    if (t > 0 && !sides_.before(segments_.threads[t - 1].top, thread.top))
      messages_.push_back(thread_name(t) + " does not follow the one before it in sweep order");
    const bool open = sides_.before(sides_.upper(s), thread.top) && sides_.before(thread.top, sides_.lower(s));
    if (!open || !sides_.runs_down(s) || sides_.side(line(thread.segment), thread.top) <= 0)
      messages_.push_back(thread_name(t) + " leads to " + name(thread.segment) +
                          ", which does not bound a face left of it");
  }

  void check_split(std::size_t i) {
    const EdgeSplit& split = segments_.splits[i];
    if (i > 0 && !(segments_.splits[i - 1] < split))
      messages_.push_back(split_name(i) + " is repeated or out of order");
    if (!is_inside(split.edge, split.point))
      messages_.push_back(split_name(i) + ": " + name(split.point) + " is not inside " + name(split.edge));
    const auto is_its_side = [&](const EdgeSide& side) {
      return side.facet == split.facet && side.mesh_edge == split.mesh_edge;
    };
    if (std::ranges::none_of(scene_.sides_of(split.edge), is_its_side))
      messages_.push_back(split_name(i) + ": " + name(split.edge) + " has no such side of " + name(split.facet));
  }

  const VisibleSegments& segments_;
  const ProjectedScene& scene_;
  const EdgeSides sides_;
  Messages& messages_;
};

}  // namespace

std::vector<std::string> validate(const VisibleSegments& segments, const ProjectedScene& scene) {
  Messages messages = check_ranges(segments, scene);
  if (!messages.empty()) return messages;
  check_crossings(segments, scene, messages);
  if (messages.empty()) SegmentCheck(segments, scene, messages).run();
  return messages;
}

}  // namespace sightline::inline sweep
