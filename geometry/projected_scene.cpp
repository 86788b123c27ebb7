#include "geometry/projected_scene.h"

#include <tbb/parallel_sort.h>

#include <algorithm>

#include "geometry/clipping.h"
#include "geometry/facet_plane.h"
#include "geometry/parallel.h"
#include "geometry/unfiltered.h"
#include "geometry/vertex_projection.h"

namespace sightline {
namespace {

std::vector<ProjectedVertex> project_vertices(const Mesh& mesh, const Camera& camera, const Precision& precision) {
  std::vector<ProjectedVertex> projected(mesh.vertices.size());
  std::vector<std::uint8_t> used(mesh.vertices.size(), 0);
  for (const VertexId v : mesh.facets.corners) used[v.index()] = 1;
  parallel_for_each(used.size(), [&](std::size_t v) {
    if (used[v] == 0) return;
    projected[v] = project_vertex(mesh, VertexId(v), camera, precision.grid_bits);
    if (precision.arithmetic != Arithmetic::exact && projected[v].strictly_outside == 0) {
      projected[v].image = unfiltered::image_point(precision, mesh.vertices[v], camera);
    }
  });
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

// A point of the image before points are numbered, and whose it is: a vertex's, or a corner's that clipping made.
struct Place {
  ImagePoint image;
  std::uint32_t owner = 0;
  bool is_vertex = false;
};

class SceneBuilder {
 public:
  SceneBuilder(const Mesh& mesh, const Camera& camera, Sides sides, const Precision& precision)
      : mesh_(mesh), projected_(project_vertices(mesh, camera, precision)), point_of_vertex_(mesh.vertices.size()) {
    scene_.camera = camera;
    scene_.sides_shown = sides;
    scene_.arithmetic = precision.arithmetic;
    scene_.grid_bits = precision.grid_bits;
  }

  ProjectedScene build() {
    find_statuses();
    reserve_corners();
    for (std::size_t f = 0; f < mesh_.facet_count(); ++f) add_facet(FacetId(f));
    scene_.polygon_begin.push_back(static_cast<std::uint32_t>(scene_.polygon_corners.size()));
    number_points();
    collect_edges();
    return std::move(scene_);
  }

 private:
  void find_statuses() {
    scene_.facing.resize(mesh_.facet_count());
    scene_.status.resize(mesh_.facet_count());
    parallel_for_each(mesh_.facet_count(), [this](std::size_t f) {
      scene_.facing[f] = facing_of(mesh_, scene_.camera, FacetId(f), scene_.arithmetic);
      scene_.status[f] = status_of(FacetId(f));
    });
  }

  // That of a facet that is in view may still change when it is clipped.
  [[nodiscard]] Status status_of(FacetId f) const {
    const Facing facing = scene_.facing[f.index()];
    if (facing == Facing::edge_on) return Status::edge_on;
    if (facing == Facing::back && scene_.sides_shown == Sides::front) return Status::culled;
    return summarize(mesh_.corners(f), projected_).none_inside ? Status::out_of_view : Status::in_view;
  }

  void reserve_corners() {
    std::size_t corners = 0;
    for (std::size_t f = 0; f < mesh_.facet_count(); ++f) {
      if (scene_.status[f] == Status::in_view) corners += mesh_.corners(FacetId(f)).size();
    }
    scene_.polygon_begin.reserve(mesh_.facet_count() + 1);
    scene_.polygon_corners.reserve(corners);
    places_.reserve(corners / 4);
  }

  void add_facet(FacetId f) {
    scene_.polygon_begin.push_back(static_cast<std::uint32_t>(scene_.polygon_corners.size()));
    if (scene_.status[f.index()] != Status::in_view) return;
    if (summarize(mesh_.corners(f), projected_).all_inside) {
      add_whole(f);
    } else {
      add_clipped(f);
    }
  }

  void add_whole(FacetId f) {
    const auto corners = mesh_.corners(f);
    const auto edges = mesh_.edges_of(f);
    for (std::size_t i = 0; i < corners.size(); ++i) add_vertex_corner(corners[i], edges[i]);
  }

  void add_clipped(FacetId f) {
    const auto polygon = clip(mesh_, scene_.camera, f);
    if (polygon.empty()) scene_.status[f.index()] = Status::out_of_view;
    for (const ExactCorner& corner : polygon) {
      if (corner.vertex.valid()) {
        add_vertex_corner(corner.vertex, corner.edge_after);
      } else {
        add_cut_corner(corner);
      }
    }
  }

  // The corner gets its point once all are known.
  void add_vertex_corner(VertexId v, MeshEdgeId edge_after) {
    const ProjectedVertex& vertex = projected_[v.index()];
    scene_.polygon_corners.push_back({.point = {},
                                      .position = mesh_.position(v),
                                      .w = vertex.w,
                                      .vertex = v,
                                      .edge_after = edge_after,
                                      .on_edge = {}});
    PointId& point = point_of_vertex_[v.index()];
    if (point.valid()) return;
    point = PointId(0);
    places_.push_back({vertex.image, v.value, true});
  }

  void add_cut_corner(const ExactCorner& corner) {
    places_.push_back(
        {round_to_grid(corner, scene_.grid_bits), static_cast<std::uint32_t>(scene_.polygon_corners.size()), false});
    scene_.polygon_corners.push_back({.point = {},
                                      .position = corner.position(),
                                      .w = corner.weight(),
                                      .vertex = {},
                                      .edge_after = corner.edge_after,
                                      .on_edge = corner.on_edge});
  }

  // Places that fall on one grid point are one point from here on.
  void number_points() {
    tbb::parallel_sort(places_.begin(), places_.end(),
                       [](const Place& a, const Place& b) { return sweeps_before(a.image, b.image); });
    for (const Place& place : places_) {
      if (scene_.points.empty() || scene_.points.back() != place.image) scene_.points.push_back(place.image);
      const PointId point(scene_.points.size() - 1);
      (place.is_vertex ? point_of_vertex_[place.owner] : scene_.polygon_corners[place.owner].point) = point;
    }
    parallel_for_each(scene_.polygon_corners.size(), [this](std::size_t i) {
      ClippedCorner& corner = scene_.polygon_corners[i];
      if (corner.vertex.valid()) corner.point = point_of_vertex_[corner.vertex.index()];
    });
  }

  struct PlacedSide {
    PointId top;
    PointId bottom;
    EdgeSide side;
  };

  // The boundary of a facet that is counter-clockwise in the image runs down its left border: there the winding grows
  // from left to right.
  template <class Visit>
  void for_each_side(Visit visit) const {
    for (std::size_t f = 0; f < mesh_.facet_count(); ++f) {
      const auto polygon = scene_.polygon(FacetId(f));
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const PointId from = polygon[i].point;
        const PointId to = polygon[i + 1 == polygon.size() ? 0 : i + 1].point;
        if (from < to) visit(PlacedSide{from, to, {FacetId(f), 1, polygon[i].edge_after}});
        if (to < from) visit(PlacedSide{to, from, {FacetId(f), -1, polygon[i].edge_after}});
      }
    }
  }

  // By their tops; those of one top stay in the order of facets.
  [[nodiscard]] std::vector<PlacedSide> sides_by_top(std::vector<std::uint32_t>& begin) const {
    begin.assign(scene_.points.size() + 1, 0);
    for_each_side([&](const PlacedSide& side) { ++begin[side.top.index() + 1]; });
    for (std::size_t p = 1; p < begin.size(); ++p) begin[p] += begin[p - 1];
    std::vector<PlacedSide> sides(begin.back());
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    for_each_side([&](const PlacedSide& side) { sides[next[side.top.index()]++] = side; });
    return sides;
  }

  void collect_edges() {
    std::vector<std::uint32_t> begin;
    std::vector<PlacedSide> sides = sides_by_top(begin);
    scene_.sides.reserve(sides.size());
    for (std::size_t p = 0; p + 1 < begin.size(); ++p) {
      const auto of_top = std::span(sides).subspan(begin[p], begin[p + 1] - begin[p]);
      std::ranges::stable_sort(of_top, {}, &PlacedSide::bottom);
      for (const PlacedSide& side : of_top) add_side(side);
    }
    scene_.edges.push_back({PointId{}, PointId{}, static_cast<std::uint32_t>(scene_.sides.size())});
  }

  void add_side(const PlacedSide& side) {
    if (scene_.edges.empty() || scene_.edges.back().top != side.top || scene_.edges.back().bottom != side.bottom) {
      scene_.edges.push_back({side.top, side.bottom, static_cast<std::uint32_t>(scene_.sides.size())});
    }
    scene_.sides.push_back(side.side);
  }

  const Mesh& mesh_;
  std::vector<ProjectedVertex> projected_;
  std::vector<PointId> point_of_vertex_;  // valid once a facet in view has the vertex
  std::vector<Place> places_;
  ProjectedScene scene_;
};

}  // namespace

ProjectedScene project(const Mesh& mesh, const Camera& camera, Sides sides, const Precision& precision) {
  return SceneBuilder(mesh, camera, sides, precision).build();
}

}  // namespace sightline
