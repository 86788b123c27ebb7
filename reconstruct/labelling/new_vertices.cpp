#include "reconstruct/labelling/new_vertices.h"

#include "geometry/mesh/facet_plane.h"
#include "geometry/numbers/errors.h"
#include "reconstruct/labelling/lift.h"

namespace sightline::inline reconstruct {

void SurfaceVertices::begin(FacetId surface) {
  surface_ = surface;
  exact_lift_.begin(surface);
  known_.clear();
}

VertexId SurfaceVertices::vertex_at(PointId p, std::optional<Point3> position) {
  const auto [place, is_new] = known_.try_emplace(p);
  if (is_new) place->second = vertices_.add(position ? *position : lift(p));
  return place->second;
}

Point3 SurfaceVertices::lift(PointId p) {
  if (scene_.is_unrounded()) return exact_lift_(p);
  for (std::size_t f = surface_.index(); f < end_of_surface(mesh_, surface_).index(); ++f) {
    if (const auto lifted = lift_on_facet(scene_, points_, FacetId(f), p)) return *lifted;
  }
  throw InternalError("point " + std::to_string(p.value) + " is not on face " +
                      std::to_string(mesh_.facet_face[surface_.index()].value));
}

}  // namespace sightline::inline reconstruct
