#include "reflect/world/mirror_world.h"

#include "geometry/mesh/facet_plane.h"
#include "geometry/mesh/vertex_normals.h"

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

MirrorWorld make_mirror_world(std::shared_ptr<const CutMesh> surface, std::vector<Panel> panels,
                              const ReflectionOptions& options, const std::vector<Vector3>& given_normals) {
  MirrorWorld world{std::move(surface), std::move(panels), options, {}, {}, {}, {}, 1, {}};
  if (world.panels.empty()) return world;
  world.obstacles = Obstacles(*world.surface);
  world.scale = unit_scale(world.surface->vertices);
  if (options.needs_vertex_normals()) world.normals = vertex_normals(*world.surface, given_normals);
  for (const Panel& panel : world.panels) {
    const CutMesh& mesh = world.panel_meshes.emplace_back(uncrossed(panel_mesh(panel)));
    world.panel_planes.push_back(plane_through(plane_points(mesh, FacetId(0))));
    world.panel_boxes.push_back(box_of(mesh, mesh.faces[0]));
  }
  return world;
}

CutPolygon whole_polygon(const CutMesh& mesh, WholeId whole) {
  CutPolygon polygon;
  for (const VertexId v : whole_corners(mesh, whole)) polygon.push_back({exact_position(mesh.position(v)), v, {}});
  return polygon;
}

std::array<Point3, 3> plane_points(const CutMesh& mesh, FacetId facet) {
  const auto [a, b, c] = plane_corners(mesh, facet);
  return {mesh.position(a), mesh.position(b), mesh.position(c)};
}

ExactPlane plane_through(const std::array<Point3, 3>& points) {
  return plane_through(exact_position(points[0]), exact_position(points[1]), exact_position(points[2]));
}

}  // namespace sightline::inline reflect
