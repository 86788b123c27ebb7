#include <cstdio>

#include "oracle/scenes/random_scenes.h"

namespace sightline::lattice {
namespace {

std::string numbers(const Vector3& v) {
  char text[96];
  std::snprintf(text, sizeof text, "%.17g %.17g %.17g", v.x(), v.y(), v.z());
  return text;
}

}  // namespace

Mesh mesh_of(const RandomScene& scene) {
  PolygonList faces;
  for (const auto& corners : scene.faces) {
    std::vector<VertexId> ids;
    for (const std::uint32_t c : corners) ids.emplace_back(c);
    faces.push_back(ids);
  }
  return build_mesh(scene.vertices, std::move(faces));
}

std::string to_text(const RandomScene& scene) {
  const Camera& camera = scene.camera;
  std::string text =
      "# seed " + std::to_string(scene.seed) + (scene.sides == Sides::both ? ", both sides" : ", front sides");
  text += camera.projection == Projection::perspective ? ", perspective" : ", orthographic";
  text += "\n# right " + numbers(camera.right) + "  up " + numbers(camera.up) + "  forward " + numbers(camera.forward) +
          "  origin " + numbers(camera.origin) + "\n";
  for (const Point3& v : scene.vertices) text += "v " + numbers(v) + "\n";
  for (const auto& corners : scene.faces) {
    text += "f";
    for (const std::uint32_t c : corners) text += " " + std::to_string(c + 1);
    text += "\n";
  }
  return text;
}

}  // namespace sightline::lattice
