// Vertices and facets are projected: tiers are held against each other, and the projected scene against its contract.
#include <doctest/doctest.h>

#include <random>

#include "geometry/projection/clipping.h"
#include "geometry/projection/projected_scene.h"
#include "geometry/projection/seen_orientation.h"
#include "geometry/projection/vertex_projection.h"
#include "tests/tools/analyzed.h"

namespace sightline::tests::projection_test {
namespace {

Camera test_camera(bool perspective) {
  const ViewPoint view{{3, 2, 5}, {0.1, 0.2, 0.3}, {0, 1, 0}, 1.5, {}, {}};
  Camera camera = perspective ? perspective_camera("p", view, 50) : orthographic_camera("o", view, 4);
  camera.near_distance = 1;
  camera.far_distance = 20;
  return camera;
}

Mesh triangle(const Point3& a, const Point3& b, const Point3& c) {
  PolygonList faces;
  faces.push_back(std::array{VertexId(0), VertexId(1), VertexId(2)});
  return build_mesh({a, b, c}, std::move(faces));
}

// The camera has x right, y up, and looks along -z from the origin; the window's border is at |x| = |z|.
Camera straight_camera() { return perspective_camera("straight", {{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 1, {}, {}}, 90); }

constexpr unsigned seed = 7;

}  // namespace

TEST_CASE("the filter of the projection agrees with the exact projection wherever it answers") {
  INFO("seed ", seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(-4, 4);
  for (const bool perspective : {true, false}) {
    const Camera camera = test_camera(perspective);
    int answered = 0;
    int in_view = 0;
    for (int i = 0; i < 2000; ++i) {
      const Point3 v{coordinate(random), coordinate(random), coordinate(random)};
      const auto fast = projection_tiers::filtered(v, camera, default_grid_bits);
      const ProjectedVertex exact = projection_tiers::exact(v, camera, default_grid_bits);
      CAPTURE(i);
      if (!fast) continue;
      ++answered;
      CHECK(fast->strictly_outside == exact.strictly_outside);
      CHECK(fast->on_or_outside == exact.on_or_outside);
      if (exact.strictly_outside != 0) continue;
      ++in_view;
      CHECK(fast->image == exact.image);
      CHECK(fast->w == doctest::Approx(exact.w).epsilon(1e-14));
    }
    CHECK(answered > 1900);
    CHECK(in_view > 100);
  }
}

TEST_CASE("a point between two grid points is rounded away from the centre, the same on both sides") {
  Camera camera;
  camera.projection = Projection::orthographic;
  camera.right = {1, 0, 0};
  camera.up = {0, 1, 0};
  camera.forward = {0, 0, -1};
  camera.eye = {{0, 0, 1}, 0};
  const double half = 0x1p-41;
  CHECK(project_vertex({half, -half, 0}, camera, 40).image == ImagePoint{1, -1});
  CHECK(project_vertex({3 * half, -3 * half, 0}, camera, 40).image == ImagePoint{2, -2});
  CHECK(project_vertex({std::nextafter(half, 0), std::nextafter(3 * half, 0), 0}, camera, 40).image ==
        ImagePoint{0, 1});
}

TEST_CASE("no near plane: a face through the eye's plane is clipped at the window only") {
  const Mesh mesh = triangle({-1, -1, -2}, {1, -1, -2}, {0, -1, 4});
  const ProjectedScene scene = project(mesh, straight_camera(), Sides::both);
  CHECK(validate(scene).empty());
  REQUIRE(scene.status[0] == FacetStatus::in_view);
  const std::int64_t edge = std::int64_t{1} << 40;
  for (const ClippedCorner& corner : scene.polygon(FacetId(0))) {
    CHECK(scene.point(corner.point).y >= -edge);
    CHECK(scene.point(corner.point).y < 0);
    CHECK(position_of(scene, corner).y() == -1);
  }
}

TEST_CASE("what touches the view volume's border from outside is out of view") {
  const Camera camera = straight_camera();
  CHECK(project(triangle({1, 0, -1}, {2, 0, -1}, {2, 1, -1}), camera, Sides::both).status[0] ==
        FacetStatus::out_of_view);
  CHECK(project(triangle({0, 0, 1}, {1, 0, 1}, {0, 1, 2}), camera, Sides::both).status[0] == FacetStatus::out_of_view);
  CHECK(project(triangle({0, 0, -1}, {2, 0, -1}, {0, 2, -1}), camera, Sides::both).status[0] == FacetStatus::in_view);
}

TEST_CASE("a face in a plane through the eye is edge-on, and so is one with a corner in the eye") {
  const Camera camera = straight_camera();
  CHECK(project(triangle({0, 0, -1}, {1, 0, -2}, {-1, 0, -3}), camera, Sides::both).status[0] == FacetStatus::edge_on);
  CHECK(project(triangle({0, 0, 0}, {1, 0, -2}, {-1, 0.5, -3}), camera, Sides::both).status[0] == FacetStatus::edge_on);
}

TEST_CASE("one triangle that covers the window is clipped to the window") {
  const ProjectedScene scene =
      project(triangle({-50, -50, -1}, {50, -50, -1}, {0, 100, -1}), straight_camera(), Sides::both);
  CHECK(validate(scene).empty());
  CHECK(scene.points.size() == 4);
  CHECK(scene.edge_count() == 4);
}

TEST_CASE("facing is exact: an eye one last bit before a face's plane sees its front") {
  const Mesh mesh = triangle({0, 0, -1}, {1, 0, -1}, {0, 1, -1});
  const auto facing_from = [&](double z) {
    Camera camera = straight_camera();
    camera.origin = {0, 0, z};
    camera.eye = {camera.origin, 1};
    return project(mesh, camera, Sides::both).facing[0];
  };
  CHECK(facing_from(std::nextafter(-1.0, 0.0)) == FacetFacing::front);
  CHECK(facing_from(-1.0) == FacetFacing::edge_on);
  CHECK(facing_from(std::nextafter(-1.0, -2.0)) == FacetFacing::back);
}

TEST_CASE("neighbours are cut at the same point: a clipped mesh edge has one image point and one position") {
  PolygonList faces;
  faces.push_back(std::array{VertexId(0), VertexId(1), VertexId(2)});
  faces.push_back(std::array{VertexId(1), VertexId(0), VertexId(3)});
  const Mesh mesh = build_mesh({{0.1, 0.2, -1}, {7, 0.3, -3}, {0.5, 0.9, -2}, {0.4, -0.7, -1.3}}, std::move(faces));
  const ProjectedScene scene = project(mesh, straight_camera(), Sides::both);
  std::vector<const ClippedCorner*> cuts;
  for (const ClippedCorner& corner : scene.polygon_corners) {
    const MeshEdgeId cut = scene.cut_edge(corner);
    if (cut.valid() && mesh.edges[cut.index()] == mesh.edges[mesh.facet_edges[0].index()]) {
      cuts.push_back(&corner);
    }
  }
  REQUIRE(cuts.size() == 2);
  CHECK(cuts[0]->point == cuts[1]->point);
  CHECK(scene.made(*cuts[0]).position == scene.made(*cuts[1]).position);
}

TEST_CASE("seen orientation: an orthographic camera's rows decide, in certified numbers as in integers") {
  constexpr unsigned seed = 20261130;
  INFO("seed ", seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-2, 2);
  std::size_t undecided = 0;
  std::size_t against_the_eye = 0;
  for (int round = 0; round < 5000; ++round) {
    ViewPoint view;
    view.eye = {place(random), place(random), 3};
    const Camera camera = orthographic_camera("o", view, 4);
    const Point3 a{place(random), place(random), place(random)};
    const Vector3 towards_eye = round % 2 == 0 ? camera.eye.xyz : Vector3(place(random), place(random), 1);
    const Point3 b = a + towards_eye;  // nearly edge-on, every other time
    const Point3 c{place(random), place(random), place(random)};
    const Sign exact = seen_orientation_tiers::exact(camera, a, b, c);
    const auto filtered = seen_orientation_tiers::filtered(camera, a, b, c);
    if (filtered) CHECK(*filtered == exact);
    undecided += filtered ? 0 : 1;
    CHECK(seen_orientation(camera, a, b, c) == exact);
    CHECK(seen_orientation(camera, b, c, a) == exact);
    CHECK(seen_orientation(camera, b, a, c) == -exact);
    against_the_eye += exact != orient3d(a, b, c, camera.eye) ? 1 : 0;
  }
  // What was to be made hard was.
  CHECK(undecided > 100);
  CHECK(against_the_eye > 100);
}

}  // namespace sightline::tests::projection_test
