#include "reconstruct/labelling/surface_triangles.h"

#include <algorithm>

#include "geometry/mesh/facet_plane.h"
#include "reconstruct/labelling/surface_points.h"
#include "reconstruct/triangulation/constrained_delaunay.h"

namespace sightline::inline reconstruct {
namespace {

// A line is directed and runs between two points; it knows what lies to its left: the surface (kind 0), a visible part
// of it (1), or what reflects a panel (2 and on).
struct Line {
  PlanarPointId from;
  PlanarPointId to;
  std::size_t kind = 0;
  friend auto operator<=>(const Line&, const Line&) = default;
};

constexpr std::size_t border_line = 0;
constexpr std::size_t ring_line = 1;
constexpr std::size_t first_panel_line = 2;

class SurfaceTriangles {
 public:
  SurfaceTriangles(const LabelSources& from, const SurfaceInView& surface)
      : mesh_(from.mesh),
        scene_(from.scene),
        image_(from.points),
        segments_(from.segments),
        surface_(surface),
        edge_points_(from.edge_points),
        points_(from.points, surface.back_facing) {}

  std::vector<SurfaceTriangle> run(const NewVertices& vertices, InnerVertices& inner) {
    collect_border();
    collect_points(inner);
    const auto [a, b, c] = plane_corners(mesh_, surface_.surface);
    points_.place_in_plane(mesh_.position(a), mesh_.position(b), mesh_.position(c), vertices);
    add_border_lines();
    for (const SegmentId s : surface_.visible) add_segment(segments_.segments[s.index()], ring_line);
    for (const ReflectingSegment& r : surface_.reflecting) add_segment(r.segment, first_panel_line + r.panel);
    std::sort(lines_.begin(), lines_.end());
    std::vector<Constraint> constraints;
    for (const Line& line : lines_) constraints.push_back({line.from, line.to});
    add_regions(constrained_delaunay(points_, constraints));
    add_joins();
    return std::move(triangles_);
  }

 private:
  // This line runs between two points of a facet's border.
  struct BorderLine {
    PointId from_point;
    PointId to_point;
    VertexId from;
    VertexId to;
  };

  [[nodiscard]] VertexId welded(VertexId v) const { return v.index() < mesh_.weld.size() ? mesh_.weld[v.index()] : v; }

  // The lines of the facets' borders are collected without those that run both ways: there two facets of the surface
  // meet.
  void collect_border() {
    using Ends = std::array<VertexId, 2>;
    const auto ends = [this](const BorderLine& line) { return Ends{welded(line.from), welded(line.to)}; };
    std::vector<BorderLine> all;
    for (const auto& border : surface_.borders) {
      for (std::size_t i = 0; i < border.size(); ++i) {
        const ViewBorderPoint& next = border[i + 1 == border.size() ? 0 : i + 1];
        all.push_back({border[i].image, next.image, border[i].border.vertex, next.border.vertex});
      }
    }
    std::vector<Ends> directed;
    for (const BorderLine& line : all) directed.push_back(ends(line));
    std::sort(directed.begin(), directed.end());
    const auto count = [&directed](const Ends& e) {
      const auto [first, last] = std::equal_range(directed.begin(), directed.end(), e);
      return last - first;
    };
    for (const BorderLine& line : all) {
      const auto [from, to] = ends(line);
      if (count({from, to}) > count({to, from})) border_.push_back(line);
    }
  }

  void collect_points(InnerVertices& inner) {
    for (const BorderLine& line : border_) {
      points_.add(line.from_point, line.from);
      points_.add(line.to_point, line.to);
    }
    points_.sort();
    std::vector<PointId> inside;
    for (const SegmentId s : surface_.visible) {
      const PointId p = segments_.segments[s.index()].start;
      if (!points_.contains(p)) inside.push_back(p);
    }
    for (const ReflectingSegment& r : surface_.reflecting) {
      if (!points_.contains(r.segment.start)) inside.push_back(r.segment.start);
    }
    std::ranges::sort(inside);
    inside.erase(std::unique(inside.begin(), inside.end()), inside.end());
    const std::vector<KnownVertex> known = vertices_on_lines();
    for (const PointId p : inside) {
      const auto found = std::ranges::lower_bound(known, p, {}, &KnownVertex::point);
      const bool on_line = found != known.end() && found->point == p;
      points_.add(p, on_line ? found->vertex : inner.vertex_at(p, std::nullopt));
    }
    points_.sort();
  }

  struct KnownVertex {
    PointId point;
    VertexId vertex;
    friend auto operator<=>(const KnownVertex&, const KnownVertex&) = default;
  };

  // Returns the vertices on the lines between the surface's facets, too: a common line has one vertex at a point for
  // both faces on it.
  [[nodiscard]] std::vector<KnownVertex> vertices_on_lines() const {
    std::vector<KnownVertex> known;
    for (const auto& border : surface_.borders) {
      for (const ViewBorderPoint& p : border) known.push_back({p.image, p.border.vertex});
    }
    std::ranges::sort(known);
    return known;
  }

  void add_line(PointId from, PointId to, std::size_t kind) {
    if (from != to) lines_.push_back({points_.index(from), points_.index(to), kind});
  }

  void add_border_lines() {
    for (const BorderLine& line : border_) {
      if (surface_.back_facing) {
        add_line(line.to_point, line.from_point, border_line);
      } else {
        add_line(line.from_point, line.to_point, border_line);
      }
    }
  }

  // A segment is cut where points of the border lie on it: those of its own edge and, in a face with several facets or
  // in a scene that reflects, any. (What reflects a panel splits the view volume's border, too, even if it is below resolution.)
  void add_segment(const VisibleSegment& segment, std::size_t kind) {
    std::vector<PointId> cuts = points_on(segment);
    std::sort(cuts.begin(), cuts.end(), [&](PointId a, PointId b) { return image_.sweeps_before(a, b); });
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    if (!image_.sweeps_before(segment.start, segment.end)) std::reverse(cuts.begin(), cuts.end());
    PointId from = segment.start;
    for (const PointId p : cuts) {
      add_line(from, p, kind);
      from = p;
    }
    add_line(from, segment.end, kind);
  }

  [[nodiscard]] std::vector<PointId> points_on(const VisibleSegment& segment) const {
    const bool down = image_.sweeps_before(segment.start, segment.end);
    const PointId top = down ? segment.start : segment.end;
    const PointId bottom = down ? segment.end : segment.start;
    const auto between = [&](PointId p) { return image_.sweeps_before(top, p) && image_.sweeps_before(p, bottom); };
    std::vector<PointId> result;
    for (const EdgeSide& side : sides_along(scene_, segment)) {
      if (surface_of(mesh_, side.facet) != surface_.surface || !side.mesh_edge.valid()) continue;
      for (const EdgePoint& p : edge_points_.on(side.mesh_edge)) {
        if (between(p.point) && points_.contains(p.point)) result.push_back(p.point);
      }
    }
    if (surface_.borders.size() == 1 && !scene_.has_mirrored_lines) return result;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const PointId p = points_[PlanarPointId(i)].point;
      if (between(p) && image_.orientation(top, bottom, p) == 0) result.push_back(p);
    }
    return result;
  }

  [[nodiscard]] bool has_line(PlanarPointId from, PlanarPointId to, std::size_t kind) const {
    return std::binary_search(lines_.begin(), lines_.end(), Line{from, to, kind});
  }

  struct Region {
    bool visible = false;
    bool outside = false;
    std::uint64_t reflecting = 0;
  };

  [[nodiscard]] std::vector<Region> classify(const HalfEdgeTriangulation& triangulation, const Regions& regions) const {
    std::vector<Region> result(regions.count);
    for (std::size_t i = 0; i < triangulation.origin.size(); ++i) {
      const HalfEdgeId h(i);
      Region& region = result[regions.of_triangle[i / 3].index()];
      const PlanarPointId from = triangulation.from(h);
      const PlanarPointId to = triangulation.to(h);
      if (!triangulation.is_constrained(h)) {
        region.outside = region.outside || !triangulation.twin_of(h).valid();
        continue;
      }
      region.visible = region.visible || has_line(from, to, ring_line);
      region.outside = region.outside || (has_line(to, from, border_line) && !has_line(from, to, border_line));
    }
    if (!surface_.reflecting.empty()) classify_reflecting(triangulation, regions, result);
    return result;
  }

  // A region that only borders of reflecting parts bound does not show by them what else it lies in. So regions are
  // classified from the hull inwards, one after the other: crossing a line to its left is entering what lies to its
  // left.
  void classify_reflecting(const HalfEdgeTriangulation& triangulation, const Regions& regions,
                           std::vector<Region>& result) const {
    const std::vector<HalfEdgeId> entries = entries_from_hull(triangulation, regions);
    std::size_t kinds = first_panel_line;
    for (const Line& line : lines_) kinds = std::max(kinds, line.kind + 1);
    std::vector<std::vector<int>> windings(regions.count);
    for (const HalfEdgeId h : entries) {
      const HalfEdgeId twin = triangulation.twin_of(h);
      std::vector<int> inside(kinds, 0);
      if (twin.valid()) inside = windings[regions.of_triangle[twin.index() / 3].index()];
      const PlanarPointId from = triangulation.from(h);
      const PlanarPointId to = triangulation.to(h);
      for (std::size_t kind = ring_line; kind < kinds; ++kind)
        inside[kind] += (has_line(from, to, kind) ? 1 : 0) - (has_line(to, from, kind) ? 1 : 0);
      const std::size_t region = regions.of_triangle[h.index() / 3].index();
      result[region].visible = inside[ring_line] > 0;
      for (std::size_t kind = first_panel_line; kind < kinds; ++kind)
        result[region].reflecting |= std::uint64_t{inside[kind] > 0 ? 1U : 0U} << (kind - first_panel_line);
      windings[region] = std::move(inside);
    }
  }

  // Returns, per region, one half-edge of it that leads in from the hull, or from a region before.
  [[nodiscard]] static std::vector<HalfEdgeId> entries_from_hull(const HalfEdgeTriangulation& triangulation,
                                                                 const Regions& regions) {
    std::vector<HalfEdgeId> entries;
    std::vector<std::uint8_t> entered(regions.count, 0);
    const auto region_of = [&](HalfEdgeId h) { return regions.of_triangle[h.index() / 3].index(); };
    const auto enter = [&](HalfEdgeId h) {
      if (entered[region_of(h)] == 0) entries.push_back(h);
      entered[region_of(h)] = 1;
    };
    std::vector<std::vector<HalfEdgeId>> exits(regions.count);
    for (std::size_t i = 0; i < triangulation.origin.size(); ++i) {
      const HalfEdgeId h(i);
      if (!triangulation.twin_of(h).valid()) enter(h);
      if (triangulation.is_constrained(h) && triangulation.twin_of(h).valid()) exits[region_of(h)].push_back(h);
    }
    std::size_t done = 0;
    while (done < entries.size()) {
      for (const HalfEdgeId h : exits[region_of(entries[done++])]) enter(triangulation.twin_of(h));
    }
    return entries;
  }

  void add_regions(const HalfEdgeTriangulation& triangulation) {
    const Regions regions = flood_regions(triangulation);
    const std::vector<Region> kinds = classify(triangulation, regions);
    for (std::size_t t = 0; t < triangulation.triangle_count(); ++t) {
      const Region& kind = kinds[regions.of_triangle[t].index()];
      if (kind.outside && !kind.visible) continue;
      auto corners = triangulation.corners(TriangleId(t));
      if (surface_.back_facing) std::swap(corners[1], corners[2]);
      triangles_.push_back({{points_[corners[0]].vertex, points_[corners[1]].vertex, points_[corners[2]].vertex},
                            kind.visible,
                            kind.reflecting});
    }
  }

  // Along the border the triangulation runs from one standing vertex to the next; the surface's own line may have other
  // ends.
  void add_joins() {
    for (const BorderLine& line : border_) {
      const VertexId standing_from = points_[points_.index(line.from_point)].vertex;
      const VertexId standing_to = points_[points_.index(line.to_point)].vertex;
      add_join(standing_from, line.from, line.to);
      add_join(standing_from, line.to, standing_to);
    }
  }

  void add_join(VertexId a, VertexId b, VertexId c) {
    if (welded(a) == welded(b) || welded(b) == welded(c) || welded(c) == welded(a)) return;
    triangles_.push_back({{a, b, c}, false, 0});
  }

  const CutMesh& mesh_;
  const ProjectedScene& scene_;
  const ImagePoints& image_;
  const VisibleSegments& segments_;
  const SurfaceInView& surface_;
  const EdgePoints& edge_points_;
  std::vector<BorderLine> border_;
  SurfacePoints points_;
  std::vector<Line> lines_;
  std::vector<SurfaceTriangle> triangles_;
};

}  // namespace

std::vector<SurfaceTriangle> surface_triangles(const LabelSources& from, const SurfaceInView& surface,
                                               const NewVertices& vertices, InnerVertices& inner) {
  return SurfaceTriangles(from, surface).run(vertices, inner);
}

}  // namespace sightline::inline reconstruct
