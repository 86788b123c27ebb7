// The floating horizon is held against the exact sweep, at the columns' centres, on random height fields; and it
// refuses what it must.
#include "peers/lines/floating_horizon.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>

#include "formats/writing/window_points.h"
#include "oracle/judging/judge.h"
#include "oracle/lattice/lattice.h"
#include "peers/lines/height_field.h"
#include "tests/tools/analyzed.h"
#include "tests/tools/polygon_mesh.h"

namespace sightline::tests::peer_floating_horizon_test {
using namespace peers;

using lattice::Dice;

namespace {

constexpr int resolution = 64;
constexpr double tolerance = 1e-9;

// The field is y = f(x, z) over a grid of unequal cells, as triangles with either diagonal or, where it is not rough,
// as quadrangles, too, most not planar. `turn` makes another axis the height.
Mesh random_field(Dice& dice, int turn = 0) {
  std::array<std::vector<double>, 2> ground;
  for (auto& values : ground) {
    const int count = dice.between(2, 7);
    for (int i = 0; i <= count; ++i) values.push_back((i + dice.between(-300, 300) * 1e-3) / count * 4 - 2);
  }
  const double rough = dice.between(1, 30) * 1e-3;
  std::map<std::array<std::size_t, 2>, Point3> at;
  for (std::size_t i = 0; i < ground[0].size(); ++i) {
    for (std::size_t j = 0; j < ground[1].size(); ++j) {
      const std::array p{ground[0][i], dice.between(-40, 40) * rough, ground[1][j]};
      const auto axis = [&](int k) { return p[static_cast<std::size_t>((k + turn) % 3)]; };
      at[{i, j}] = {axis(0), axis(1), axis(2)};
    }
  }
  std::vector<tests::Corners> faces;
  for (std::size_t i = 0; i + 1 < ground[0].size(); ++i) {
    for (std::size_t j = 0; j + 1 < ground[1].size(); ++j) {
      const std::array cell{at[{i, j}], at[{i, j + 1}], at[{i + 1, j + 1}], at[{i + 1, j}]};
      const auto c = static_cast<std::size_t>(dice.between(0, rough < 0.005 ? 2 : 1));
      if (c == 2) {
        faces.push_back({cell[0], cell[1], cell[2], cell[3]});
        continue;
      }
      faces.push_back({cell[c], cell[c + 1], cell[(c + 2) % 4]});
      faces.push_back({cell[c], cell[(c + 2) % 4], cell[(c + 3) % 4]});
    }
  }
  return tests::mesh_of(faces);
}

ViewPoint view_from(const Point3& eye, const Point3& target, const Vector3& up = {0, 1, 0}) {
  ViewPoint view;
  view.eye = eye;
  view.target = target;
  view.up = up;
  return view;
}

// This is where along x the sweep sees a mesh edge, in the window.
struct Interval {
  double begin = 0;
  double end = 0;
};
using SeenIntervals = std::map<MeshEdgeId, std::vector<Interval>>;

SeenIntervals seen_intervals(const View& view) {
  const std::vector<Point2> places = window_points(view);
  SeenIntervals seen;
  for (const VisibleSegment& segment : view.segments.segments) {
    const auto [begin, end] = std::minmax(places[segment.start.index()].x, places[segment.end.index()].x);
    for (const EdgeSide& side : view.scene.sides_of(segment.edge)) seen[side.mesh_edge].push_back({begin, end});
  }
  return seen;
}

struct Sampled {
  int seen = 0;
  int hidden = 0;
  int undecided = 0;  // within the tolerance of where the sweep's segments end
};

bool is_drawn(const VisibleLines& lines, const Point2& p) {
  return std::any_of(lines.begin(), lines.end(), [&p](const VisibleLine& line) {
    if (p.x < line.from.x || p.x > line.to.x || line.from.x == line.to.x) return false;
    const double t = (p.x - line.from.x) / (line.to.x - line.from.x);
    return std::abs(line.from.y + t * (line.to.y - line.from.y) - p.y) < tolerance;
  });
}

void check_edge(const std::vector<Interval>& seen, const VisibleLines& lines, Point2 a, Point2 b, Sampled& sampled) {
  if (a.x > b.x) std::swap(a, b);
  for (int column = 0; column < resolution; ++column) {
    const double x = (2 * column + 1.0) / resolution - 1;
    const Point2 p{x, a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x)};
    if (x < a.x || x > b.x || std::abs(p.y) >= 1) continue;
    const auto is_end = [x](const Interval& i) {
      return std::abs(x - i.begin) < tolerance || std::abs(x - i.end) < tolerance;
    };
    if (std::any_of(seen.begin(), seen.end(), is_end)) {
      ++sampled.undecided;
      continue;
    }
    const bool expected =
        std::any_of(seen.begin(), seen.end(), [x](const Interval& i) { return i.begin < x && x < i.end; });
    ++(expected ? sampled.seen : sampled.hidden);
    INFO("at ", p.x, ",", p.y);
    CHECK(is_drawn(lines, p) == expected);
  }
}

// At every centre of a column, each polyline is drawn where the sweep sees it.
void check_field(const Mesh& mesh, const Camera& camera, Sampled& sampled) {
  const View view = analyzed(mesh, camera, Sides::both);
  const FlatScene scene = flat_scene(view.scene);
  const VisibleLines lines = std::get<VisibleLines>(floating_horizon().run(scene, resolution).seen);
  const SeenIntervals seen = seen_intervals(view);
  for (const auto& polyline : height_field(scene).polylines) {
    for (std::size_t i = 0; i + 1 < polyline.size(); ++i) {
      const auto edge = std::find_if(mesh.edges.begin(), mesh.edges.end(), [&](const auto& ends) {
        return ends == std::array{polyline[i], polyline[i + 1]} || ends == std::array{polyline[i + 1], polyline[i]};
      });
      REQUIRE(edge != mesh.edges.end());
      const auto found = seen.find(MeshEdgeId(static_cast<std::size_t>(edge - mesh.edges.begin())));
      check_edge(found == seen.end() ? std::vector<Interval>{} : found->second, lines,
                 window_place(camera, mesh.position(polyline[i])), window_place(camera, mesh.position(polyline[i + 1])),
                 sampled);
    }
  }
}

void check_many(const std::function<Camera(Dice&)>& camera, int turn = 0) {
  Sampled sampled;
  const std::uint64_t count = lattice::scene_count(100);
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    CAPTURE(seed);
    Dice dice(seed);
    const Mesh mesh = random_field(dice, turn);
    check_field(mesh, camera(dice), sampled);
  }
  CHECK(sampled.undecided <= sampled.seen / 1000);
  if (count < 100) return;
  CHECK(sampled.seen > 5000);
  CHECK(sampled.hidden > 2000);
}

double anywhere(Dice& dice) { return dice.between(-1000, 1000) * 1e-3; }

std::string refusal(const Mesh& mesh, const Camera& camera, Sides sides = Sides::both) {
  const ProjectedScene projected = project(mesh, camera, sides);
  try {
    (void)floating_horizon().run(flat_scene(projected), resolution);
  } catch (const RefusedScene& refused) {
    return refused.what();
  }
  return "";
}

Mesh some_field() {
  Dice dice(1);
  return random_field(dice);
}

Camera from_above() { return orthographic_camera("above", view_from({1, 3, 6}, {0, 0, 0}), 5); }

}  // namespace

TEST_CASE("Floating horizon: height fields seen from above and beside by parallel rays, all axes as the height") {
  for (int turn = 0; turn < 3; ++turn) {
    CAPTURE(turn);
    check_many(
        [turn](Dice& dice) {
          const std::array eye{5 * anywhere(dice), 1 + anywhere(dice), 6 * anywhere(dice)};
          const std::array up{0.0, 1.0, 0.0};
          const auto turned = [turn](const std::array<double, 3>& p) -> Vector3 {
            const auto axis = [&](int k) { return p[static_cast<std::size_t>((k + turn) % 3)]; };
            return Vector3{axis(0), axis(1), axis(2)};
          };
          return orthographic_camera("rays", view_from(turned(eye), {0, 0, 0}, turned(up)), 4);
        },
        turn);
  }
}

TEST_CASE("Floating horizon: height fields seen by a level pinhole, from before, behind, left and right") {
  check_many([](Dice& dice) {
    const double height = anywhere(dice);
    const double away = dice.one_in(2) ? 6 : -6;
    const Point3 eye =
        dice.one_in(2) ? Point3{2 * anywhere(dice), height, away} : Point3{away, height, 2 * anywhere(dice)};
    return perspective_camera("level", view_from(eye, {0, height, 0}), 40);
  });
}

TEST_CASE("Floating horizon: a ridge across the polylines hides, though no polyline is as high in that column") {
  // Seen from the corner, the ridge at x = 0 rises between the polylines z = 1 and z = -1 in the columns in which the
  // far one, at z = -3, passes behind it.
  std::vector<tests::Corners> faces;
  const std::array xs{-3.0, 0.0, 3.0};
  const std::array zs{3.0, 1.0, -1.0, -3.0};
  const auto at = [&](std::size_t i, std::size_t j) { return Point3{xs[i], i == 1 && j < 3 ? 1.0 : 0.0, zs[j]}; };
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 3; ++j) faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  }
  Sampled sampled;
  check_field(tests::mesh_of(faces), orthographic_camera("corner", view_from({5, 0.7, 2}, {0, 0, 0}), 8), sampled);
  CHECK(sampled.hidden > 10);
  CHECK(sampled.seen > 10);
}

TEST_CASE("Floating horizon, the slides' arrays: a polyline is drawn above YMAX and below YMIN, and moves them there") {
  // There are three polylines of two edges each, seen from the front: the second one is hidden in its middle, the third
  // all along but for its ends.
  const auto polyline = [](double z, double left, double middle, double right) {
    return std::array{Point3{-1, left, z}, Point3{0, middle, z}, Point3{1, right, z}};
  };
  const std::array lines{polyline(2, 0.5, 0.25, 0.5), polyline(1, -0.5, -0.25, -0.5), polyline(0, 0.75, 0, 0)};
  std::vector<tests::Corners> faces;
  for (std::size_t j = 0; j < 2; ++j) {
    for (std::size_t i = 0; i < 2; ++i)
      faces.push_back({lines[j][i], lines[j][i + 1], lines[j + 1][i + 1], lines[j + 1][i]});
  }
  const Mesh mesh = tests::mesh_of(faces);
  const Camera camera = orthographic_camera("front", view_from({0, 0, 9}, {0, 0, 0}), 2);
  const ProjectedScene projected = project(mesh, camera, Sides::both);
  const Outcome outcome = floating_horizon().run(flat_scene(projected), 4);
  const VisibleLines& drawn = std::get<VisibleLines>(outcome.seen);
  REQUIRE(drawn.size() == 5);
  CHECK(drawn[0].to == Point2{0, 0.25});
  CHECK(drawn[2].from == Point2{-1, -0.5});
  CHECK(drawn[3].to == Point2{1, -0.5});
  CHECK(drawn[4].from == Point2{-1, 0.75});  // above YMAX in the first column only, whose centre is at -0.75
  CHECK(drawn[4].to == Point2{-0.5, 0.375});
  CHECK(outcome.counts[0].number == 3);
}

TEST_CASE("Floating horizon refuses what is no height field") {
  const auto refused = [](const Mesh& mesh) { return refusal(mesh, from_above()).substr(0, 27); };
  const std::string reason = "the mesh is no height field";
  const Point3 a{0, 0, 0};
  const Point3 b{1, 0.1, 0};
  const Point3 c{2, 0.3, 0};
  const Point3 d{0, 0.2, -1};
  const Point3 e{1, 0.4, -1};
  const Point3 f{2, 0.2, -1};
  CHECK(refusal(tests::mesh_of({{a, b, e, d}, {b, c, f, e}}), from_above()).empty());
  CHECK(refused(tests::mesh_of({{a, b, d}})) == reason);                                      // a corner is missing
  CHECK(refused(tests::mesh_of({{a, b, e, d}, {b, c, f}})) == reason);                        // half a cell is missing
  CHECK(refused(tests::mesh_of({{a, b, e, d}, {b, c, f, e}, {a, b, e}})) == reason);          // a cell is covered twice
  CHECK(refused(tests::mesh_of({{a, b, d}, {b, d, a}, {a, b, e}, {b, c, f, e}})) == reason);  // triangles overlap
  CHECK(refused(tests::mesh_of({{a, c, d}, {c, f, d}, {b, e, f}})) == reason);                // over two cells
  CHECK(refused(tests::mesh_of({{a, b, e, d}, {b, c, f, e}, {a, b, {1, 1, 0}}})) == reason);  // two heights
}

TEST_CASE("Floating horizon refuses cameras whose columns are not upright, or that see no order from front to back") {
  const Mesh mesh = some_field();
  CHECK(refusal(mesh, from_above()).empty());
  const auto says = [](const std::string& text, const char* part) { return text.find(part) != std::string::npos; };
  CHECK(says(refusal(mesh, orthographic_camera("rolled", view_from({1, 3, 6}, {0, 0, 0}, {0.1, 1, 0}), 5)), "rolled"));
  CHECK(says(refusal(mesh, perspective_camera("down", view_from({1, 3, 6}, {0, 0, 0}), 40)), "looks up or down"));
  CHECK(says(refusal(mesh, perspective_camera("in", view_from({0, 1, 0}, {0, 1, -6}), 40)), "behind the eye"));
  CHECK(says(refusal(mesh, orthographic_camera("top", view_from({0, 9, 0}, {0, 0, 0}, {0, 0, -1}), 5)), "no order"));
  ViewPoint near = view_from({1, 3, 6}, {0, 0, 0});
  near.near_distance = 0.5;
  CHECK(says(refusal(mesh, orthographic_camera("near", near, 5)), "near or far bound"));
  CHECK(says(refusal(mesh, from_above(), Sides::front), "front sides"));
}

}  // namespace sightline::tests::peer_floating_horizon_test
