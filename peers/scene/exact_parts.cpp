#include "peers/scene/exact_parts.h"

#include "peers/scene/exact_lines.h"
#include "sweep/segments/image_points.h"

namespace sightline::peers {

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
