// Small scenes are cut along common lines, by hand; random scenes are in crossing_test.cpp.
#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "geometry/cutting/common_lines.h"
#include "oracle/judging/judge.h"
#include "oracle/judging/labelled_laws.h"
#include "tests/tools/analyzed.h"

namespace sightline::tests::common_lines_test {
namespace {

Mesh mesh_of(const std::vector<std::vector<Point3>>& polygons) {
  std::vector<Point3> vertices;
  PolygonList faces;
  for (const auto& polygon : polygons) {
    std::vector<VertexId> corners;
    for (const Point3& p : polygon) {
      const auto known = std::find(vertices.begin(), vertices.end(), p);
      corners.emplace_back(static_cast<std::size_t>(known - vertices.begin()));
      if (known == vertices.end()) vertices.push_back(p);
    }
    faces.push_back(corners);
  }
  return build_mesh(std::move(vertices), std::move(faces));
}

std::vector<Point3> upright(double x, double z) { return {{-x, -1, -z}, {x, -1, z}, {x, 1, z}, {-x, 1, -z}}; }

std::size_t pieces_of(const CutMesh& mesh, std::size_t whole) {
  return mesh.cuts.first_facet[whole + 1].index() - mesh.cuts.first_facet[whole].index();
}

void check_valid(const CutMesh& mesh) {
  const auto messages = validate(mesh);
  CHECK_MESSAGE(messages.empty(), lattice::joined(messages));
}

Camera from_above(double height = 4) {
  return orthographic_camera("above", {{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 1, {}, {}}, height);
}

// Areas are in window units.
std::vector<double> visible_areas(const View& view) {
  const CutMesh& mesh = view.scene.mesh();
  std::vector<double> areas(mesh.face_count());
  for (const VisiblePolygon& polygon : view.polygons.polygons) areas[polygon.face.index()] += polygon.area;
  return areas;
}

}  // namespace

TEST_CASE("a mesh whose facets do not cross stays as it is") {
  const Mesh mesh = mesh_of({upright(1, 0), {{-1, -1, 1}, {1, -1, 1}, {0, 1, 1}}});
  const CutMesh cut = lattice::cut(mesh);
  CHECK_FALSE(cut.is_cut());
  CHECK(cut.facets.corners == mesh.facets.corners);
}

TEST_CASE("two squares through one axis are halved, and show a half each") {
  const CutMesh mesh = lattice::cut(mesh_of({upright(1, 1), upright(1, -1)}));
  check_valid(mesh);
  CHECK(pieces_of(mesh, 0) == 2);
  CHECK(pieces_of(mesh, 1) == 2);
  CHECK(mesh.cuts.points.size() == 2);
  const View view = analyzed(mesh, from_above());
  CHECK(visible_areas(view) == std::vector<double>{0.5, 0.5});
  CHECK(lattice::joined(lattice::complaints_of_stages(view)) == "");
}

TEST_CASE("four squares through one axis: the common line is one line, whoever cut whom") {
  const CutMesh mesh = lattice::cut(mesh_of({upright(2, 1), upright(2, -1), upright(1, 2), upright(1, -2)}));
  check_valid(mesh);
  for (std::size_t whole = 0; whole < 4; ++whole) CHECK(pieces_of(mesh, whole) == 2);
  CHECK(mesh.cuts.points.size() == 2);
  CHECK(std::count_if(mesh.cuts.input_edge.begin(), mesh.cuts.input_edge.end(),
                      [](const auto& ends) { return !ends[0].valid(); }) == 1);
}

TEST_CASE("three squares at right angles make four pieces each, and meet in one point") {
  const CutMesh mesh = lattice::cut(mesh_of({{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}},
                                             {{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}},
                                             {{0, -1, -1}, {0, 1, -1}, {0, 1, 1}, {0, -1, 1}}}));
  check_valid(mesh);
  for (std::size_t whole = 0; whole < 3; ++whole) CHECK(pieces_of(mesh, whole) == 4);
  CHECK(mesh.cuts.points.size() == 7);
}

TEST_CASE("a chord that ends inside a facet is cut on to its border, and to the next cut only") {
  // Two blades go through one floor, neither reaching across it.
  const CutMesh mesh = lattice::cut(mesh_of({{{-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0}},
                                             {{-2, -1, -1}, {-2, 1, -1}, {-2, 1, 1}, {-2, -1, 1}},
                                             {{1, -2, -1}, {3, -2, -1}, {3, -2, 1}, {1, -2, 1}}}));
  check_valid(mesh);
  CHECK(pieces_of(mesh, 0) == 3);
  CHECK(pieces_of(mesh, 1) == 2);
  CHECK(pieces_of(mesh, 2) == 2);
}

TEST_CASE("what cuts an edge cuts it for the neighbour that nothing passes through") {
  // A roof has two facets; a blade passes through the one, over the edge that it shares with the other.
  const Mesh whole = mesh_of({{{-2, 0, 0}, {2, 0, 0}, {2, 2, 0}, {-2, 2, 0}},
                              {{2, 0, 0}, {-2, 0, 0}, {-2, -2, -1}, {2, -2, -1}},
                              {{0.5, 0, -1}, {0.5, 1, -1}, {0.5, 1, 1}, {0.5, 0, 1}}});
  const CutMesh mesh = lattice::cut(whole);
  check_valid(mesh);
  CHECK(pieces_of(mesh, 0) == 2);
  CHECK(pieces_of(mesh, 1) == 1);
  CHECK(mesh.corners(mesh.cuts.first_facet[1]).size() == 5);
  const View view = analyzed(mesh, from_above(8));
  CHECK(lattice::joined(lattice::complaints_of_stages(view)) == "");
  CHECK(lattice::joined(lattice::areas_kept(whole, view.labelled)) == "");
}

TEST_CASE("a point that no double holds is rounded once, and is one point for all facets through it") {
  const CutMesh mesh =
      lattice::cut(mesh_of({{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}}, {{1, 0.5, -1}, {1, 0.5, 2}, {0, 3, 2}}}));
  check_valid(mesh);
  REQUIRE(mesh.is_cut());
  bool inexact = false;
  for (const ExactPosition& p : mesh.cuts.points) inexact = inexact || exact_position(p.rounded()) != p;
  CHECK(inexact);
}

TEST_CASE("faces that nothing shows keep no line of the cut") {
  // Two squares cross below a third one that hides both.
  const Mesh whole = mesh_of({upright(1, 1), upright(1, -1), {{-2, -2, 5}, {2, -2, 5}, {2, 2, 5}, {-2, 2, 5}}});
  const CutMesh mesh = lattice::cut(whole);
  const View view = analyzed(mesh, from_above());
  CHECK(lattice::joined(lattice::complaints_of_stages(view)) == "");
  // A square has four corners and, at most, two points where the cut ends: four triangles.
  CHECK(std::count_if(view.labelled.triangles.begin(), view.labelled.triangles.end(),
                      [](const LabelledTriangle& t) { return t.face == FaceId(0); }) == 4);
}

TEST_CASE("the cut does not depend on the order of faces") {
  constexpr unsigned seed = 3;
  INFO("seed ", seed);
  std::mt19937 random(seed);
  const auto coordinate = [&] { return static_cast<double>(static_cast<int>(random() % 15) - 7); };
  std::size_t crossing = 0;
  for (int scene = 0; scene < 40; ++scene) {
    CAPTURE(scene);
    std::vector<std::vector<Point3>> polygons(8);
    for (auto& polygon : polygons) {
      for (int i = 0; i < 3; ++i) {
        const double x = coordinate();
        const double y = coordinate();
        polygon.push_back({x, y, coordinate()});
      }
    }
    const CutMesh mesh = lattice::cut(mesh_of(polygons));
    std::reverse(polygons.begin(), polygons.end());
    const CutMesh reversed = lattice::cut(mesh_of(polygons));
    crossing += mesh.cuts.crossing.size();
    const auto sorted_points = [](const CutMesh& m) {
      std::vector<ExactPosition> points = m.cuts.points;
      std::ranges::sort(points, [](const auto& a, const auto& b) { return lexicographic_order(a, b) < 0; });
      return points;
    };
    CHECK(sorted_points(mesh) == sorted_points(reversed));
    CHECK(mesh.facet_count() == reversed.facet_count());
  }
  CHECK(crossing > 100);
}

}  // namespace sightline::tests::common_lines_test
