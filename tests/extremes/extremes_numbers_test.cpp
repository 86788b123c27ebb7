// These extreme scenes have extreme numbers, or show one face or none.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "tests/extremes/checked_scene.h"

namespace sightline::tests::extremes_numbers_test {
using namespace extremes;

namespace {

Vector3 scaled(const Vector3& v, int exponent) {
  return {std::ldexp(v.x(), exponent), std::ldexp(v.y(), exponent), std::ldexp(v.z(), exponent)};
}

Mesh scaled(const Mesh& mesh, int exponent) {
  std::vector<Point3> vertices;
  for (const Point3& p : mesh.vertices) vertices.push_back(scaled(p, exponent));
  return build_mesh(std::move(vertices), mesh.faces);
}

// The result sees the scaled mesh as the camera sees the mesh.
Camera scaled(Camera camera, int exponent) {
  camera.origin = scaled(camera.origin, exponent);
  if (camera.projection == Projection::perspective) {
    camera.eye = {camera.origin, 1};
  } else {
    camera.right = scaled(camera.right, -exponent);
    camera.up = scaled(camera.up, -exponent);
  }
  return camera;
}

// Scaling by a power of two changes no bit of the image.
void check_scale(const CheckedScene& scene, int exponent) {
  const Mesh moderate = scaled(scene.mesh, -exponent);
  CHECK(std::any_of(moderate.vertices.begin(), moderate.vertices.end(), [](const Point3& p) { return p.x() == 7; }));
  for (const Sight& seen : scene.sights) {
    CAPTURE(seen.camera.name);
    const Sight reference = sight(moderate, scaled(seen.camera, -exponent), SidesPolicy::both);
    CHECK(seen.areas == reference.areas);
    CHECK(seen.view.scene.points == reference.view.scene.points);
    CHECK(total(seen.areas) > Rational(1, 2));
  }
}

}  // namespace

TEST_CASE("extreme scene far_from_origin") {
  const CheckedScene scene = checked("far_from_origin");
  CHECK(total(scene.from("parallel").areas) > 1);
}

TEST_CASE("extreme scene tiny: the same as at scale one") { check_scale(checked("tiny"), -500); }

TEST_CASE("extreme scene huge: the same as at scale one") { check_scale(checked("huge"), 498); }

TEST_CASE("extreme scene denormals: the same as at scale one") { check_scale(checked("denormals"), -1026); }

TEST_CASE("extreme scene smallest_denormals: the same as at scale one") {
  check_scale(checked("smallest_denormals", {.coplanar = false, .large = false, .coarse_doubles = true}), -1074);
}

TEST_CASE("extreme scene negative_zero: 0 and -0 are one place, and keep their signs") {
  const CheckedScene scene = checked("negative_zero");
  const auto& vertices = scene.mesh.vertices;
  CHECK(
      std::any_of(vertices.begin(), vertices.end(), [](const Point3& p) { return p.x() == 0 && std::signbit(p.x()); }));
  CHECK(scene.mesh.edges.size() == 12 + 4);
  std::vector<Point3> positive = vertices;
  for (Point3& p : positive) p = {p.x() + 0.0, p.y() + 0.0, p.z() + 0.0};
  const Mesh plain = build_mesh(std::move(positive), scene.mesh.faces);
  for (const Sight& seen : scene.sights) CHECK(seen.areas == sight(plain, seen.camera, SidesPolicy::both).areas);
  const Sight& above = scene.from("above");
  CHECK(is_exact(scene.mesh, above));
  CHECK(above.areas == std::vector<Rational>{0, 0, 0, 0, 0, Rational(1, 4), Rational(1, 4)});
}

TEST_CASE("extreme scene degenerate_faces: every face is skipped, with its reason") {
  const CheckedScene scene = checked("degenerate_faces");
  CHECK(scene.mesh.facet_count() == 0);
  for (std::size_t f = 0; f < scene.mesh.face_count(); ++f) {
    const auto& defects = scene.mesh.defects;
    CHECK(std::any_of(defects.begin(), defects.end(),
                      [f](const FaceDefect& d) { return d.face == FaceId(f) && is_skipped(d.defect); }));
  }
  CHECK(scene.from("above").view.labelled.triangles.empty());
}

TEST_CASE("extreme scene one_triangle: it fills the window") {
  const CheckedScene scene = checked("one_triangle");
  CHECK(is_exact(scene.mesh, scene.from("above")));
  CHECK(scene.from("above").areas == std::vector<Rational>{4, 0});
}

TEST_CASE("extreme scene nothing_in_view: no segment, no polygon, the surface is kept") {
  const CheckedScene scene = checked("nothing_in_view");
  for (const Sight& seen : scene.sights) {
    CHECK(seen.view.segments.segments.empty());
    CHECK(seen.view.polygons.polygons.empty());
    CHECK(seen.view.labelled.triangles.size() == scene.mesh.face_count());
  }
}

}  // namespace sightline::tests::extremes_numbers_test
