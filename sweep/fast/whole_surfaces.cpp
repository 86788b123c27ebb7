#include "sweep/fast/whole_surfaces.h"

#include <algorithm>

#include "geometry/mesh/facet_plane.h"
#include "geometry/numbers/parallel.h"

namespace sightline::inline sweep {

void keep_surfaces_whole(const ProjectedScene& scene, std::vector<std::uint8_t>& hidden) {
  const CutMesh& mesh = scene.mesh();
  parallel_for_each(hidden.size(), [&](std::size_t begin) {
    if (surface_of(mesh, FacetId(begin)) != FacetId(begin)) return;
    const std::size_t end = end_of_surface(mesh, FacetId(begin)).index();
    std::size_t seen = 0;
    for (std::size_t f = begin; f < end; ++f) seen += scene.status[f] == Status::in_view && hidden[f] == 0 ? 1 : 0;
    if (seen > 0) std::fill_n(hidden.begin() + static_cast<std::ptrdiff_t>(begin), end - begin, std::uint8_t{0});
  });
}

}  // namespace sightline::inline sweep
