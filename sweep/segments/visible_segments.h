// The sweep's result: directed segments of the boundary of what is visible of each face.
//
// Points: ids below scene.points.size() are the scene's points; the ids from there on are crossings, numbered in sweep
// order. A crossing is the pair of edges that makes it, never a computed point. Holds (validate(segments, scene) checks
// it):
//   - a segment's face lies to its left, all along; `other` lies to its right (invalid: nothing);
//   - the segments of one surface that start at a point are as many as end there;
//   - segments of one surface meet only in their end points.
// Source: Fang 1993, section 5.3.1 (visible segments, threads), tables 5.2 and 5.4.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "geometry/numbers/export.h"
#include "geometry/numbers/ids.h"
#include "geometry/projection/projected_scene.h"
#include "sweep/segments/swap_edge.h"

namespace sightline::inline sweep {

// A crossing is the point where two edges cross: of those that segments run along that start or end there, the lowest,
// and the lowest with another direction. The scene's points before it in sweep order are exactly those with a smaller
// id than `after`.
struct Crossing {
  EdgeId a;
  EdgeId b;
  PointId after;
};

struct VisibleSegment {
  PointId start;
  PointId end;
  FacetId facet;  // a facet to its left; its face is the face that is visible there
  FacetId other;  // the topmost facet to its right, at its upper end: it may change along the segment
  EdgeId edge;
};

// A thread runs from the top of what may be a hole to the nearest visible segment left of it, which bounds the same
// face: a hole belongs to the ring with that segment, or, where that is a hole too, to the ring it belongs to (Fang
// 5.3).
struct Thread {
  PointId top;
  FacetId facet;  // of the face around it
  SegmentId segment;
};

// A split is a point strictly inside an edge where the visible boundary of one of the edge's own facets has an end
// point.
struct EdgeSplit {
  MeshEdgeId mesh_edge;  // what splits it splits it for all faces on it; invalid: along the view volume's border
  FacetId facet;
  EdgeId edge;
  PointId point;
  friend auto operator<=>(const EdgeSplit&, const EdgeSplit&) = default;
};

struct SweepStatistics {
  std::uint64_t sweep_points = 0;
  std::uint64_t degenerate_sweep_points =
      0;  // more than one vertex event or pair of edges at once, or a vertex on an edge
  std::uint64_t crossings = 0;
  std::uint64_t depth_comparisons = 0;
  bool depth_is_transitive = true;  // false: over some span no facet was nearer than all others (node_list.h)
  predicates::Counts predicates;

  SweepStatistics& operator+=(const SweepStatistics& other) {
    sweep_points += other.sweep_points;
    degenerate_sweep_points += other.degenerate_sweep_points;
    crossings += other.crossings;
    depth_comparisons += other.depth_comparisons;
    depth_is_transitive = depth_is_transitive && other.depth_is_transitive;
    predicates.calls += other.predicates.calls;
    predicates.filtered += other.predicates.filtered;
    return *this;
  }
};

struct VisibleSegments {
  std::vector<SwapEdge> swap_edges;  // their ids follow those of the scene's edges; none on the grid
  std::vector<Crossing> crossings;
  std::vector<VisibleSegment> segments;  // by the sweep point at which they open, then left to right
  std::vector<Thread> threads;           // by sweep point
  std::vector<EdgeSplit> splits;         // sorted, distinct
  SweepStatistics statistics;
};

// Returns the sides of the segment's edge. A swap edge has none.
[[nodiscard]] inline std::span<const EdgeSide> sides_along(const ProjectedScene& scene, const VisibleSegment& segment) {
  return segment.edge.index() < scene.edge_count() ? scene.sides_of(segment.edge) : std::span<const EdgeSide>{};
}

// This is the exact place of a point of a scene on the grid: (x / denominator, y / denominator) in grid units, denominator > 0.
struct ExactPoint {
  Wide512 x;
  Wide512 y;
  Wide512 denominator;
};
// ImagePoints (image_points.h) is for many points, or for predicates on them.
[[nodiscard]] SIGHTLINE_EXPORT ExactPoint exact_point(const ProjectedScene& scene, const VisibleSegments& segments,
                                                      PointId p);

// Returns what of the above does not hold, one line each, with the ids; nothing for a valid value.
[[nodiscard]] SIGHTLINE_EXPORT std::vector<std::string> validate(const VisibleSegments& segments,
                                                                 const ProjectedScene& scene);

// The order of points in the sweep, scene points and crossings alike, is an O(1) comparison of ids.
class SweepOrder {
 public:
  SweepOrder(const ProjectedScene& scene, const VisibleSegments& segments) : scene_(&scene), segments_(&segments) {}
  [[nodiscard]] bool operator()(PointId a, PointId b) const { return key(a) < key(b); }

 private:
  [[nodiscard]] std::array<std::size_t, 2> key(PointId p) const {
    const std::size_t n = scene_->points.size();
    if (p.index() < n) return {2 * p.index() + 1, 0};
    return {2 * segments_->crossings[p.index() - n].after.index(), p.index()};
  }
  const ProjectedScene* scene_;
  const VisibleSegments* segments_;
};

}  // namespace sightline::inline sweep
