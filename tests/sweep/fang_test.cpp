// Fang's worked example (1993, section 5.3, tables 5.2 to 5.4) is tested at every stage: pentagon ABCDE before triangle
// OPQ.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "oracle/judging/judge.h"
#include "sweep/segments/crossing_point.h"
#include "tests/tools/analyzed.h"

namespace sightline::tests::fang_test {
namespace {

using lattice::Rational;

// This is a point of the example, in the drawing's units.
struct Named {
  char name;
  Rational x;
  Rational y;
};

const std::vector<Named>& points() {
  static const std::vector<Named> all{{'O', 6, 12},
                                      {'P', 2, 4},
                                      {'Q', 14, 0},
                                      {'A', 2, 9},
                                      {'B', 4, 2},
                                      {'C', 8, 5},
                                      {'D', 7, 8},
                                      {'E', 4, 11},
                                      {'F', 5, 10},
                                      {'G', Rational(32, 11), Rational(64, 11)},
                                      {'H', Rational(68, 19), Rational(66, 19)},
                                      {'I', Rational(68, 13), Rational(38, 13)}};
  return all;
}

const Named& named(char name) {
  return *std::find_if(points().begin(), points().end(), [&](const Named& p) { return p.name == name; });
}

constexpr double window_half = 16;
constexpr std::size_t pentagon = 0;
constexpr std::size_t triangle = 1;

Mesh worked_example() {
  std::vector<Point3> vertices;
  for (const Named& p : points()) {
    if (p.name == 'F') break;
    const bool of_triangle = p.name >= 'O';
    vertices.push_back({p.x.convert_to<double>(), p.y.convert_to<double>(), of_triangle ? 0.0 : 1.0});
  }
  PolygonList faces;
  const auto ids = [](std::initializer_list<std::size_t> indices) {
    std::vector<VertexId> result;
    for (const std::size_t i : indices) result.emplace_back(i);
    return result;
  };
  faces.push_back(ids({3, 4, 5, 6, 7}));
  faces.push_back(ids({0, 1, 2}));
  return build_mesh(std::move(vertices), std::move(faces));
}

Camera camera() {
  Camera result;
  result.projection = Projection::orthographic;
  result.right = {1 / window_half, 0, 0};
  result.up = {0, 1 / window_half, 0};
  result.forward = {0, 0, -1};
  result.eye = {{0, 0, 1}, 0};
  return result;
}

class Recorder : public AnalysisHook, public SweepObserver {
 public:
  [[nodiscard]] SweepObserver* sweep_observer() override { return this; }
  void on_point(const SweepPoint& point) override { visited.emplace_back(point.x, point.y); }
  std::vector<std::pair<double, double>> visited;
};

template <class Integer>
Rational rational(const Integer& value) {
  return Rational(value.template convert_to<boost::multiprecision::cpp_int>());
}

// Returns grid units per unit of the drawing.
Rational grid_unit(const ProjectedScene& scene) {
  return Rational(boost::multiprecision::cpp_int(1) << static_cast<unsigned>(scene.grid_bits)) / 16;
}

char name_of(const View& view, PointId p) {
  const ExactPoint exact = exact_point(view.scene, view.segments, p);
  const Rational scale = grid_unit(view.scene) * rational(exact.denominator);
  for (const Named& n : points()) {
    if (n.x * scale == rational(exact.x) && n.y * scale == rational(exact.y)) return n.name;
  }
  return '?';
}

std::string name_of(const View& view, const VisibleSegment& s) {
  return {name_of(view, s.start), name_of(view, s.end)};
}

// Returns a ring by the names of its points, from the one that the name begins with.
std::string name_of_ring(const View& view, std::size_t ring, char first) {
  std::string result;
  for (const SegmentId s : view.polygons.ring(ring)) result += name_of(view, view.segments.segments[s.index()].start);
  const auto start = result.find(first);
  if (start != std::string::npos)
    std::rotate(result.begin(), result.begin() + static_cast<std::ptrdiff_t>(start), result.end());
  return result;
}

Rational area(const std::string& ring) {
  Rational twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Named& p = named(ring[i]);
    const Named& q = named(ring[(i + 1) % ring.size()]);
    twice += p.x * q.y - q.x * p.y;
  }
  return twice / 2;
}

Rational off_by(double value, const Rational& truth) { return abs(Rational(value) - truth); }

// An observer sees vertices exactly, crossings as crossing_point.h says.
Rational bound_of(char name, const ProjectedScene& scene) {
  const bool crossing = name >= 'F' && name <= 'I';
  return crossing ? Rational(std::ldexp(crossing_error, -scene.grid_bits)) : Rational(0);
}

std::vector<std::string> sorted(std::vector<std::string> names) {
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

TEST_CASE("worked example: projection keeps the eight points and eight edges") {
  const Mesh mesh = worked_example();
  const ProjectedScene scene = project(mesh, camera(), Sides::both);
  CHECK(validate(mesh).empty());
  CHECK(validate(scene).empty());
  CHECK(scene.points.size() == 8);
  CHECK(scene.edge_count() == 8);
  const std::string order = "OEADCPBQ";
  for (std::size_t i = 0; i < order.size(); ++i) {
    CHECK(Rational(scene.points[i].x) == named(order[i]).x * grid_unit(scene));
    CHECK(Rational(scene.points[i].y) == named(order[i]).y * grid_unit(scene));
  }
}

TEST_CASE("worked example: the sweep points come in the source's order") {
  Recorder recorder;
  const Analyzer analyzer(uncrossed(worked_example()),
                          {.sides = SidesPolicy::both, .precision = {}, .hook = &recorder});
  const View view = analyzer.view(camera());
  const std::string order = "OEFADGCPHIBQ";
  REQUIRE(recorder.visited.size() == order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    INFO("sweep point ", order[i]);
    const Named& point = named(order[i]);
    CHECK(off_by(recorder.visited[i].first, point.x / 16) <= bound_of(order[i], view.scene));
    CHECK(off_by(recorder.visited[i].second, point.y / 16) <= bound_of(order[i], view.scene));
  }
  CHECK(view.segments.statistics.sweep_points == 12);
  CHECK(view.segments.statistics.crossings == 4);
  CHECK(view.segments.statistics.degenerate_sweep_points == 0);
}

TEST_CASE("worked example: the fourteen visible segments of table 5.4") {
  const View view = analyzed(worked_example(), camera());
  CHECK(validate(view.segments, view.scene).empty());
  std::vector<std::string> names;
  for (const VisibleSegment& s : view.segments.segments) {
    names.push_back(std::to_string(s.facet.value) + name_of(view, s));
  }
  CHECK(sorted(names) ==
        sorted({"1OF", "1QO", "0EA", "0DE", "1FD", "0AB", "0CD", "1DC", "1GP", "1HG", "0BC", "1CI", "1PH", "1IQ"}));
  // Nothing is a hole here, and only the outline of the triangle has nothing on its right.
  for (const VisibleSegment& s : view.segments.segments) {
    const std::string name = name_of(view, s);
    const bool against_pentagon = name == "FD" || name == "DC" || name == "CI" || name == "HG";
    if (s.facet.index() == triangle) CHECK(s.other == (against_pentagon ? FacetId(pentagon) : FacetId()));
  }
}

TEST_CASE("worked example: visible polygons ABCDE, OFDCIQ and PHG with their exact areas") {
  const Mesh mesh = worked_example();
  const View view = analyzed(mesh, camera());
  CHECK(validate(view.polygons, view.scene, view.segments).empty());
  REQUIRE(view.polygons.polygons.size() == 3);
  REQUIRE(view.polygons.ring_count() == 3);
  const std::array<std::string, 3> given{"ABCDE", "OFDCIQ", "PHG"};
  const std::array<std::size_t, 3> faces{pentagon, triangle, triangle};
  const Rational unit = grid_unit(view.scene) * grid_unit(view.scene);
  for (std::size_t p = 0; p < 3; ++p) {
    CHECK(view.polygons.polygons[p].face.index() == faces[p]);
    CHECK(name_of_ring(view, view.polygons.polygons[p].first_ring, given[p].front()) == given[p]);
    CHECK(exact_area(view.scene, view.segments, view.polygons, p) == area(given[p]) * unit);
  }
}

TEST_CASE("worked example: the labelled mesh splits the triangle along the pentagon and nothing else") {
  const Mesh mesh = worked_example();
  const View view = analyzed(mesh, camera());
  CHECK(validate(view.labelled, view.scene).empty());
  std::array<double, 2> visible{};
  std::array<double, 2> hidden{};
  for (const LabelledTriangle& t : view.labelled.triangles) {
    const auto at = [&](std::size_t i) { return view.labelled.vertices[t.corners[i].index()]; };
    const double twice = (at(1) - at(0)).cross(at(2) - at(0)).z();
    (t.label == Label::visible ? visible : hidden)[t.face.index()] += twice / 2;
    CHECK((t.label == Label::visible || t.label == Label::hidden));
  }
  const auto close = [](const Rational& value) { return doctest::Approx(value.convert_to<double>()).epsilon(1e-13); };
  CHECK(visible[pentagon] == close(area("ABCDE")));
  CHECK(hidden[pentagon] == 0);
  CHECK(visible[triangle] == close(area("OFDCIQ") + area("PHG")));
  CHECK(visible[triangle] + hidden[triangle] == close(area("OPQ")));
}

}  // namespace sightline::tests::fang_test
