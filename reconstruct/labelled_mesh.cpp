#include "reconstruct/labelled_mesh.h"

#include <algorithm>
#include <cmath>

#include "geometry/facet_plane.h"
#include "reconstruct/constrained_delaunay.h"
#include "reconstruct/edge_points.h"
#include "reconstruct/facet_border.h"
#include "reconstruct/outside_pieces.h"
#include "reconstruct/rounded_facet.h"
#include "reconstruct/surface_vertices.h"
#include "reconstruct/visible_pieces.h"
#include "sweep/image_points.h"

namespace sightline {
namespace {

class Labeller {
 public:
  Labeller(const Mesh& mesh, const ProjectedScene& scene, const VisibleSegments& segments,
           const VisiblePolygons& polygons, const PanelBorders& panels)
      : mesh_(mesh),
        scene_(scene),
        segments_(segments),
        polygons_(polygons),
        points_(scene, segments),
        result_{mesh.vertices, {}},
        edge_points_(mesh, scene, segments, points_, result_.vertices),
        inner_(mesh, scene, points_, result_.vertices) {
    const auto first_border_split = std::partition_point(segments.splits.begin(), segments.splits.end(),
                                                         [](const EdgeSplit& s) { return s.mesh_edge.valid(); });
    border_splits_.assign(first_border_split, segments.splits.end());
    std::sort(border_splits_.begin(), border_splits_.end(), by_facet);
    for (std::size_t panel = 0; panel < panels.size(); ++panel) {
      for (const VisibleSegment& s : panels[panel]) reflecting_.push_back({s, panel});
    }
    std::ranges::stable_sort(reflecting_, {}, [](const ReflectingSegment& r) { return r.segment.facet; });
  }

  LabelledMesh run() {
    result_.triangles.reserve(mesh_.facet_count());
    for (FacetId surface(0); surface.index() < mesh_.facet_count(); surface = end_of_surface(mesh_, surface)) {
      add_surface(surface.index(), end_of_surface(mesh_, surface).index());
    }
    drop_unused_vertices();
    return std::move(result_);
  }

 private:
  // A split of a line between two facets of one planar face may turn out to be no border of anything.
  void drop_unused_vertices() {
    const std::size_t input = mesh_.input_vertex_count();
    std::vector<std::uint8_t> used(result_.vertices.size() - input, 0);
    for_each_new_vertex([&](const VertexId& v) { used[v.index() - input] = 1; });
    if (std::ranges::count(used, 0) == 0) return;
    std::vector<VertexId> renamed(used.size());
    std::size_t kept = input;
    for (std::size_t i = 0; i < used.size(); ++i) {
      if (used[i] == 0) continue;
      result_.vertices[kept] = result_.vertices[input + i];
      renamed[i] = VertexId(kept++);
    }
    result_.vertices.resize(kept);
    for_each_new_vertex([&](VertexId& v) { v = renamed[v.index() - input]; });
  }

  template <class Visit>
  void for_each_new_vertex(Visit visit) {
    const std::size_t input = mesh_.input_vertex_count();
    for (LabelledTriangle& t : result_.triangles) {
      for (VertexId& v : t.corners) {
        if (v.index() >= input) visit(v);
      }
    }
  }

  static bool by_facet(const EdgeSplit& a, const EdgeSplit& b) { return a.facet < b.facet; }

  // The facets [begin, end) are one surface.
  void add_surface(std::size_t begin, std::size_t end) {
    const FacetId surface(begin);
    inner_.begin(surface);
    find_visible_segments_of(surface);
    const std::vector<SegmentId>& visible = visible_;
    bool seen = !visible.empty() && (end - begin > 1 || is_proper(mesh_, scene_, surface));
    const auto reflecting = reflecting_on(surface);
    if (seen && (!reflecting.empty() || !is_whole(visible, begin, end))) {
      if (add_partly_visible(begin, end, visible, reflecting)) return;
      seen = is_mostly_visible(begin, end);
    }
    for (std::size_t f = begin; f < end; f = end_of_whole(f)) add_uniform_whole(f, seen);
  }

  // One past the last piece of the whole that a facet was cut from.
  [[nodiscard]] std::size_t end_of_whole(std::size_t f) const {
    return mesh_.is_cut() ? mesh_.cuts.first_facet[mesh_.cuts.whole_of[f].index() + 1].index() : f + 1;
  }

  // Without the lines along which it was cut where no piece needs them.
  void add_uniform_whole(std::size_t first, bool seen) {
    const std::size_t end = end_of_whole(first);
    bool alike = true;
    for (std::size_t f = first; f < end; ++f) {
      alike = alike && scene_.status[f] == scene_.status[first] && !is_clipped(FacetId(f));
    }
    if (end - first > 1 && alike) {
      const bool seen_in_view = seen && is_in_view(first);
      const auto border = whole_border(mesh_, edge_points_, mesh_.cuts.whole_of[first]);
      add_convex(FacetId(first), border, uniform_label(FacetId(first), seen_in_view), seen_in_view);
      return;
    }
    for (std::size_t f = first; f < end; ++f) add_uniform(FacetId(f), seen && is_in_view(f));
  }

  [[nodiscard]] bool is_in_view(std::size_t f) const { return scene_.status[f] == Status::in_view; }

  // Of a facet whose part in view is all seen or not at all.
  [[nodiscard]] Label uniform_label(FacetId f, bool seen) const {
    if (scene_.facing[f.index()] != Facing::front) return Label::back_facing;
    if (seen) return Label::visible;
    return scene_.status[f.index()] == Status::in_view ? Label::hidden : Label::out_of_view;
  }

  // Of the surface's area in view. Precondition: find_visible_segments_of was called for it last.
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

  // Of the polygons above resolution. Polygons are sorted by their surface.
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
      const auto sides = scene_.sides_of(segments_.segments[s.index()].edge);
      return std::any_of(sides.begin(), sides.end(), [&](const EdgeSide& side) { return side.facet.index() == begin; });
    });
  }

  [[nodiscard]] bool is_clipped(FacetId f) const {
    const auto polygon = scene_.polygon(f);
    return std::any_of(polygon.begin(), polygon.end(), [](const ClippedCorner& c) { return !c.edge_after.valid(); });
  }

  // A facet whose part in view is all visible or not at all.
  void add_uniform(FacetId f, bool seen) {
    const bool front = scene_.facing[f.index()] == Facing::front;
    const bool in_view = scene_.status[f.index()] == Status::in_view;
    const Label inside = uniform_label(f, seen);
    if (!in_view || !is_clipped(f) || (!front && !seen)) {
      add_whole_facet(f, inside, seen);
      return;
    }
    std::vector<BorderPoint> border;
    for (const ViewBorderPoint& p : view_border(mesh_, scene_, points_, edge_points_, f, {}, inner_))
      border.push_back(p.border);
    add_convex(f, border, inside, seen);
    add_outside(f, {});
  }

  // False, and nothing added, where the rounded border of a surface crosses itself: parts of it are narrower than the
  // grid, and its image is no polygon. Such a surface gets one label, that of most of its area.
  bool add_partly_visible(std::size_t begin, std::size_t end, const std::vector<SegmentId>& visible,
                          std::span<const ReflectingSegment> reflecting) {
    const bool front = scene_.facing[begin] == Facing::front;
    SurfaceInView surface{FacetId(begin), !front, {}, visible, reflecting};
    for (std::size_t f = begin; f < end; ++f) {
      if (scene_.status[f] != Status::in_view) continue;
      surface.borders.push_back(
          view_border(mesh_, scene_, points_, edge_points_, FacetId(f), border_splits_of(FacetId(f)), inner_));
    }
    std::vector<Piece> pieces;
    try {
      pieces = visible_pieces(mesh_, scene_, points_, segments_, surface, edge_points_, result_.vertices, inner_);
    } catch (const ConstraintConflict&) {
      return false;
    }
    for (const Piece& piece : pieces) {
      const Label label = !front ? Label::back_facing : (piece.visible ? Label::visible : Label::hidden);
      add_triangle(FacetId(begin), piece.corners, label, piece.visible);
      result_.triangles.back().reflecting = piece.reflecting;
    }
    for (std::size_t f = begin; f < end; ++f) {
      if (scene_.status[f] != Status::in_view) {
        add_uniform(FacetId(f), false);
      } else if (is_clipped(FacetId(f))) {
        add_outside(FacetId(f), border_splits_of(FacetId(f)));
      }
    }
    return true;
  }

  [[nodiscard]] std::span<const ReflectingSegment> reflecting_on(FacetId surface) const {
    const auto by_surface = [](const ReflectingSegment& a, const ReflectingSegment& b) {
      return a.segment.facet < b.segment.facet;
    };
    ReflectingSegment wanted;
    wanted.segment.facet = surface;
    const auto [first, last] = std::equal_range(reflecting_.begin(), reflecting_.end(), wanted, by_surface);
    return {first, last};
  }

  [[nodiscard]] std::span<const EdgeSplit> border_splits_of(FacetId f) const {
    const auto [first, last] =
        std::equal_range(border_splits_.begin(), border_splits_.end(), EdgeSplit{{}, f, {}, {}}, by_facet);
    return {first, last};
  }

  void add_outside(FacetId f, std::span<const EdgeSplit> splits) {
    const Label label = scene_.facing[f.index()] == Facing::front ? Label::out_of_view : Label::back_facing;
    for (const auto& corners : outside_pieces(mesh_, scene_, points_, edge_points_, f, splits, inner_)) {
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
    for (const auto& corners : convex_pieces(border)) add_triangle(f, corners, label, seen);
  }

  void add_triangle(FacetId f, const std::array<VertexId, 3>& corners, Label label, bool seen) {
    result_.triangles.push_back({corners, mesh_.facet_face[f.index()], surface_of(mesh_, f), label, seen});
  }

  const Mesh& mesh_;
  const ProjectedScene& scene_;
  const VisibleSegments& segments_;
  const VisiblePolygons& polygons_;
  const ImagePoints points_;
  LabelledMesh result_;
  const EdgePoints edge_points_;
  SurfaceVertices inner_;
  std::vector<EdgeSplit> border_splits_;       // along the view volume's border, by facet
  std::vector<ReflectingSegment> reflecting_;  // by surface, then by panel
  std::vector<SegmentId> visible_;             // of the current surface
  std::size_t next_polygon_ = 0;
};

// Labelling builds on what the stages before it promise, which float and double do not always keep.
void require_valid(const Mesh& mesh, const ProjectedScene& scene, const VisibleSegments& segments,
                   const VisiblePolygons& polygons) {
  for (const auto& messages : {validate(segments, scene), validate(polygons, mesh, scene, segments)}) {
    if (!messages.empty()) throw ArithmeticError(to_string(scene.arithmetic), messages.front());
  }
}

}  // namespace

const char* to_string(Label label) {
  switch (label) {
    case Label::back_facing:
      return "back_facing";
    case Label::out_of_view:
      return "out_of_view";
    case Label::hidden:
      return "hidden";
    case Label::visible:
      return "visible";
  }
  return "";
}

LabelledMesh label_mesh(const Mesh& mesh, const ProjectedScene& scene, const VisibleSegments& segments,
                        const VisiblePolygons& polygons, const PanelBorders& panels) {
  if (scene.arithmetic != Arithmetic::exact) require_valid(mesh, scene, segments, polygons);
  return with_invariants_of(scene.arithmetic, [&] { return Labeller(mesh, scene, segments, polygons, panels).run(); });
}

}  // namespace sightline
