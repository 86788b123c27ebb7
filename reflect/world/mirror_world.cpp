#include "reflect/world/mirror_world.h"

#include <algorithm>

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

Obstacles::Obstacles(const CutMesh& mesh) {
  std::vector<Box> boxes;
  for (std::size_t w = 0; w < mesh.uncut_facet_count(); ++w)
    boxes.push_back(box_of(mesh, mesh.uncut_corners(UncutFacetId(w))));
  hierarchy_ = build_hierarchy(boxes);
}

std::vector<UncutFacetId> Obstacles::in(const std::function<bool(const Box&)>& may_touch) const {
  std::vector<UncutFacetId> found;
  for_each_touched_item(hierarchy_, may_touch, [&](const BoxHierarchy::Item& item) { found.emplace_back(item.index); });
  return found;
}

namespace {

// Of the panel that was added last.
std::vector<std::size_t> earlier_ones_in_plane(const MirrorWorld& world) {
  const ExactPlane& plane = world.panel_planes.back();
  std::vector<std::size_t> result;
  for (std::size_t p = 0; p + 1 < world.panel_planes.size(); ++p) {
    const auto is_on_plane = [&](const Point3& corner) { return plane.side(exact_position(corner)) == 0; };
    if (std::ranges::all_of(world.panels[p].corners, is_on_plane)) result.push_back(p);
  }
  return result;
}

}  // namespace

MirrorWorld make_mirror_world(std::shared_ptr<const CutMesh> surface, std::vector<Panel> panels,
                              const ReflectionOptions& options, const std::vector<Vector3>& given_normals) {
  MirrorWorld world{std::move(surface), std::move(panels), options, {}, {}, {}, {}, {}, 1, {}, {}};
  if (world.panels.empty()) return world;
  world.obstacles = Obstacles(*world.surface);
  world.scale = unit_scale(world.surface->vertices);
  if (options.needs_vertex_normals())
    world.normals = vertex_normals(*world.surface, given_normals, options.normal_options());
  if (options.mode == ReflectionMode::smooth) world.closed = box_of_closed(*world.surface);
  for (const Panel& panel : world.panels) {
    const CutMesh& mesh = world.panel_meshes.emplace_back(uncrossed(panel_mesh(panel)));
    world.panel_planes.push_back(plane_through(plane_points(mesh, FacetId(0))));
    world.panel_boxes.push_back(box_of(mesh, mesh.faces[0]));
    world.panels_over.push_back(earlier_ones_in_plane(world));
  }
  return world;
}

}  // namespace sightline::inline reflect
