#include "geometry/projected_scene.h"

#include <algorithm>

#include "geometry/clipping.h"
#include "geometry/facet_plane.h"
#include "geometry/unfiltered.h"
#include "geometry/vertex_projection.h"

namespace sightline {
namespace {

std::vector<ProjectedVertex> project_vertices(const Mesh& mesh, const Camera& camera, const Precision& precision) {
  std::vector<ProjectedVertex> projected(mesh.vertices.size());
  std::vector<std::uint8_t> used(mesh.vertices.size(), 0);
  for (const VertexId v : mesh.facets.corners) used[v.index()] = 1;
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (used[v] == 0) continue;
    projected[v] = project_vertex(mesh, VertexId(v), camera, precision.grid_bits);
    if (precision.arithmetic != Arithmetic::exact && projected[v].strictly_outside == 0) {
      projected[v].image = unfiltered::image_point(precision, mesh.vertices[v], camera);
    }
  }
  return projected;
}

// A facet that is edge-on is edge-on in any arithmetic: clipping needs that.
Facing facing_of(const Mesh& mesh, const Camera& camera, FacetId facet, Arithmetic arithmetic) {
  Sign side = side_of_plane(mesh, facet, camera.eye);
  if (arithmetic != Arithmetic::exact && side != 0) {
    const auto [a, b, c] = plane_corners(mesh, facet);
    side = unfiltered::orient3d(arithmetic, mesh.position(a), mesh.position(b), mesh.position(c), camera.eye);
  }
  return side > 0 ? Facing::front : (side < 0 ? Facing::back : Facing::edge_on);
}

struct OutcodeSummary {
  bool all_inside = true;
  bool none_inside = false;  // of some bound, nothing is strictly inside
};

OutcodeSummary summarize(std::span<const VertexId> corners, const std::vector<ProjectedVertex>& projected) {
  std::uint8_t any_outside = 0;
  std::uint8_t all_on_or_outside = 0xff;
  for (const VertexId v : corners) {
    any_outside |= projected[v.index()].strictly_outside;
    all_on_or_outside &= projected[v.index()].on_or_outside;
  }
  return {any_outside == 0, all_on_or_outside != 0};
}

// A facet's polygon with the image points still by value; they get their ids once all are known.
struct PlacedCorner {
  ImagePoint image;
  ClippedCorner corner;
};

PlacedCorner place(const ExactCorner& exact, const Mesh& mesh, const std::vector<ProjectedVertex>& projected,
                   int grid_bits) {
  PlacedCorner placed;
  placed.corner.vertex = exact.vertex;
  placed.corner.edge_after = exact.edge_after;
  placed.corner.on_edge = exact.on_edge;
  if (exact.vertex.valid()) {
    placed.image = projected[exact.vertex.index()].image;
    placed.corner.position = mesh.position(exact.vertex);
    placed.corner.w = projected[exact.vertex.index()].w;
  } else {
    placed.image = round_to_grid(exact, grid_bits);
    placed.corner.position = exact.position();
    placed.corner.w = exact.weight();
  }
  return placed;
}

class SceneBuilder {
 public:
  SceneBuilder(const Mesh& mesh, const Camera& camera, Sides sides, const Precision& precision)
      : mesh_(mesh), projected_(project_vertices(mesh, camera, precision)) {
    scene_.camera = camera;
    scene_.sides_shown = sides;
    scene_.arithmetic = precision.arithmetic;
    scene_.grid_bits = precision.grid_bits;
  }

  ProjectedScene build() {
    for (std::size_t f = 0; f < mesh_.facet_count(); ++f) add_facet(FacetId(f));
    scene_.polygon_begin.push_back(static_cast<std::uint32_t>(placed_.size()));
    number_points();
    collect_edges();
    return std::move(scene_);
  }

 private:
  void add_facet(FacetId f) {
    scene_.polygon_begin.push_back(static_cast<std::uint32_t>(placed_.size()));
    scene_.facing.push_back(facing_of(mesh_, scene_.camera, f, scene_.arithmetic));
    const OutcodeSummary summary = summarize(mesh_.corners(f), projected_);
    scene_.status.push_back(status_of(f, summary));
    if (scene_.status.back() != Status::in_view) return;
    if (summary.all_inside) {
      add_whole(f);
    } else {
      add_clipped(f);
    }
  }

  [[nodiscard]] Status status_of(FacetId f, const OutcodeSummary& summary) const {
    const Facing facing = scene_.facing[f.index()];
    if (facing == Facing::edge_on) return Status::edge_on;
    if (facing == Facing::back && scene_.sides_shown == Sides::front) return Status::culled;
    return summary.none_inside ? Status::out_of_view : Status::in_view;
  }

  void add_whole(FacetId f) {
    const auto corners = mesh_.corners(f);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const ProjectedVertex& vertex = projected_[corners[i].index()];
      placed_.push_back({vertex.image,
                         {.point = {},
                          .position = mesh_.position(corners[i]),
                          .w = vertex.w,
                          .vertex = corners[i],
                          .edge_after = mesh_.edges_of(f)[i],
                          .on_edge = {}}});
    }
  }

  void add_clipped(FacetId f) {
    const auto polygon = clip(mesh_, scene_.camera, f);
    if (polygon.empty()) scene_.status.back() = Status::out_of_view;
    for (const ExactCorner& corner : polygon) placed_.push_back(place(corner, mesh_, projected_, scene_.grid_bits));
  }

  // Corners that fall on one grid point are one point from here on.
  void number_points() {
    std::vector<std::uint32_t> order(placed_.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(),
              [this](std::uint32_t a, std::uint32_t b) { return sweeps_before(placed_[a].image, placed_[b].image); });
    for (const std::uint32_t i : order) {
      if (scene_.points.empty() || scene_.points.back() != placed_[i].image) scene_.points.push_back(placed_[i].image);
      placed_[i].corner.point = PointId(scene_.points.size() - 1);
    }
    scene_.polygon_corners.reserve(placed_.size());
    for (const PlacedCorner& placed : placed_) scene_.polygon_corners.push_back(placed.corner);
  }

  struct PlacedSide {
    PointId top;
    PointId bottom;
    EdgeSide side;
  };

  // The boundary of a facet that is counter-clockwise in the image runs down its left border: there the winding grows
  // from left to right.
  void add_sides(FacetId f, std::vector<PlacedSide>& sides) const {
    const auto polygon = scene_.polygon(f);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const PointId from = polygon[i].point;
      const PointId to = polygon[i + 1 == polygon.size() ? 0 : i + 1].point;
      if (from < to) sides.push_back({from, to, {f, 1, polygon[i].edge_after}});
      if (to < from) sides.push_back({to, from, {f, -1, polygon[i].edge_after}});
    }
  }

  void collect_edges() {
    std::vector<PlacedSide> sides;
    for (std::size_t f = 0; f < mesh_.facet_count(); ++f) add_sides(FacetId(f), sides);
    std::stable_sort(sides.begin(), sides.end(), [](const PlacedSide& a, const PlacedSide& b) {
      return a.top != b.top ? a.top < b.top : a.bottom < b.bottom;
    });
    for (const PlacedSide& side : sides) {
      if (scene_.edges.empty() || scene_.edges.back().top != side.top || scene_.edges.back().bottom != side.bottom) {
        scene_.edges.push_back({side.top, side.bottom, static_cast<std::uint32_t>(scene_.sides.size())});
      }
      scene_.sides.push_back(side.side);
    }
    scene_.edges.push_back({PointId{}, PointId{}, static_cast<std::uint32_t>(scene_.sides.size())});
  }

  const Mesh& mesh_;
  std::vector<ProjectedVertex> projected_;
  std::vector<PlacedCorner> placed_;
  ProjectedScene scene_;
};

}  // namespace

ProjectedScene project(const Mesh& mesh, const Camera& camera, Sides sides, const Precision& precision) {
  return SceneBuilder(mesh, camera, sides, precision).build();
}

}  // namespace sightline
