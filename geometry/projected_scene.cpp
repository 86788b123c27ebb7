#include "geometry/projected_scene.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <atomic>

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
  parallel_for_each(mesh.facets.corners.size(), [&](std::size_t corner) {
    std::atomic_ref(used[mesh.facets.corners[corner].index()]).store(1, std::memory_order_relaxed);
  });
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
    add_corners();
    number_points();
    collect_edges();
    return std::move(scene_);
  }

 private:
  // Facets by ranges: each is worked on by one thread.
  struct Clipped {
    FacetId facet;
    std::vector<ExactCorner> polygon;
  };

  void find_statuses() {
    scene_.facing.resize(mesh_.facet_count());
    scene_.status.resize(mesh_.facet_count());
    scene_.polygon_begin.assign(mesh_.facet_count() + 1, 0);
    clipped_.resize(range_count(mesh_.facet_count()));
    parallel_for_ranges(mesh_.facet_count(), [this](std::size_t range, std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f) {
        scene_.facing[f] = facing_of(mesh_, scene_.camera, FacetId(f), scene_.arithmetic);
        scene_.status[f] = status_of(FacetId(f));
        if (scene_.status[f] == Status::in_view)
          scene_.polygon_begin[f + 1] = count_corners(FacetId(f), clipped_[range]);
      }
    });
    for (std::size_t f = 0; f < mesh_.facet_count(); ++f) scene_.polygon_begin[f + 1] += scene_.polygon_begin[f];
  }

  // That of a facet that is in view may still change when it is clipped.
  [[nodiscard]] Status status_of(FacetId f) const {
    const Facing facing = scene_.facing[f.index()];
    if (facing == Facing::edge_on) return Status::edge_on;
    if (facing == Facing::back && scene_.sides_shown == Sides::front) return Status::culled;
    return summarize(mesh_.corners(f), projected_).none_inside ? Status::out_of_view : Status::in_view;
  }

  [[nodiscard]] std::uint32_t count_corners(FacetId f, std::vector<Clipped>& clipped) {
    if (summarize(mesh_.corners(f), projected_).all_inside) return static_cast<std::uint32_t>(mesh_.corners(f).size());
    clipped.push_back({f, clip(mesh_, scene_.camera, f)});
    if (clipped.back().polygon.empty()) scene_.status[f.index()] = Status::out_of_view;
    return static_cast<std::uint32_t>(clipped.back().polygon.size());
  }

  void add_corners() {
    scene_.polygon_corners.resize(scene_.polygon_begin.back());
    std::vector<std::vector<Place>> cut_places(clipped_.size());
    std::vector<std::uint8_t> in_view(mesh_.vertices.size(), 0);
    parallel_for_ranges(mesh_.facet_count(), [&](std::size_t range, std::size_t begin, std::size_t end) {
      auto clipped = clipped_[range].begin();
      for (std::size_t f = begin; f < end; ++f) {
        if (clipped != clipped_[range].end() && clipped->facet.index() == f) {
          add_clipped(*clipped++, cut_places[range], in_view);
        } else if (scene_.status[f] == Status::in_view) {
          add_whole(FacetId(f), in_view);
        }
      }
    });
    for (std::size_t v = 0; v < in_view.size(); ++v) {
      if (in_view[v] != 0) places_.push_back({projected_[v].image, static_cast<std::uint32_t>(v), true});
    }
    for (const auto& places : cut_places) places_.insert(places_.end(), places.begin(), places.end());
  }

  void add_whole(FacetId f, std::vector<std::uint8_t>& in_view) {
    const auto corners = mesh_.corners(f);
    const auto edges = mesh_.edges_of(f);
    const std::size_t first = scene_.polygon_begin[f.index()];
    for (std::size_t i = 0; i < corners.size(); ++i) set_vertex_corner(first + i, corners[i], edges[i], in_view);
  }

  void add_clipped(const Clipped& clipped, std::vector<Place>& cut_places, std::vector<std::uint8_t>& in_view) {
    std::size_t at = scene_.polygon_begin[clipped.facet.index()];
    for (const ExactCorner& corner : clipped.polygon) {
      if (corner.vertex.valid()) {
        set_vertex_corner(at, corner.vertex, corner.edge_after, in_view);
      } else {
        cut_places.push_back({round_to_grid(corner, scene_.grid_bits), static_cast<std::uint32_t>(at), false});
        set_cut_corner(at, corner);
      }
      ++at;
    }
  }

  // A corner gets its point once all are known.
  void set_vertex_corner(std::size_t at, VertexId v, MeshEdgeId edge_after, std::vector<std::uint8_t>& in_view) {
    scene_.polygon_corners[at] = {.point = {},
                                  .position = mesh_.position(v),
                                  .w = projected_[v.index()].w,
                                  .vertex = v,
                                  .edge_after = edge_after,
                                  .on_edge = {}};
    std::atomic_ref(in_view[v.index()]).store(1, std::memory_order_relaxed);
  }

  void set_cut_corner(std::size_t at, const ExactCorner& corner) {
    scene_.polygon_corners[at] = {.point = {},
                                  .position = corner.position(),
                                  .w = corner.weight(),
                                  .vertex = {},
                                  .edge_after = corner.edge_after,
                                  .on_edge = corner.on_edge};
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
    scene_.sides.resize(sides.size());
    std::vector<std::vector<SceneEdge>> edges(range_count(scene_.points.size()));
    parallel_for_ranges(scene_.points.size(), [&](std::size_t range, std::size_t first, std::size_t end) {
      for (std::size_t p = first; p < end; ++p) {
        const auto of_top = std::span(sides).subspan(begin[p], begin[p + 1] - begin[p]);
        sort_by_bottom(of_top);
        add_sides(of_top, begin[p], edges[range]);
      }
    });
    for (const auto& part : edges) scene_.edges.insert(scene_.edges.end(), part.begin(), part.end());
    scene_.edges.push_back({PointId{}, PointId{}, static_cast<std::uint32_t>(scene_.sides.size())});
  }

  // Those of one bottom stay in the order of facets. Few sides have one top, but for hubs.
  static void sort_by_bottom(std::span<PlacedSide> sides) {
    constexpr std::size_t few = 16;
    if (sides.size() > few) std::ranges::stable_sort(sides, {}, &PlacedSide::bottom);
    for (std::size_t i = 1; i < sides.size(); ++i) {
      for (std::size_t k = i; k > 0 && sides[k].bottom < sides[k - 1].bottom; --k) std::swap(sides[k], sides[k - 1]);
    }
  }

  // first: the number of the first of these sides.
  void add_sides(std::span<const PlacedSide> sides, std::size_t first, std::vector<SceneEdge>& edges) {
    for (std::size_t i = 0; i < sides.size(); ++i) {
      if (i == 0 || sides[i - 1].bottom != sides[i].bottom)
        edges.push_back({sides[i].top, sides[i].bottom, static_cast<std::uint32_t>(first + i)});
      scene_.sides[first + i] = sides[i].side;
    }
  }

  const Mesh& mesh_;
  std::vector<ProjectedVertex> projected_;
  std::vector<PointId> point_of_vertex_;       // invalid where no facet in view has the vertex
  std::vector<std::vector<Clipped>> clipped_;  // per range of facets, by facet
  std::vector<Place> places_;
  ProjectedScene scene_;
};

}  // namespace

ProjectedScene project(const Mesh& mesh, const Camera& camera, Sides sides, const Precision& precision) {
  return SceneBuilder(mesh, camera, sides, precision).build();
}

}  // namespace sightline
