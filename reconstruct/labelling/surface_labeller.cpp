#include "reconstruct/labelling/surface_labeller.h"

#include <algorithm>
#include <cmath>

#include "geometry/mesh/facet_plane.h"
#include "reconstruct/labelling/facet_border.h"
#include "reconstruct/labelling/new_vertices.h"
#include "reconstruct/labelling/outside_triangles.h"
#include "reconstruct/labelling/surface_triangles.h"
#include "reconstruct/triangulation/constrained_delaunay.h"

namespace sightline::inline reconstruct {
namespace {

class SurfaceLabeller {
 public:
  explicit SurfaceLabeller(const LabelSources& from)
      : from_(from),
        mesh_(from.mesh),
        scene_(from.scene),
        segments_(from.segments),
        polygons_(from.polygons),
        points_(from.points),
        edge_points_(from.edge_points),
        vertices_(from.vertices),
        inner_(scene_, points_, vertices_) {}

  // Labels the surfaces that begin in the range.
  LabelledPart run(std::size_t begin, std::size_t end) {
    FacetId surface = surface_of(mesh_, FacetId(begin));
    if (surface.index() < begin) surface = end_of_surface(mesh_, surface);
    next_polygon_ = static_cast<std::size_t>(
        std::ranges::lower_bound(polygons_.polygons, surface, {}, &VisiblePolygon::facet) - polygons_.polygons.begin());
    triangles_.reserve(end - begin);
    for (; surface.index() < end; surface = end_of_surface(mesh_, surface)) {
      add_surface(surface.index(), end_of_surface(mesh_, surface).index());
    }
    return {std::move(triangles_), vertices_.added()};
  }

 private:
  // The facets [begin, end) are one surface.
  void add_surface(std::size_t begin, std::size_t end) {
    const FacetId surface(begin);
    inner_.begin(surface);
    find_visible_segments_of(surface);
    const std::vector<SegmentId>& visible = visible_;
    bool seen = !visible.empty() && (end - begin > 1 || is_proper(scene_, surface));
    const auto reflecting = from_.reflecting_on(surface);
    if (seen && (!reflecting.empty() || !is_whole(visible, begin, end))) {
      if (add_partly_visible(begin, end, visible, reflecting)) return;
      seen = is_mostly_visible(begin, end);
    }
    for (std::size_t f = begin; f < end; f = end_of_uncut(f)) add_uniform_uncut(f, seen);
  }

  // Returns one past the last piece of the uncut facet that a facet was cut from.
  [[nodiscard]] std::size_t end_of_uncut(std::size_t f) const {
    return mesh_.end_piece(mesh_.uncut_facet(FacetId(f))).index();
  }

  // The uncut facet is added without the lines along which it was cut where no piece needs them.
  void add_uniform_uncut(std::size_t first, bool seen) {
    const std::size_t end = end_of_uncut(first);
    bool alike = true;
    for (std::size_t f = first; f < end; ++f) {
      alike = alike && scene_.status[f] == scene_.status[first] && !is_clipped(FacetId(f));
    }
    if (end - first > 1 && alike) {
      const bool seen_in_view = seen && is_in_view(first);
      const auto border = uncut_border(mesh_, edge_points_, mesh_.uncut_facet(FacetId(first)));
      add_convex(FacetId(first), border, uniform_label(FacetId(first), seen_in_view), seen_in_view);
      return;
    }
    for (std::size_t f = first; f < end; ++f) add_uniform(FacetId(f), seen && is_in_view(f));
  }

  [[nodiscard]] bool is_in_view(std::size_t f) const { return scene_.status[f] == FacetStatus::in_view; }

  // Returns the label of a facet whose part in view is all seen or not at all.
  [[nodiscard]] Label uniform_label(FacetId f, bool seen) const {
    if (scene_.facing[f.index()] != FacetFacing::front) return Label::back_facing;
    if (seen) return Label::visible;
    return scene_.status[f.index()] == FacetStatus::in_view ? Label::hidden : Label::out_of_view;
  }

  // Returns whether most of the surface's area in view is visible. Precondition: find_visible_segments_of was called
  // for it last.
  [[nodiscard]] bool is_mostly_visible(std::size_t begin, std::size_t end) const {
    double visible = 0;
    for (std::size_t p = next_polygon_; p > 0 && polygons_.polygons[p - 1].facet.index() == begin; --p) {
      visible += polygons_.polygons[p - 1].area;
    }
    double in_view = 0;
    for (std::size_t f = begin; f < end; ++f) {
      const auto polygon = scene_.polygon(FacetId(f));
      for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        in_view += std::fabs(static_cast<double>(twice_area(
            scene_.point(polygon[0].point), scene_.point(polygon[i].point), scene_.point(polygon[i + 1].point))));
      }
    }
    return visible > std::ldexp(in_view / 4, -2 * scene_.grid_bits);
  }

  // Only polygons above resolution count. Polygons are sorted by their surface.
  void find_visible_segments_of(FacetId surface) {
    visible_.clear();
    const auto& all = polygons_.polygons;
    while (next_polygon_ < all.size() && all[next_polygon_].facet < surface) ++next_polygon_;
    for (; next_polygon_ < all.size() && all[next_polygon_].facet == surface; ++next_polygon_) {
      const VisiblePolygon& polygon = all[next_polygon_];
      if (polygon.below_resolution) continue;
      for (std::size_t r = polygon.first_ring; r < polygon.first_ring + polygon.ring_count; ++r) {
        const auto ring = polygons_.ring(r);
        visible_.insert(visible_.end(), ring.begin(), ring.end());
      }
    }
  }

  // A ring that runs along the border of one convex polygon only is that border.
  [[nodiscard]] bool is_whole(const std::vector<SegmentId>& visible, std::size_t begin, std::size_t end) const {
    if (end - begin > 1) return false;
    return std::all_of(visible.begin(), visible.end(), [&](SegmentId s) {
      const auto sides = sides_along(scene_, segments_.segments[s.index()]);
      return std::any_of(sides.begin(), sides.end(), [&](const EdgeSide& side) { return side.facet.index() == begin; });
    });
  }

  [[nodiscard]] bool is_clipped(FacetId f) const {
    const auto polygon = scene_.polygon(f);
    return std::any_of(polygon.begin(), polygon.end(), [](const ClippedCorner& c) { return !c.edge_after.valid(); });
  }

  // Adds a facet whose part in view is all visible or not at all.
  void add_uniform(FacetId f, bool seen) {
    const bool front = scene_.facing[f.index()] == FacetFacing::front;
    const bool in_view = scene_.status[f.index()] == FacetStatus::in_view;
    const Label inside = uniform_label(f, seen);
    if (!in_view || !is_clipped(f) || (!front && !seen)) {
      add_whole_facet(f, inside, seen);
      return;
    }
    std::vector<BorderPoint> border;
    for (const ViewBorderPoint& p : view_border(from_, f, {}, inner_)) border.push_back(p.border);
    add_convex(f, border, inside, seen);
    add_outside(f, {});
  }

  // Returns false, and adds nothing, where the rounded border of a surface crosses itself: parts of it are narrower
  // than the grid, and its image is no polygon. Such a surface gets one label, that of most of its area.
  bool add_partly_visible(std::size_t begin, std::size_t end, const std::vector<SegmentId>& visible,
                          std::span<const ReflectingSegment> reflecting) {
    const bool front = scene_.facing[begin] == FacetFacing::front;
    SurfaceInView surface{FacetId(begin), !front, {}, visible, reflecting};
    for (std::size_t f = begin; f < end; ++f) {
      if (scene_.status[f] != FacetStatus::in_view) continue;
      surface.borders.push_back(view_border(from_, FacetId(f), from_.border_splits_of(FacetId(f)), inner_));
    }
    std::vector<SurfaceTriangle> triangles;
    try {
      triangles = surface_triangles(from_, surface, vertices_, inner_);
    } catch (const ConstraintConflict&) {
      return false;
    }
    for (const SurfaceTriangle& triangle : triangles) {
      const Label label = !front ? Label::back_facing : (triangle.visible ? Label::visible : Label::hidden);
      add_triangle(FacetId(begin), triangle.corners, label, triangle.visible);
      triangles_.back().reflecting = triangle.reflecting;
    }
    for (std::size_t f = begin; f < end; ++f) {
      if (scene_.status[f] != FacetStatus::in_view) {
        add_uniform(FacetId(f), false);
      } else if (is_clipped(FacetId(f))) {
        add_outside(FacetId(f), from_.border_splits_of(FacetId(f)));
      }
    }
    return true;
  }

  void add_outside(FacetId f, std::span<const EdgeSplit> splits) {
    const Label label = scene_.facing[f.index()] == FacetFacing::front ? Label::out_of_view : Label::back_facing;
    for (const auto& corners : outside_triangles(from_, f, splits, inner_)) {
      add_triangle(f, corners, label, false);
    }
  }

  // A triangle whose edges nothing splits stays as it is.
  void add_whole_facet(FacetId f, Label label, bool seen) {
    const auto edges = mesh_.edges_of(f);
    const bool is_split =
        std::any_of(edges.begin(), edges.end(), [this](MeshEdgeId e) { return !edge_points_.on(e).empty(); });
    if (edges.size() == 3 && !is_split) {
      const auto corners = mesh_.corners(f);
      add_triangle(f, {corners[0], corners[1], corners[2]}, label, seen);
    } else {
      add_convex(f, facet_border(mesh_, edge_points_, f), label, seen);
    }
  }

  void add_convex(FacetId f, const std::vector<BorderPoint>& border, Label label, bool seen) {
    std::vector<std::uint32_t> sides;
    for (const BorderPoint& p : border) sides.push_back(p.side);
    std::sort(sides.begin(), sides.end());
    if (std::unique(sides.begin(), sides.end()) - sides.begin() < 3) return;
    for (const auto& corners : convex_triangles(border)) add_triangle(f, corners, label, seen);
  }

  void add_triangle(FacetId f, const std::array<VertexId, 3>& corners, Label label, bool seen) {
    triangles_.push_back({corners, mesh_.facet_face[f.index()], surface_of(mesh_, f), label, seen});
  }

  const LabelSources& from_;
  const CutMesh& mesh_;
  const ProjectedScene& scene_;
  const VisibleSegments& segments_;
  const VisiblePolygons& polygons_;
  const ImagePoints& points_;
  const EdgePoints& edge_points_;
  NewVertices vertices_;
  SurfaceVertices inner_;
  std::vector<LabelledTriangle> triangles_;
  std::vector<SegmentId> visible_;  // of the current surface
  std::size_t next_polygon_ = 0;
};

}  // namespace

LabelledPart label_surfaces(const LabelSources& from, std::size_t begin, std::size_t end) {
  return SurfaceLabeller(from).run(begin, end);
}

}  // namespace sightline::inline reconstruct
