#include "geometry/projection/projected_scene.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <atomic>
#include <numeric>

#include "geometry/mesh/facet_plane.h"
#include "geometry/numbers/exact_position.h"
#include "geometry/numbers/parallel.h"
#include "geometry/projection/clipping.h"
#include "geometry/projection/scene_edges.h"
#include "geometry/projection/seen_orientation.h"
#include "geometry/projection/unfiltered.h"
#include "geometry/projection/unrounded_points.h"
#include "geometry/projection/vertex_projection.h"

namespace sightline::inline geometry {
namespace {

// places: of the vertices in the view volume, where nothing is to be rounded.
std::vector<ProjectedVertex> project_vertices(const CutMesh& mesh, const Camera& camera, const Precision& precision,
                                              std::vector<CertifiedPlace>& places) {
  const bool is_unrounded = precision.arithmetic == Arithmetic::unrounded;
  if (is_unrounded) places.resize(mesh.vertices.size());
  std::vector<ProjectedVertex> projected(mesh.vertices.size());
  std::vector<std::uint8_t> used(mesh.vertices.size(), 0);
  parallel_for_each(mesh.facets.corners.size(), [&](std::size_t corner) {
    std::atomic_ref(used[mesh.facets.corners[corner].index()]).store(1, std::memory_order_relaxed);
  });
  parallel_for_each(used.size(), [&](std::size_t v) {
    if (used[v] == 0) return;
    if (is_unrounded) {
      const UnroundedVertex vertex = project_unrounded(mesh, VertexId(v), camera, precision.grid_bits);
      projected[v] = vertex.projected;
      places[v] = vertex.place;
      return;
    }
    projected[v] = project_vertex(mesh, VertexId(v), camera, precision.grid_bits);
    if (!is_exact(precision.arithmetic) && projected[v].strictly_outside == 0) {
      projected[v].image = unfiltered::image_point(precision, mesh.vertices[v], camera);
    }
  });
  return projected;
}

// A facet that is edge-on is edge-on in any arithmetic: clipping needs that.
FacetFacing facing_of(const CutMesh& mesh, const Camera& camera, FacetId facet, Arithmetic arithmetic) {
  const auto [a, b, c] = plane_corners(mesh, facet);
  Sign side = seen_orientation(camera, mesh.position(a), mesh.position(b), mesh.position(c));
  if (!is_exact(arithmetic) && side != 0) {
    side = unfiltered::orient3d(arithmetic, mesh.position(a), mesh.position(b), mesh.position(c), camera.eye);
  }
  return side > 0 ? FacetFacing::front : (side < 0 ? FacetFacing::back : FacetFacing::edge_on);
}

// Returns whether every ray through the facet meets the plane that is its own in the order of depth, before the eye.
bool has_depths(const CutMesh& mesh, const Camera& camera, FacetId facet) {
  const auto [a, b, c] = depth_plane_corners(mesh, facet);
  if (seen_orientation(camera, mesh.position(a), mesh.position(b), mesh.position(c)) == 0) return false;
  if (camera.projection == Projection::orthographic) return true;
  const ExactPlane plane = plane_through(exact_position(mesh, a), exact_position(mesh, b), exact_position(mesh, c));
  const ExactPosition eye = exact_position(camera.origin);
  const BigInteger eye_height = plane.height(eye);
  return std::ranges::all_of(mesh.uncut_corners(mesh.uncut_facet(facet)), [&](VertexId v) {
    const ExactPosition corner = exact_position(mesh, v);
    return sign_of(BigInteger(eye_height * corner.w - plane.height(corner) * eye.w)) == sign_of(eye_height);
  });
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

// A place is a point of the image before points are numbered, with whose it is: a vertex's, or a corner's that clipping
// made.
struct Place {
  ImagePoint image;
  std::uint32_t owner = 0;
  bool is_vertex = false;
};

class SceneBuilder {
 public:
  SceneBuilder(std::shared_ptr<const CutMesh> mesh, const Camera& camera, Sides sides, const Precision& precision)
      : mesh_(*mesh),
        projected_(project_vertices(*mesh, camera, precision, unrounded_)),
        point_of_vertex_(mesh->vertices.size()) {
    scene_.surface = std::move(mesh);
    scene_.camera = camera;
    scene_.sides_shown = sides;
    scene_.arithmetic = precision.arithmetic;
    scene_.grid_bits = precision.grid_bits;
  }

  // What is no longer asked for makes room for what comes next.
  ProjectedScene build() {
    find_statuses();
    add_corners();
    if (scene_.is_unrounded()) {
      number_unrounded_points(scene_, unrounded_);
      unrounded_ = {};
    } else {
      number_points();
    }
    places_ = {};
    collect_edges(scene_);
    return std::move(scene_);
  }

 private:
  // This is a corner of a facet that was clipped; where it has no vertex, it comes with its point and what it is.
  struct Corner {
    VertexId vertex;
    MeshEdgeId edge_after;
    ImagePoint image;
    MadeCorner made;
  };

  // Facets are clipped by ranges: each is worked on by one thread.
  struct Clipped {
    FacetId facet;
    std::vector<Corner> polygon;
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
        if (scene_.status[f] == FacetStatus::in_view)
          scene_.polygon_begin[f + 1] = count_corners(FacetId(f), clipped_[range]);
      }
    });
    for (std::size_t f = 0; f < mesh_.facet_count(); ++f) scene_.polygon_begin[f + 1] += scene_.polygon_begin[f];
  }

  // The status of a facet that is in view may still change when it is clipped.
  [[nodiscard]] FacetStatus status_of(FacetId f) const {
    const FacetFacing facing = scene_.facing[f.index()];
    if (facing == FacetFacing::edge_on) return FacetStatus::edge_on;
    if (mesh_.is_snapped(mesh_.uncut_facet(f)) && !has_depths(mesh_, scene_.camera, f)) return FacetStatus::edge_on;
    if (facing == FacetFacing::back && scene_.sides_shown == Sides::front) return FacetStatus::culled;
    const auto& outside = mesh_.cuts.outside_frame;
    if (!outside.empty() && outside[f.index()] != 0) return FacetStatus::out_of_view;
    return summarize(mesh_.corners(f), projected_).none_inside ? FacetStatus::out_of_view : FacetStatus::in_view;
  }

  [[nodiscard]] std::uint32_t count_corners(FacetId f, std::vector<Clipped>& clipped) {
    if (summarize(mesh_.corners(f), projected_).all_inside) return static_cast<std::uint32_t>(mesh_.corners(f).size());
    clipped.push_back({f, {}});
    for (const ExactCorner& corner : clip(mesh_, scene_.camera, f))
      clipped.back().polygon.push_back(rounded(corner, f));
    if (clipped.back().polygon.empty()) scene_.status[f.index()] = FacetStatus::out_of_view;
    return static_cast<std::uint32_t>(clipped.back().polygon.size());
  }

  [[nodiscard]] Corner rounded(const ExactCorner& corner, FacetId f) const {
    if (corner.vertex.valid()) return {corner.vertex, corner.edge_after, {}, {}};
    return {{},
            corner.edge_after,
            round_to_grid(corner, scene_.grid_bits),
            {corner.position(), corner.weight(), corner.on_edge, f, 0}};
  }

  void add_corners() {
    scene_.polygon_corners.resize(scene_.polygon_begin.back());
    const std::vector<std::size_t> first_made = number_made_corners();
    places_.resize(scene_.made_corners.size());
    std::vector<std::uint8_t> in_view(mesh_.vertices.size(), 0);
    parallel_for_ranges(mesh_.facet_count(), [&](std::size_t range, std::size_t begin, std::size_t end) {
      auto clipped = clipped_[range].begin();
      std::size_t made = first_made[range];
      for (std::size_t f = begin; f < end; ++f) {
        if (clipped != clipped_[range].end() && clipped->facet.index() == f) {
          add_clipped(*clipped++, made, in_view);
        } else if (scene_.status[f] == FacetStatus::in_view) {
          add_whole(FacetId(f), in_view);
        }
      }
    });
    scene_.vertex_weights.resize(in_view.size());
    places_.reserve(places_.size() + static_cast<std::size_t>(std::ranges::count(in_view, 1)));
    for (std::size_t v = 0; v < in_view.size(); ++v) {
      scene_.vertex_weights[v] = projected_[v].w;
      if (in_view[v] != 0) places_.push_back({projected_[v].image, static_cast<std::uint32_t>(v), true});
    }
    projected_ = {};
  }

  // Returns, per range of facets, the number of the first corner that clipping made there.
  std::vector<std::size_t> number_made_corners() {
    std::vector<std::size_t> first_made;
    std::size_t made = 0;
    for (const auto& clipped_of_range : clipped_) {
      first_made.push_back(made);
      for (const Clipped& clipped : clipped_of_range) {
        made += static_cast<std::size_t>(
            std::ranges::count_if(clipped.polygon, [](const Corner& corner) { return !corner.vertex.valid(); }));
      }
    }
    scene_.made_corners.resize(made);
    return first_made;
  }

  void add_whole(FacetId f, std::vector<std::uint8_t>& in_view) {
    const auto corners = mesh_.corners(f);
    const auto edges = mesh_.edges_of(f);
    const std::size_t first = scene_.polygon_begin[f.index()];
    for (std::size_t i = 0; i < corners.size(); ++i) set_vertex_corner(first + i, corners[i], edges[i], in_view);
  }

  void add_clipped(const Clipped& clipped, std::size_t& made, std::vector<std::uint8_t>& in_view) {
    std::size_t at = scene_.polygon_begin[clipped.facet.index()];
    for (const Corner& corner : clipped.polygon) {
      if (corner.vertex.valid()) {
        set_vertex_corner(at, corner.vertex, corner.edge_after, in_view);
      } else {
        set_made_corner(at, MadeCornerId(made++), corner);
      }
      ++at;
    }
  }

  // A corner gets its point once all are known.
  void set_vertex_corner(std::size_t at, VertexId v, MeshEdgeId edge_after, std::vector<std::uint8_t>& in_view) {
    scene_.polygon_corners[at] = {.point = {}, .vertex = v, .made = {}, .edge_after = edge_after};
    std::atomic_ref(in_view[v.index()]).store(1, std::memory_order_relaxed);
  }

  void set_made_corner(std::size_t at, MadeCornerId made, const Corner& corner) {
    scene_.polygon_corners[at] = {.point = {}, .vertex = {}, .made = made, .edge_after = corner.edge_after};
    scene_.made_corners[made.index()] = corner.made;
    scene_.made_corners[made.index()].corner = static_cast<std::uint32_t>(at);
    places_[made.index()] = {corner.image, static_cast<std::uint32_t>(at), false};
  }

  // Places that fall on one grid point are one point from here on.
  void number_points() {
    tbb::parallel_sort(places_.begin(), places_.end(),
                       [](const Place& a, const Place& b) { return sweeps_before(a.image, b.image); });
    const std::vector<std::size_t> first_point = count_points();
    scene_.points.resize(first_point.back());
    parallel_for_ranges(places_.size(), [&](std::size_t range, std::size_t begin, std::size_t end) {
      std::size_t points = first_point[range];
      for (std::size_t i = begin; i < end; ++i) {
        if (is_new(i)) scene_.points[points++] = places_[i].image;
        (places_[i].is_vertex ? point_of_vertex_[places_[i].owner] : scene_.polygon_corners[places_[i].owner].point) =
            PointId(points - 1);
      }
    });
    parallel_for_each(scene_.polygon_corners.size(), [this](std::size_t i) {
      ClippedCorner& corner = scene_.polygon_corners[i];
      if (corner.vertex.valid()) corner.point = point_of_vertex_[corner.vertex.index()];
    });
  }

  [[nodiscard]] bool is_new(std::size_t place) const {
    return place == 0 || places_[place - 1].image != places_[place].image;
  }

  // Returns, per range of places and one more, how many points lie before it.
  [[nodiscard]] std::vector<std::size_t> count_points() const {
    std::vector<std::size_t> before(range_count(places_.size()) + 1, 0);
    parallel_for_ranges(places_.size(), [&](std::size_t range, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) before[range + 1] += is_new(i) ? 1 : 0;
    });
    std::partial_sum(before.begin(), before.end(), before.begin());
    return before;
  }

  const CutMesh& mesh_;
  std::vector<CertifiedPlace> unrounded_;  // per vertex, or empty
  std::vector<ProjectedVertex> projected_;
  std::vector<PointId> point_of_vertex_;       // invalid where no facet in view has the vertex
  std::vector<std::vector<Clipped>> clipped_;  // per range of facets, by facet
  std::vector<Place> places_;
  ProjectedScene scene_;
};

}  // namespace

ProjectedScene project(std::shared_ptr<const CutMesh> mesh, const Camera& camera, Sides sides,
                       const Precision& precision) {
  return SceneBuilder(std::move(mesh), camera, sides, precision).build();
}

ProjectedScene project(CutMesh mesh, const Camera& camera, Sides sides, const Precision& precision) {
  return project(std::make_shared<const CutMesh>(std::move(mesh)), camera, sides, precision);
}

}  // namespace sightline::inline geometry
