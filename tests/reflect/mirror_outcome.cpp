#include "tests/reflect/mirror_outcome.h"

#include <doctest/doctest.h>

#include <cmath>

#include "geometry/mesh/area.h"
#include "tests/tools/analyzed.h"

namespace sightline::tests {
namespace {

double area_on_surface(const LabelledMesh& labelled, std::size_t panel) {
  double sum = 0;
  for (const LabelledTriangle& t : labelled.triangles) {
    if ((t.reflecting >> panel & 1U) == 0) continue;
    CHECK(t.seen);
    sum += area(labelled, t);
  }
  return sum;
}

// What is not rounded shows the same, but for what rounding moves: the image of the panel is the same, on the grid, and the
// places of the mirror's corners were moved by up to half a spacing.
void check_without_rounding(const MirrorWorld& world, const Camera& camera, const MirrorOutcome& outcome) {
  if (world.options.mode == ReflectionMode::triangles) return;
  const View view = analyzed(world, camera, {Arithmetic::unrounded});
  CHECK(lattice::joined(lattice::complaints_of_stages(view)) == "");
  for (std::size_t p = 0; p < outcome.areas.size(); ++p) {
    const PanelReflection& panel = view.reflections.panels[p];
    CHECK(validate(panel.polygons, view.scene, panel.segments) == std::vector<std::string>{});
    const double area = area_on_surface(view.labelled, p);
    CHECK(std::fabs(area - outcome.areas[p]) <= 1e-7 * (1 + outcome.areas[p]));
  }
}

}  // namespace

Rational exact_image_area(const View& view, std::size_t panel) {
  const PanelReflection& reflection = view.reflections.panels[panel];
  Rational sum = 0;
  for (std::size_t i = 0; i < reflection.polygons.polygons.size(); ++i)
    sum += exact_area(view.scene, reflection.segments, reflection.polygons, i);
  return sum / Rational(BigInteger(1) << static_cast<unsigned>(2 * view.scene.grid_bits));
}

double image_area(const View& view, std::size_t panel) {
  double sum = 0;
  for (const VisiblePolygon& polygon : view.reflections.panels[panel].polygons.polygons) sum += polygon.area;
  return sum;
}

Camera looking_down(const Point3& eye) {
  Camera camera;
  camera.name = "down";
  camera.right = {1, 0, 0};
  camera.up = {0, 1, 0};
  camera.forward = {0, 0, -1};
  camera.origin = eye;
  camera.eye = {eye, 1};
  return camera;
}

Corners rectangle(double left, double right, double front, double back, double z) {
  return {{left, front, z}, {right, front, z}, {right, back, z}, {left, back, z}};
}

double area(const LabelledMesh& labelled, const LabelledTriangle& triangle) {
  const auto corner = [&](std::size_t i) { return labelled.vertices[triangle.corners[i].index()]; };
  return triangle_area(corner(0), corner(1), corner(2));
}

MirrorOutcome reflected(const AnyMesh& mesh, const std::vector<Panel>& panels, const Camera& camera,
                        const ReflectionOptions& options, const std::vector<Vector3>& normals) {
  const MirrorWorld world = mirror_world(mesh, panels, options, normals);
  MirrorOutcome outcome{analyzed(world, camera), {}};
  const View& view = outcome.view;
  CHECK(lattice::joined(lattice::complaints_of_stages(view)) == "");
  REQUIRE(view.reflections.panels.size() == panels.size());
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const PanelReflection& panel = view.reflections.panels[p];
    CHECK(validate(panel.polygons, view.scene, panel.segments) == std::vector<std::string>{});
    outcome.areas.push_back(area_on_surface(view.labelled, p));
  }
  check_without_rounding(world, camera, outcome);
  return outcome;
}

}  // namespace sightline::tests
