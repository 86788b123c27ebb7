#include "reflect/reflecting_border.h"

#include <algorithm>
#include <map>

#include "geometry/mesh/facet_plane.h"
#include "geometry/numbers/errors.h"
#include "reconstruct/polygons/ring_linker.h"
#include "sweep/segments/edge_sides.h"

namespace sightline::inline reflect {
namespace {

// This has the segments of one surface, and finds the nearest of them left of a point.
class SurfaceBorder {
 public:
  SurfaceBorder(VisibleSegments& segments, const EdgeSides& sides, const std::vector<SegmentId>& ids)
      : segments_(segments), sides_(sides), ids_(ids) {}

  void add_threads() {
    for (const Walk& walk : link_rings(sides_.points(), sides_.points().order(), segments_, ids_)) {
      if (!walk.has_outer()) segments_.threads.push_back({walk.top, segment(ids_.front()).facet, left_of(walk.top)});
    }
  }

 private:
  [[nodiscard]] const VisibleSegment& segment(SegmentId s) const { return segments_.segments[s.index()]; }

  // None of the hole's own segments is left of its top.
  [[nodiscard]] SegmentId left_of(PointId top) const {
    SegmentId nearest;
    for (const SegmentId s : ids_) {
      const VisibleSegment& candidate = segment(s);
      if (sides_.before(top, sides_.upper(candidate)) || !sides_.before(top, sides_.lower(candidate))) continue;
      if (sides_.side(candidate.edge, top) <= 0) continue;
      if (!nearest.valid() || lies_right_of(candidate, segment(nearest))) nearest = s;
    }
    if (!nearest.valid()) throw InternalError("nothing lies left of the hole at point " + std::to_string(top.value));
    return nearest;
  }

  // Precondition: the sweep line meets both segments at once, and they do not cross.
  [[nodiscard]] bool lies_right_of(const VisibleSegment& s, const VisibleSegment& t) const {
    const EdgeId of_s = s.edge;
    const EdgeId of_t = t.edge;
    if (sides_.before(sides_.upper(s), sides_.upper(t))) {
      const Sign t_beside_s = sides_.side(of_s, sides_.upper(t));
      return t_beside_s != 0 ? t_beside_s < 0 : sides_.turn(of_t, of_s) > 0;
    }
    const Sign s_beside_t = sides_.side(of_t, sides_.upper(s));
    return s_beside_t != 0 ? s_beside_t > 0 : sides_.turn(of_t, of_s) > 0;
  }

  VisibleSegments& segments_;
  const EdgeSides& sides_;
  const std::vector<SegmentId>& ids_;
};

// Calls visit(ids) with the segments of one surface after another.
template <class Visit>
void for_each_surface(const CutMesh& mesh, const VisibleSegments& segments, Visit visit) {
  std::vector<std::pair<FacetId, SegmentId>> sorted;
  for (std::size_t s = 0; s < segments.segments.size(); ++s)
    sorted.emplace_back(surface_of(mesh, segments.segments[s].facet), SegmentId(s));
  std::ranges::sort(sorted);
  for (std::size_t begin = 0; begin < sorted.size();) {
    std::vector<SegmentId> ids;
    const FacetId surface = sorted[begin].first;
    for (; begin < sorted.size() && sorted[begin].first == surface; ++begin) ids.push_back(sorted[begin].second);
    visit(surface, ids);
  }
}

// Returns the edges along which a surface that reflects is visible.
std::map<FacetId, std::vector<EdgeId>> edges_of_reflecting(const VisibleSegments& reflecting,
                                                           const ProjectedScene& scene,
                                                           const VisibleSegments& visible) {
  const CutMesh& mesh = scene.mesh();
  std::map<FacetId, std::vector<EdgeId>> edges_of;
  std::vector<bool> reflects(mesh.facet_count());
  for (const VisibleSegment& s : reflecting.segments) {
    reflects[surface_of(mesh, s.facet).index()] = true;
    edges_of[surface_of(mesh, s.facet)];
  }
  for (const VisibleSegment& s : visible.segments) {
    const FacetId surface = surface_of(mesh, s.facet);
    if (reflects[surface.index()] && s.edge.index() < scene.edge_count()) edges_of[surface].push_back(s.edge);
  }
  return edges_of;
}

std::vector<PointId> start_points(const VisibleSegments& segments, const std::vector<SegmentId>& ids) {
  std::vector<PointId> points;
  for (const SegmentId s : ids) points.push_back(segments.segments[s.index()].start);
  std::ranges::sort(points);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

}  // namespace

VisibleSegments reflecting_segments(const MergedScene& merged, std::vector<SurfaceSegment> segments) {
  const CutMesh& mesh = merged.scene.mesh();
  const SweepOrder before(merged.scene, merged.segments);
  VisibleSegments result;
  result.swap_edges = merged.segments.swap_edges;
  result.crossings = merged.segments.crossings;
  const auto upper = [&](const NumberedSegment& p) { return before(p.start, p.end) ? p.start : p.end; };
  std::ranges::stable_sort(segments, [&](const SurfaceSegment& a, const SurfaceSegment& b) {
    return before(upper(a.segment), upper(b.segment));
  });
  for (const auto& [surface, segment] : segments)
    result.segments.push_back({segment.start, segment.end, surface, FacetId{}, segment.edge});
  const EdgeSides sides(merged.scene, result);
  for_each_surface(mesh, result, [&](FacetId /*surface*/, const std::vector<SegmentId>& ids) {
    SurfaceBorder(result, sides, ids).add_threads();
  });
  std::ranges::stable_sort(result.threads, [&](const Thread& a, const Thread& b) { return before(a.top, b.top); });
  return result;
}

void find_splits(VisibleSegments& reflecting, const ProjectedScene& scene, const VisibleSegments& visible) {
  const CutMesh& mesh = scene.mesh();
  if (reflecting.segments.empty()) return;
  const EdgeSides sides(scene, visible);
  auto edges_of = edges_of_reflecting(reflecting, scene, visible);
  for_each_surface(mesh, reflecting, [&](FacetId surface, const std::vector<SegmentId>& ids) {
    auto& edges = edges_of.at(surface);
    std::ranges::sort(edges);
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    for (const PointId p : start_points(reflecting, ids)) {
      for (const EdgeId e : edges) {
        if (!sides.is_on(e, p) || p == scene.edge(e).top || p == scene.edge(e).bottom) continue;
        for (const EdgeSide& side : scene.sides_of(e)) {
          if (surface_of(mesh, side.facet) == surface) reflecting.splits.push_back({side.mesh_edge, side.facet, e, p});
        }
      }
    }
  });
  std::ranges::sort(reflecting.splits);
  reflecting.splits.erase(std::unique(reflecting.splits.begin(), reflecting.splits.end()), reflecting.splits.end());
}

}  // namespace sightline::inline reflect
