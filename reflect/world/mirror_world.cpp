#include "reflect/world/mirror_world.h"

#include "geometry/mesh/vertex_normals.h"
#include "reflect/world/wholes.h"

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

MirrorWorld make_mirror_world(const Mesh& surface, std::vector<Panel> panels, const ReflectionOptions& options,
                              const std::vector<Vector3>& given_normals) {
  MirrorWorld world{&surface, std::move(panels), options, {}, {}, {}, {}, 1, {}};
  if (world.panels.empty()) return world;
  world.obstacles = Obstacles(surface);
  world.scale = unit_scale(surface.vertices);
  if (options.needs_vertex_normals()) world.normals = vertex_normals(surface, given_normals);
  for (const Panel& panel : world.panels) {
    const Mesh& mesh = world.panel_meshes.emplace_back(panel_mesh(panel));
    world.panel_planes.push_back(plane_through(plane_points(mesh, FacetId(0))));
    world.panel_boxes.push_back(box_of(mesh, mesh.faces[0]));
  }
  return world;
}

}  // namespace sightline::inline reflect
