// Appel's visible lines are held against the exact sweep's visible segments, as sets of points of the image: all
// visible parts of Appel's, and all segments of the sweep but those along the window's border. Edges inside a planar
// face are in neither.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>

#include "geometry/cutting/interpenetration.h"
#include "oracle/judging/judge.h"
#include "oracle/lattice/lattice.h"
#include "oracle/scenes/crossing_scenes.h"
#include "peers/lines/appel.h"
#include "tests/peers/visible_line_sets.h"
#include "tests/tools/analyzed.h"
#include "tests/tools/polygon_mesh.h"
#include "tests/tools/random_surfaces.h"

namespace sightline::tests::peer_lines_test {
using namespace peers;

namespace {

struct Comparison {
  double only_appel = 0;  // lengths of what is seen by one of them only
  double only_exact = 0;
  std::size_t lines = 0;
  std::size_t hidden = 0;     // segments of lines
  std::size_t crossings = 0;  // ends of segments inside lines
  int least = 0;              // Q_v
};

Comparison compare(const AnyMesh& mesh, const Camera& camera, Sides sides) {
  const View view = analyzed(mesh, camera, sides);
  const FlatScene scene = flat_scene(view.scene);
  const VisibleLines exact = tests::visible_segments(view);
  const VisibleLines ours = std::get<VisibleLines>(appel().run(scene, 0).seen);
  Comparison result{tests::uncovered(ours, exact), tests::uncovered(exact, ours), ours.size(), 0, 0, 0};
  for (const LineSegment& segment : quantitative_invisibility(scene, scene_lines(scene)).segments) {
    result.least = std::min(result.least, segment.Q_v);
    result.hidden += segment.Q_v > 0 ? 1 : 0;
    result.crossings += segment.from > 0 ? 1 : 0;
  }
  return result;
}

// These count what many scenes had, so that they did not pass for want of anything hard.
struct Totals {
  std::size_t scenes = 0;
  std::size_t lines = 0;
  std::size_t hidden = 0;
  std::size_t crossings = 0;
};

void check_same(const AnyMesh& mesh, const Camera& camera, Sides sides, Totals& totals) {
  const Comparison result = compare(mesh, camera, sides);
  CHECK(result.only_appel == 0);
  CHECK(result.only_exact == 0);
  CHECK(result.least == 0);
  ++totals.scenes;
  totals.lines += result.lines;
  totals.hidden += result.hidden;
  totals.crossings += result.crossings;
}

// Appel's limit is reached where faces meet outside of shared vertices and edges, and do not pass through each other.
bool touches(const PolygonMesh& mesh) { return !find_contacts(mesh).touching.empty(); }

ViewPoint view_from(const Point3& eye, const Point3& target = {0, 0, 0}) {
  ViewPoint view;
  view.eye = eye;
  view.target = target;
  return view;
}

Camera camera_at(const Point3& eye) { return perspective_camera("front", view_from(eye), 40); }

void add_tetrahedron(std::vector<Corners>& faces, const std::array<Point3, 4>& p) {
  for (const auto& [a, b, c] : {std::array{0, 1, 2}, std::array{0, 3, 1}, std::array{0, 2, 3}, std::array{1, 3, 2}}) {
    const auto at = [&p](int i) { return p[static_cast<std::size_t>(i)]; };
    faces.push_back({at(a), at(b), at(c)});
  }
}

// There are tetrahedra and triangles anywhere, through each other and across the window's border.
CutMesh general_mesh(lattice::Dice& dice) {
  const auto point = [&dice]() -> Vector3 {
    const auto coordinate = [&dice] { return dice.between(-1'000'000, 1'000'000) / 3e5; };
    return Point3{coordinate(), coordinate(), coordinate()};
  };
  std::vector<Corners> faces;
  for (int i = 0; i < 3; ++i) add_tetrahedron(faces, {point(), point(), point(), point()});
  for (int i = 0; i < 3; ++i) faces.push_back({point(), point(), point()});
  return lattice::cut(tests::mesh_of(faces));
}

// Adds a sheet of cells x cells squares, each two triangles, with random heights.
void add_sheet(std::vector<Corners>& faces, lattice::Dice& dice, int cells, double height) {
  std::vector<std::vector<Point3>> rows;
  for (int row = 0; row <= cells; ++row) {
    rows.emplace_back();
    for (int column = 0; column <= cells; ++column) {
      const auto jitter = [&dice] { return dice.between(-1000, 1000) * 1e-4; };
      rows.back().push_back(
          {column * 3.0 / cells - 1.5 + jitter(), height + 3 * jitter(), row * 3.0 / cells - 1.5 + jitter()});
    }
  }
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    for (std::size_t j = 0; j + 1 < rows.size(); ++j) {
      faces.push_back({rows[i][j], rows[i + 1][j], rows[i][j + 1]});
      faces.push_back({rows[i + 1][j + 1], rows[i][j + 1], rows[i + 1][j]});
    }
  }
}

const std::array<Point3, 8> cube_corners{Point3{-1, -1, 1},  Point3{1, -1, 1},  Point3{1, 1, 1},  Point3{-1, 1, 1},
                                         Point3{-1, -1, -1}, Point3{1, -1, -1}, Point3{1, 1, -1}, Point3{-1, 1, -1}};

Mesh cube() {
  std::vector<Corners> faces;
  for (const auto& corners : {std::array{0, 1, 2, 3}, std::array{5, 4, 7, 6}, std::array{1, 5, 6, 2},
                              std::array{4, 0, 3, 7}, std::array{3, 2, 6, 7}, std::array{4, 5, 1, 0}}) {
    faces.emplace_back();
    for (const int c : corners) faces.back().push_back(cube_corners[static_cast<std::size_t>(c)]);
  }
  return tests::mesh_of(faces);
}

QuantitativeInvisibility invisibility(const AnyMesh& mesh, const Camera& camera, Sides sides) {
  const ProjectedScene projected = project(mesh, camera, sides);
  const FlatScene scene = flat_scene(projected);
  return quantitative_invisibility(scene, scene_lines(scene));
}

}  // namespace

TEST_CASE("Appel: random scenes full of coincidences, whose faces meet in shared vertices and edges or cross") {
  Totals totals;
  const std::uint64_t count = lattice::scene_count(2000);
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    const lattice::RandomScene scene = seed % 2 == 1 ? lattice::random_scene(seed) : lattice::crossing_scene(seed);
    const Mesh whole = lattice::mesh_of(scene);
    if (touches(whole)) continue;
    CAPTURE(seed);
    check_same(lattice::cut(whole), scene.camera, scene.sides, totals);
  }
  if (count < 2000) return;
  CHECK(totals.scenes > 250);
  CHECK(totals.lines > 2500);
  CHECK(totals.hidden > 1000);
  CHECK(totals.crossings > 1000);
}

TEST_CASE("Appel: tetrahedra and triangles anywhere, through each other and across the window's border") {
  Totals totals;
  const std::uint64_t count = lattice::scene_count(50);
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    CAPTURE(seed);
    lattice::Dice dice(seed);
    const CutMesh mesh = general_mesh(dice);
    check_same(mesh, camera_at({0, 1, 6}), Sides::both, totals);
    check_same(mesh, orthographic_camera("above", view_from({5, 4, 3}), 5), Sides::front, totals);
  }
  CHECK(totals.crossings > 10 * count);
}

TEST_CASE("Appel: an eye inside the scene, so that many lines cross its plane") {
  Totals totals;
  const std::uint64_t count = lattice::scene_count(50);
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    CAPTURE(seed);
    lattice::Dice dice(seed);
    const CutMesh mesh = general_mesh(dice);
    check_same(mesh, perspective_camera("inside", view_from({0.1, 0.2, 0.3}, {1, 0, 0}), 100), Sides::both, totals);
  }
  CHECK(totals.lines > 5 * count);
}

TEST_CASE("Appel: rough sheets one behind the other") {
  Totals totals;
  for (std::uint64_t seed = 1; seed <= lattice::scene_count(8); ++seed) {
    CAPTURE(seed);
    lattice::Dice dice(seed);
    std::vector<Corners> faces;
    for (int sheet = 0; sheet < 3; ++sheet) add_sheet(faces, dice, 5 + sheet, sheet * 0.4);
    check_same(lattice::cut(tests::mesh_of(faces)), camera_at({1, 2, 5}), Sides::both, totals);
  }
  CHECK(totals.hidden > 10 * totals.scenes);
  CHECK(totals.crossings > 10 * totals.scenes);
}

TEST_CASE("Appel: random surfaces of some hundred facets that do not touch") {
  Totals totals;
  const std::uint64_t count = lattice::scene_count(60);
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    const tests::RandomSurfaces surfaces = tests::random_surfaces(seed);
    if (touches(surfaces.mesh)) continue;
    CAPTURE(seed);
    check_same(lattice::cut(surfaces.mesh), surfaces.camera, Sides::both, totals);
  }
  CHECK(totals.scenes > count / 4);
  CHECK(totals.hidden > 50 * totals.scenes);
}

TEST_CASE(
    "Appel on a cube: nine edges are seen; the three behind are hidden by two faces or, front sides only, not there") {
  const Mesh mesh = cube();
  const Camera camera = camera_at({4, 3, 8});
  const QuantitativeInvisibility both = invisibility(mesh, camera, Sides::both);
  std::array<int, 4> with{};
  for (const LineSegment& segment : both.segments) ++with[static_cast<std::size_t>(segment.Q_v)];
  CHECK(with == std::array{9, 3, 0, 0});
  CHECK(both.counts.seeds == 1);
  CHECK(both.counts.propagations == 11);
  CHECK(both.counts.intersections == 0);
  CHECK(invisibility(mesh, camera, Sides::front).segments.size() == 9);
}

TEST_CASE("Appel: a silhouette edge of a body changes Q_v by two, the boundary edge of an open mesh by one") {
  const std::vector<Corners> behind{{{-4, -0.1, -3}, {3, 0.2, -3}, {0, -9, -3}}};
  const std::array<Point3, 4> body{Point3{-1, -1, 0}, Point3{1, -1, 0}, Point3{0, 1, 0}, Point3{0, 0, -1}};
  const auto most = [](const std::vector<Corners>& faces) {
    int Q_v = 0;
    const Mesh mesh = tests::mesh_of(faces);
    for (const LineSegment& segment : invisibility(mesh, camera_at({0.1, 0.2, 10}), Sides::both).segments) {
      Q_v = std::max(Q_v, segment.Q_v);
    }
    return Q_v;
  };
  std::vector<Corners> open = behind;
  open.push_back({body[0], body[1], body[2]});
  CHECK(most(open) == 1);
  std::vector<Corners> closed = behind;
  add_tetrahedron(closed, body);
  CHECK(most(closed) == 2);
}

TEST_CASE(
    "Appel's limit: of faces that overlap in one plane it draws all edges, where sightline shows the first face") {
  const Mesh mesh = tests::mesh_of({{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}, {{-1, 1, 0}, {0, -1, 0}, {1, 1, 0}}});
  REQUIRE(touches(mesh));
  const Comparison result = compare(mesh, camera_at({0, 0, 10}), Sides::both);
  CHECK(result.only_appel > 0.1);
  CHECK(result.only_exact == 0);
}

TEST_CASE("Appel refuses a camera whose near bound cuts the scene open") {
  const Mesh mesh = cube();
  ViewPoint view = view_from({4, 3, 8});
  view.near_distance = 9;
  const Camera camera = perspective_camera("near", view, 40);
  const ProjectedScene projected = project(mesh, camera, Sides::both);
  CHECK_THROWS_AS((void)appel().run(flat_scene(projected), 0), RefusedScene);
}

}  // namespace sightline::tests::peer_lines_test
