#include "reflect/world/mirror_world.h"

#include <algorithm>

#include "geometry/mesh/facet_plane.h"
#include "reflect/world/closed_surface.h"
#include "reflect/world/uncut_facets.h"

namespace sightline::inline reflect {

const char* to_string(ReflectionMode mode) {
  switch (mode) {
    case ReflectionMode::exact:
      return "exact";
    case ReflectionMode::triangles:
      return "triangles";
    case ReflectionMode::smooth:
      return "smooth";
  }
  return "";
}

const char* to_string(MirrorNormals normals) { return normals == MirrorNormals::face ? "face" : "vertex"; }

namespace {

std::vector<std::size_t> earlier_ones_in_plane(const MirrorWorld& world, std::size_t panel) {
  const ExactPlane& plane = world.panel_planes[panel];
  std::vector<std::size_t> result;
  for (std::size_t p = 0; p < panel; ++p) {
    const auto is_on_plane = [&](const Point3& corner) { return plane.side(exact_position(corner)) == 0; };
    if (world.is_in_plane(panel, p) || std::ranges::all_of(world.panels[p].corners, is_on_plane)) result.push_back(p);
  }
  return result;
}

}  // namespace

MirrorWorld make_mirror_world(std::shared_ptr<const CutMesh> surface, std::vector<Panel> panels,
                              const ReflectionOptions& options, const std::vector<Vector3>& given_normals,
                              std::vector<std::uint8_t> mirror_faces) {
  MirrorWorld world{
      std::move(surface), std::move(panels), options, {}, {}, {}, {}, {}, {}, 1, {}, std::move(mirror_faces), {}};
  if (world.panels.empty()) return world;
  world.obstacles = Obstacles(*world.surface);
  world.scale = unit_scale(world.surface->vertices);
  if (options.needs_vertex_normals())
    world.normals = vertex_normals(*world.surface, given_normals, options.normal_options());
  if (options.mode == ReflectionMode::smooth) world.closed = box_of_closed(*world.surface);
  for (Panel& panel : world.panels) {
    const CutMesh& mesh = world.panel_meshes.emplace_back(uncrossed(panel_mesh(panel)));
    panel.corners = mesh.vertices;
    world.panel_planes.push_back(plane_through(panel_plane(mesh)));
    world.panel_boxes.push_back(box_of(mesh, mesh.faces[0]));
  }
  const double distance = options.coincidence * size_of(*world.surface);
  for (std::size_t p = 0; p < world.panels.size(); ++p) {
    world.flush.push_back(find_flush(*world.surface, world.obstacles, world.panel_meshes, p, distance));
    world.panels_over.push_back(earlier_ones_in_plane(world, p));
  }
  return world;
}

bool MirrorWorld::is_snapped(std::size_t panel, UncutFacetId facet) const {
  return options.snaps && std::ranges::binary_search(flush[panel].facets, facet, {}, &FlushFacet::facet);
}

bool MirrorWorld::is_snapped_surface(std::size_t panel, FacetId mirror) const {
  if (!options.snaps || flush[panel].facets.empty()) return false;
  for (FacetId f = mirror; f < end_of_surface(*surface, mirror); f = FacetId(f.index() + 1)) {
    if (is_snapped(panel, surface->uncut_facet(f))) return true;
  }
  return false;
}

bool MirrorWorld::is_snapped_to_mirror(FacetId mirror, UncutFacetId facet) const {
  return !surface->snapped_to.empty() && surface->plane_of(facet) == surface->plane_of(surface->uncut_facet(mirror));
}

bool MirrorWorld::is_in_plane(std::size_t panel, std::size_t other) const {
  if (options.snaps && std::ranges::binary_search(flush[panel].panels, other, {}, &FlushPanel::panel)) return true;
  const std::vector<Point3>& corners = panels[other].corners;
  return corners.size() == panels[panel].corners.size() &&
         std::is_permutation(corners.begin(), corners.end(), panels[panel].corners.begin());
}

}  // namespace sightline::inline reflect
