#include "peers/scene/exact_parts.h"

#include <algorithm>
#include <map>

#include "sweep/segments/image_points.h"

namespace sightline::peers {
namespace {

// A segment of an edge has its upper point first in the order of the sweep.
struct EdgeSegment {
  EdgeId edge;
  PointId upper;
  PointId lower;
};

bool is_of_mesh(const ProjectedScene& scene, EdgeId edge) {
  const auto sides = scene.sides_of(edge);
  return std::any_of(sides.begin(), sides.end(), [](const EdgeSide& side) { return side.mesh_edge.valid(); });
}

std::vector<EdgeSegment> sorted_segments(const ProjectedScene& scene, const VisibleSegments& segments,
                                         const SweepOrder& before) {
  std::vector<EdgeSegment> edge_segments;
  for (const VisibleSegment& s : segments.segments) {
    if (!is_of_mesh(scene, s.edge)) continue;
    const bool down = before(s.start, s.end);
    edge_segments.push_back({s.edge, down ? s.start : s.end, down ? s.end : s.start});
  }
  std::sort(edge_segments.begin(), edge_segments.end(), [&before](const EdgeSegment& p, const EdgeSegment& q) {
    return p.edge != q.edge ? p.edge < q.edge : before(p.upper, q.upper);
  });
  return edge_segments;
}

// The lines that are exactly visible are where the boundary of what is visible of a face runs along an edge of the
// mesh. Each point of an edge of the scene is there once, whichever of its faces' segments run along it; the window's
// border is no edge. This takes O(m log m) for m visible segments.
VisibleLines exact_lines(const ProjectedScene& scene, const VisibleSegments& segments) {
  const SweepOrder before(scene, segments);
  const ImagePoints points(scene, segments);
  VisibleLines lines;
  EdgeSegment last;
  const auto end_last = [&] {
    if (last.edge.valid()) lines.push_back({points.in_window(last.upper), points.in_window(last.lower)});
  };
  for (const EdgeSegment& segment : sorted_segments(scene, segments, before)) {
    if (segment.edge == last.edge && !before(last.lower, segment.upper)) {
      if (before(last.lower, segment.lower)) last.lower = segment.lower;
      continue;
    }
    end_last();
    last = segment;
  }
  end_last();
  return lines;
}

}  // namespace

VisibleParts visible_parts(const ProjectedScene& scene, const VisibleSegments& segments,
                           const VisiblePolygons& polygons) {
  const ImagePoints points(scene, segments);
  VisibleParts parts;
  for (const VisiblePolygon& polygon : polygons.polygons) {
    for (std::size_t r = polygon.first_ring; r < polygon.first_ring + polygon.ring_count; ++r) {
      VisiblePart part{polygon.face, {}};
      for (const SegmentId s : polygons.ring(r))
        part.ring.push_back(points.in_window(segments.segments[s.index()].start));
      parts.push_back(std::move(part));
    }
  }
  return parts;
}

ExactParts exact_parts(const ProjectedScene& scene, const VisibleSegments& segments, const VisiblePolygons& polygons) {
  ExactParts exact{visible_parts(scene, segments, polygons), exact_lines(scene, segments), {}};
  std::map<FaceId, bool> resolved;
  for (const VisiblePolygon& polygon : polygons.polygons) {
    exact.areas[polygon.face] += polygon.area;
    resolved[polygon.face] |= !polygon.below_resolution;
  }
  for (const auto& [face, is_resolved] : resolved) {
    if (!is_resolved) exact.areas.erase(face);
  }
  return exact;
}

}  // namespace sightline::peers
