#include "sweep/bands/scene_part.h"

#include <algorithm>

#include "geometry/numbers/partition_index.h"
#include "sweep/segments/crossing_order.h"

namespace sightline::inline sweep {
namespace {

class PartBuilder {
 public:
  PartBuilder(const ProjectedScene& whole, const Continuation& continuation, std::span<const FacetId> kept)
      : whole_(whole), continuation_(continuation), kept_(kept) {}

  ScenePart build() {
    copy_settings();
    find_points_and_edges();
    add_facets();
    add_edges();
    return std::move(part_);
  }

 private:
  void copy_settings() {
    ProjectedScene& scene = part_.scene;
    scene.surface = whole_.surface;
    scene.camera = whole_.camera;
    scene.sides_shown = whole_.sides_shown;
    scene.arithmetic = whole_.arithmetic;
    scene.grid_bits = whole_.grid_bits;
    scene.facing = whole_.facing;
    scene.unrounded.made = whole_.unrounded.made;
    scene.status.assign(whole_.status.size(), FacetStatus::out_of_view);
  }

  void find_points_and_edges() {
    std::vector<std::uint8_t> used_edge(whole_.edge_count(), 0);
    std::vector<std::uint8_t> used_point(whole_.points.size(), 0);
    for (const FacetId f : kept_) {
      part_.scene.status[f.index()] = whole_.status[f.index()];
      for (const ClippedCorner& corner : whole_.polygon(f)) used_point[corner.point.index()] = 1;
      for (const EdgeId e : continuation_.edges_of(whole_, f)) {
        if (e.valid()) used_edge[e.index()] = 1;
      }
    }
    new_point_.resize(whole_.points.size());
    for (std::size_t p = 0; p < used_point.size(); ++p) {
      if (used_point[p] == 0) continue;
      new_point_[p] = PointId(part_.point.size());
      part_.point.emplace_back(p);
      part_.scene.points.push_back(whole_.points[p]);
      if (!whole_.is_unrounded()) continue;
      part_.scene.unrounded.places.push_back(whole_.unrounded.places[p]);
      part_.scene.unrounded.sources.push_back(whole_.unrounded.sources[p]);
    }
    for (std::size_t e = 0; e < used_edge.size(); ++e) {
      if (used_edge[e] != 0) part_.edge.emplace_back(e);
    }
  }

  [[nodiscard]] PointId new_point(PointId p) const { return new_point_[p.index()]; }

  void add_facets() {
    ProjectedScene& scene = part_.scene;
    scene.polygon_begin.reserve(whole_.status.size() + 1);
    for (const FacetId f : kept_) {
      scene.polygon_begin.resize(f.index() + 1, static_cast<std::uint32_t>(scene.polygon_corners.size()));
      for (ClippedCorner corner : whole_.polygon(f)) {
        corner.point = new_point(corner.point);
        if (corner.made.valid()) corner.made = add_made(whole_.made(corner));
        scene.polygon_corners.push_back(corner);
      }
    }
    scene.polygon_begin.resize(whole_.status.size() + 1, static_cast<std::uint32_t>(scene.polygon_corners.size()));
  }

  // The made corner is that of the corner that is added next.
  MadeCornerId add_made(MadeCorner made) {
    made.corner = static_cast<std::uint32_t>(part_.scene.polygon_corners.size());
    part_.scene.made_corners.push_back(made);
    return MadeCornerId(part_.scene.made_corners.size() - 1);
  }

  void add_edges() {
    ProjectedScene& scene = part_.scene;
    for (const EdgeId e : part_.edge) {
      const SceneEdge& edge = whole_.edge(e);
      scene.edges.push_back(
          {new_point(edge.top), new_point(edge.bottom), static_cast<std::uint32_t>(scene.sides.size())});
      for (const EdgeSide& side : whole_.sides_of(e)) {
        if (scene.status[side.facet.index()] == FacetStatus::in_view) scene.sides.push_back(side);
      }
    }
    scene.edges.push_back({PointId{}, PointId{}, static_cast<std::uint32_t>(scene.sides.size())});
  }

  const ProjectedScene& whole_;
  const Continuation& continuation_;
  const std::span<const FacetId> kept_;
  std::vector<PointId> new_point_;  // per point of the whole
  ScenePart part_;
};

// The swap edges of a part are those of the whole, under other ids.
class EdgeNames {
 public:
  EdgeNames(const ProjectedScene& whole, const ScenePart& part) : whole_(whole), part_(part) {}
  [[nodiscard]] EdgeId operator[](EdgeId e) const {
    const std::size_t own = part_.edge.size();
    return e.index() < own ? part_.edge[e.index()] : EdgeId(whole_.edge_count() + e.index() - own);
  }

 private:
  const ProjectedScene& whole_;
  const ScenePart& part_;
};

// Gives the points of a part's sweep their ids in the whole. A vertex that the part does not have may lie where edges
// of it cross: then the crossing is that vertex.
class PointNames {
 public:
  // Precondition: the segments' edges have their names in the whole. Crossings that are vertices there are left out.
  PointNames(const ProjectedScene& whole, const ScenePart& part, VisibleSegments& segments)
      : whole_(whole), part_(part), crossing_order_(whole, segments.swap_edges) {
    std::vector<Crossing> kept;
    for (Crossing crossing : segments.crossings) {
      crossing.after = first_not_before(crossing, crossing.after);
      const bool is_vertex =
          crossing.after.index() < whole.points.size() && crossing_order_.compare(crossing, crossing.after) == 0;
      names_.push_back(is_vertex ? crossing.after : PointId(whole.points.size() + kept.size()));
      if (!is_vertex) kept.push_back(crossing);
    }
    segments.crossings = std::move(kept);
  }

  [[nodiscard]] PointId operator[](PointId p) const {
    return p.index() < part_.point.size() ? part_.point[p.index()] : names_[p.index() - part_.point.size()];
  }

 private:
  // The point is among the whole's points from the part's last one before the crossing to the part's next one.
  [[nodiscard]] PointId first_not_before(const Crossing& crossing, PointId next) const {
    const std::size_t begin = next.index() == 0 ? 0 : part_.point[next.index() - 1].index();
    const std::size_t end =
        next.index() == part_.point.size() ? whole_.points.size() : part_.point[next.index()].index();
    const auto is_before = [&](std::size_t p) { return crossing_order_.compare(crossing, PointId(p)) > 0; };
    return PointId(partition_index(begin, end, is_before));
  }

  const ProjectedScene& whole_;
  const ScenePart& part_;
  const CrossingOrder crossing_order_;
  std::vector<PointId> names_;  // per crossing of the part
};

}  // namespace

ScenePart part_of(const ProjectedScene& whole, const Continuation& continuation, std::span<const FacetId> kept) {
  return PartBuilder(whole, continuation, kept).build();
}

VisibleSegments in_whole(const ProjectedScene& whole, const ScenePart& part, VisibleSegments segments) {
  const EdgeNames edge_names(whole, part);
  for (Crossing& crossing : segments.crossings) {
    crossing.a = edge_names[crossing.a];
    crossing.b = edge_names[crossing.b];
  }
  const PointNames names(whole, part, segments);
  for (VisibleSegment& segment : segments.segments) {
    segment.start = names[segment.start];
    segment.end = names[segment.end];
    segment.edge = edge_names[segment.edge];
  }
  for (Thread& thread : segments.threads) thread.top = names[thread.top];
  for (EdgeSplit& split : segments.splits) {
    split.edge = part.edge[split.edge.index()];
    split.point = names[split.point];
  }
  return segments;
}

}  // namespace sightline::inline sweep
