// Panels are no part of what is seen: the labelled surface has the same visible areas with them and without.
#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "oracle/scenes/moved_scene.h"
#include "tests/reflect/mirror_outcome.h"

namespace sightline::tests::panels_unseen_test {
namespace {

std::vector<double> visible_areas(const Mesh& mesh, const Camera& camera, Sides sides,
                                  const std::vector<Panel>& panels) {
  const View view = Analyzer(mesh, {.sides = policy_of(sides)}).view(camera, panels);
  std::vector<double> areas(mesh.face_count(), 0);
  for (const LabelledTriangle& t : view.labelled.triangles)
    areas[t.face.index()] += t.seen ? area(view.labelled, t) : 0;
  return areas;
}

void check_unseen(const Mesh& mesh, const Camera& camera, Sides sides, const std::vector<Panel>& panels) {
  const std::vector<double> with = visible_areas(mesh, camera, sides, panels);
  const std::vector<double> without = visible_areas(mesh, camera, sides, {});
  for (std::size_t f = 0; f < with.size(); ++f) {
    CAPTURE(f);
    CHECK(with[f] == doctest::Approx(without[f]).epsilon(1e-9));
  }
}

// A square around the origin, far from the scene or in it.
Panel random_panel(std::mt19937_64& random, double size) {
  std::uniform_real_distribution<double> number(-1, 1);
  const Vector3 normal = Vector3(number(random), number(random), number(random)).normalized();
  const Vector3 right = unit(normal.unitOrthogonal());
  const Vector3 up = normal.cross(right);
  const Point3 centre = 2 * size * Vector3(number(random), number(random), number(random));
  const Vector3 r = size * right;
  const Vector3 u = size * up;
  return {"panel", {centre - r - u, centre + r - u, centre + r + u, centre - r + u}};
}

}  // namespace

// What face 0 reflects is a sliver below resolution, between the line along which the faces pass through each other and the view
// volume's border; it splits the border where no visible segment ends.
TEST_CASE("a reflecting sliver below resolution at the view volume's border") {
  ViewPoint from;
  from.eye = {3.0819391014581115, -4.8651124914219155, 1.9722607038027187};
  from.target = {1, 0, 0};
  from.near_distance = 1;
  const Mesh mesh = mesh_of({{{-2, -2, -2}, {-1, 1, -2}, {2, -2, 2}}, {{2, -2, 2}, {-2, 0, 1}, {1, 0, -2}}});
  check_unseen(mesh, orthographic_camera("c", from, 1), Sides::both,
               {{"panel",
                 {{-16.90296153556363, -6.155802568563576, 0.7665283089662889},
                  {-4.519298094992207, -1.3527409852581747, 15.718968886264383},
                  {8.251285271016439, 6.650685644730109, 2.5714458240972116},
                  {-4.132378169554986, 1.8476240614247066, -12.380994753200882}}}});
}

TEST_CASE("random scenes look the same, whatever panels there are") {
  std::mt19937_64 random(7);
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    CAPTURE(seed);
    const lattice::RandomScene scene = lattice::random_scene(seed);
    const Mesh mesh = lattice::moved(scene, seed % 2 == 0 ? lattice::Moved::turned : lattice::Moved::not_at_all);
    double size = 0;
    for (const Point3& p : mesh.vertices) size = std::max(size, largest_coordinate(p));
    check_unseen(mesh, scene.camera, scene.sides, {random_panel(random, size), random_panel(random, 4 * size)});
  }
}

}  // namespace sightline::tests::panels_unseen_test
