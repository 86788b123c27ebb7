#include "reconstruct/visible_pieces.h"

#include <algorithm>

#include "geometry/facet_plane.h"
#include "reconstruct/constrained_delaunay.h"
#include "reconstruct/lift.h"

namespace sightline {
namespace {

// The surface's points by image: exact there, and with their place in the surface's own plane for the shape of the
// triangles.
class SurfacePoints : public PlanarPoints {
 public:
  SurfacePoints(const ImagePoints& image) : image_(image) {}

  struct Entry {
    PointId point;
    VertexId vertex;  // the one that stands for all at this point
    Point2 in_plane;
  };

  // Of several vertices at one point, the lowest stands for all.
  void add(PointId point, VertexId vertex) { entries_.push_back({point, vertex, {}}); }

  void sort() {
    std::sort(entries_.begin(), entries_.end(), [this](const Entry& a, const Entry& b) {
      return a.point != b.point ? image_.sweeps_before(a.point, b.point) : a.vertex < b.vertex;
    });
    const auto same_point = [](const Entry& a, const Entry& b) { return a.point == b.point; };
    entries_.erase(std::unique(entries_.begin(), entries_.end(), same_point), entries_.end());
  }

  // Orthonormal coordinates in the plane of a, b, c. Rounded: they only choose between triangulations.
  void place_in_plane(const Point3& a, const Point3& b, const Point3& c, const std::vector<Point3>& vertices) {
    const Vector3 ab = b - a;
    const Vector3 x_axis = (1 / norm(ab)) * ab;
    const Vector3 normal = cross(x_axis, c - a);
    const Vector3 y_axis = (1 / norm(normal)) * cross(normal, x_axis);
    for (Entry& entry : entries_) {
      const Vector3 d = vertices[entry.vertex.index()] - a;
      entry.in_plane = {dot(d, x_axis), dot(d, y_axis)};
      placed_ = placed_ && std::isfinite(entry.in_plane.x) && std::isfinite(entry.in_plane.y);
    }
  }

  [[nodiscard]] bool contains(PointId p) const {
    const auto found = find(p);
    return found != entries_.end() && found->point == p;
  }
  [[nodiscard]] PlanarPointId index(PointId p) const {
    return PlanarPointId(static_cast<std::size_t>(find(p) - entries_.begin()));
  }
  [[nodiscard]] const Entry& operator[](PlanarPointId p) const { return entries_[p.index()]; }

  [[nodiscard]] std::size_t size() const override { return entries_.size(); }
  [[nodiscard]] Sign orient(PlanarPointId a, PlanarPointId b, PlanarPointId c) const override {
    return image_.orientation((*this)[a].point, (*this)[b].point, (*this)[c].point);
  }
  // A back-facing surface is clockwise in the image and, seen from the front, counter-clockwise in its plane.
  [[nodiscard]] bool flip_improves(PlanarPointId a, PlanarPointId b, PlanarPointId c, PlanarPointId d) const override {
    if (!placed_) return false;
    const Sign inside = in_circle((*this)[a].in_plane, (*this)[b].in_plane, (*this)[c].in_plane, (*this)[d].in_plane);
    return inside * mirror_ > 0;
  }
  void mirror() { mirror_ = -1; }

 private:
  [[nodiscard]] std::vector<Entry>::const_iterator find(PointId p) const {
    return std::lower_bound(entries_.begin(), entries_.end(), p,
                            [this](const Entry& e, PointId q) { return image_.sweeps_before(e.point, q); });
  }

  const ImagePoints& image_;
  std::vector<Entry> entries_;
  bool placed_ = true;
  Sign mirror_ = 1;
};

// A directed line between two points, and what lies to its left: the surface, or a visible part of it.
struct Line {
  PlanarPointId from;
  PlanarPointId to;
  bool ring = false;
  friend auto operator<=>(const Line&, const Line&) = default;
};

class VisiblePieces {
 public:
  VisiblePieces(const Mesh& mesh, const ProjectedScene& scene, const ImagePoints& image,
                const VisibleSegments& segments, const SurfaceInView& surface, const EdgePoints& edge_points)
      : mesh_(mesh),
        scene_(scene),
        image_(image),
        segments_(segments),
        surface_(surface),
        edge_points_(edge_points),
        points_(image) {}

  std::vector<Piece> run(const std::vector<Point3>& vertices, InnerVertices& inner) {
    collect_border();
    collect_points(inner);
    const auto [a, b, c] = plane_corners(mesh_, surface_.surface);
    points_.place_in_plane(mesh_.position(a), mesh_.position(b), mesh_.position(c), vertices);
    if (surface_.back_facing) points_.mirror();
    add_border_lines();
    for (const SegmentId s : surface_.visible) add_ring_line(segments_.segments[s.index()]);
    std::sort(lines_.begin(), lines_.end());
    std::vector<Constraint> constraints;
    for (const Line& line : lines_) constraints.push_back({line.from, line.to});
    add_regions(constrained_delaunay(points_, constraints));
    add_joins();
    return std::move(pieces_);
  }

 private:
  // A line between two points of a facet's border.
  struct BorderLine {
    PointId from_point;
    PointId to_point;
    VertexId from;
    VertexId to;
  };

  [[nodiscard]] VertexId welded(VertexId v) const { return v.index() < mesh_.weld.size() ? mesh_.weld[v.index()] : v; }

  // The lines of the facets' borders, without those that run both ways: there two facets of the surface meet.
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
    for (const PointId p : inside) points_.add(p, inner.at(p, std::nullopt));
    points_.sort();
  }

  void add_line(PointId from, PointId to, bool ring) {
    if (from != to) lines_.push_back({points_.index(from), points_.index(to), ring});
  }

  void add_border_lines() {
    for (const BorderLine& line : border_) {
      if (surface_.back_facing) {
        add_line(line.to_point, line.from_point, false);
      } else {
        add_line(line.from_point, line.to_point, false);
      }
    }
  }

  // Cut where points of the border lie on it: those of its own edge and, in a face with several facets, any.
  void add_ring_line(const VisibleSegment& segment) {
    std::vector<PointId> cuts = points_on(segment);
    std::sort(cuts.begin(), cuts.end(), [&](PointId a, PointId b) { return image_.sweeps_before(a, b); });
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    if (!image_.sweeps_before(segment.start, segment.end)) std::reverse(cuts.begin(), cuts.end());
    PointId from = segment.start;
    for (const PointId p : cuts) {
      add_line(from, p, true);
      from = p;
    }
    add_line(from, segment.end, true);
  }

  [[nodiscard]] std::vector<PointId> points_on(const VisibleSegment& segment) const {
    const bool down = image_.sweeps_before(segment.start, segment.end);
    const PointId top = down ? segment.start : segment.end;
    const PointId bottom = down ? segment.end : segment.start;
    const auto between = [&](PointId p) { return image_.sweeps_before(top, p) && image_.sweeps_before(p, bottom); };
    std::vector<PointId> result;
    for (const EdgeSide& side : scene_.sides_of(segment.edge)) {
      if (surface_of(mesh_, side.facet) != surface_.surface || !side.mesh_edge.valid()) continue;
      for (const EdgePoint& p : edge_points_.on(side.mesh_edge)) {
        if (between(p.point) && points_.contains(p.point)) result.push_back(p.point);
      }
    }
    if (surface_.borders.size() == 1) return result;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const PointId p = points_[PlanarPointId(i)].point;
      if (between(p) && image_.orientation(top, bottom, p) == 0) result.push_back(p);
    }
    return result;
  }

  [[nodiscard]] bool has_line(PlanarPointId from, PlanarPointId to, bool ring) const {
    return std::binary_search(lines_.begin(), lines_.end(), Line{from, to, ring});
  }

  struct Region {
    bool visible = false;
    bool outside = false;
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
      region.visible = region.visible || has_line(from, to, true);
      region.outside = region.outside || (has_line(to, from, false) && !has_line(from, to, false));
    }
    return result;
  }

  void add_regions(const HalfEdgeTriangulation& triangulation) {
    const Regions regions = flood_regions(triangulation);
    const std::vector<Region> kinds = classify(triangulation, regions);
    for (std::size_t t = 0; t < triangulation.triangle_count(); ++t) {
      const Region& kind = kinds[regions.of_triangle[t].index()];
      if (kind.outside && !kind.visible) continue;
      auto corners = triangulation.corners(TriangleId(t));
      if (surface_.back_facing) std::swap(corners[1], corners[2]);
      pieces_.push_back(
          {{points_[corners[0]].vertex, points_[corners[1]].vertex, points_[corners[2]].vertex}, kind.visible});
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
    pieces_.push_back({{a, b, c}, false});
  }

  const Mesh& mesh_;
  const ProjectedScene& scene_;
  const ImagePoints& image_;
  const VisibleSegments& segments_;
  const SurfaceInView& surface_;
  const EdgePoints& edge_points_;
  std::vector<BorderLine> border_;
  SurfacePoints points_;
  std::vector<Line> lines_;
  std::vector<Piece> pieces_;
};

}  // namespace

std::vector<Piece> visible_pieces(const Mesh& mesh, const ProjectedScene& scene, const ImagePoints& points,
                                  const VisibleSegments& segments, const SurfaceInView& surface,
                                  const EdgePoints& edge_points, const std::vector<Point3>& vertices,
                                  InnerVertices& inner) {
  return VisiblePieces(mesh, scene, points, segments, surface, edge_points).run(vertices, inner);
}

}  // namespace sightline
