// The analyzer: its hook is told of every stage, whatever throws ends the analysis, and neither the engine, nor threads, nor
// an overload changes what is found.
#include "sightline/analyzer.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <stdexcept>
#include <thread>
#include <tuple>
#include <utility>

#include "geometry/cutting/common_lines.h"
#include "tests/tools/polygon_mesh.h"

namespace sightline::tests::analyzer_test {
namespace {

// A floor, and a sheet that passes through it.
Mesh crossing_sheets() {
  return mesh_of({{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {{-0.5, 0, -0.5}, {0.5, 0, -0.5}, {0, 0, 0.5}}});
}

Camera from_above(double x = 0.3) {
  ViewPoint view;
  view.eye = {x, -2, 3};
  view.target = {0, 0, 0};
  return perspective_camera("above", view, 40);
}

std::vector<Panel> lamp() { return {{"lamp", {{-2, 5, 4}, {2, 5, 4}, {2, 1, 4}, {-2, 1, 4}}, {}}}; }

struct Recorder : AnalysisHook {
  std::vector<Stage> begun;
  std::vector<Stage> over;
  std::size_t scenes = 0;

  void begins(Stage stage) override { begun.push_back(stage); }
  void ended(Stage stage, double seconds) override {
    CHECK(seconds >= 0);
    over.push_back(stage);
  }
  void projected(const ProjectedScene& scene) override {
    CHECK(scene.edge_count() > 0);
    ++scenes;
  }
};

struct Cancelled : std::runtime_error {
  Cancelled() : std::runtime_error("cancelled") {}
};

struct CancelAt : AnalysisHook {
  explicit CancelAt(Stage where) : stage(where) {}
  void begins(Stage begun) override {
    if (begun == stage) throw Cancelled();
  }
  Stage stage;
};

struct CancelSweep : AnalysisHook, SweepObserver {
  void on_point(const SweepPoint& point) override {
    if (point.points_done > 2) throw Cancelled();
  }
  SweepObserver* sweep_observer() override { return this; }
};

void check_same(const View& a, const View& b) {
  CHECK(std::ranges::equal(a.segments.segments, b.segments.segments, [](const auto& s, const auto& t) {
    return std::tie(s.start, s.end, s.facet, s.edge) == std::tie(t.start, t.end, t.facet, t.edge);
  }));
  CHECK(a.labelled.vertices == b.labelled.vertices);
  REQUIRE(a.labelled.triangles.size() == b.labelled.triangles.size());
  for (std::size_t t = 0; t < a.labelled.triangles.size(); ++t) {
    CHECK(a.labelled.triangles[t].corners == b.labelled.triangles[t].corners);
    CHECK(a.labelled.triangles[t].label == b.labelled.triangles[t].label);
    CHECK(a.labelled.triangles[t].reflecting == b.labelled.triangles[t].reflecting);
  }
}

}  // namespace

TEST_CASE("analyzer: the hook is told of every stage, in their order, the first two once") {
  Recorder hook;
  const Analyzer analyzer(crossing_sheets(), {.precision = {}, .hook = &hook});
  CHECK(hook.begun == std::vector{Stage::contacts, Stage::cut});
  CHECK(analyzer.mesh().is_cut());
  hook.begun.clear();
  hook.over.clear();
  (void)analyzer.view(from_above(), lamp());
  const std::vector expected{Stage::sides,       Stage::project, Stage::sweep,
                             Stage::reconstruct, Stage::reflect, Stage::label};
  CHECK(hook.begun == expected);
  CHECK(hook.over == expected);
  hook.begun.clear();
  (void)analyzer.view(from_above());
  CHECK(std::ranges::count(hook.begun, Stage::reflect) == 0);
  CHECK(std::ranges::count(hook.begun, Stage::label) == 1);
  hook.begun.clear();
  (void)analyzer.visible(from_above());
  CHECK(hook.begun == std::vector{Stage::sides, Stage::project, Stage::sweep, Stage::reconstruct});
  CHECK(hook.scenes == 3);
}

TEST_CASE(
    "analyzer: without rounding nothing is cut, and contacts are looked for where a closed surface may be culled") {
  Recorder hook;
  const Analyzer open(crossing_sheets(), {.hook = &hook});
  CHECK(hook.begun.empty());
  CHECK_FALSE(open.mesh().is_cut());
  CHECK(open.sides(from_above()).reason == "both sides: edge 0-3 has one facet");
  const Mesh closed = mesh_of({{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}},
                               {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}},
                               {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                               {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
  CHECK(Analyzer(closed, {.hook = &hook}).sides(from_above()).sides == Sides::front);
  CHECK(hook.begun == std::vector{Stage::contacts});
  hook.begun.clear();
  CHECK(Analyzer(closed, {.sides = SidesPolicy::both, .hook = &hook}).sides(from_above()).sides == Sides::both);
  CHECK(hook.begun.empty());
}

TEST_CASE("analyzer: what the hook throws ends the analysis, at every stage") {
  for (const Stage stage : {Stage::contacts, Stage::cut}) {
    CancelAt hook(stage);
    CHECK_THROWS_AS(Analyzer(crossing_sheets(), {.precision = {}, .hook = &hook}), Cancelled);
  }
  for (const Stage stage :
       {Stage::sides, Stage::project, Stage::sweep, Stage::reconstruct, Stage::reflect, Stage::label}) {
    CancelAt hook(stage);
    const Analyzer analyzer(crossing_sheets(), {.hook = &hook});
    CHECK_THROWS_AS((void)analyzer.view(from_above(), lamp()), Cancelled);
  }
}

TEST_CASE("analyzer: what the sweep's observer throws ends the analysis, in either engine and with several threads") {
  for (const Engine engine : {Engine::fast, Engine::full}) {
    for (const std::size_t threads : {std::size_t{1}, std::size_t{2}}) {
      CancelSweep hook;
      const Analyzer analyzer(crossing_sheets(), {.engine = engine, .threads = threads, .hook = &hook});
      CHECK_THROWS_AS((void)analyzer.view(from_above()), Cancelled);
    }
  }
}

TEST_CASE("analyzer: engines, threads, the overloads and a mesh cut by the caller give the same") {
  const Mesh mesh = crossing_sheets();
  const View expected = Analyzer(mesh).view(from_above(), lamp());
  REQUIRE(!expected.reflections.panels.at(0).polygons.polygons.empty());
  check_same(Analyzer(mesh, {.engine = Engine::full}).view(from_above(), lamp()), expected);
  check_same(Analyzer(mesh, {.threads = 1}).view(from_above(), lamp()), expected);
  const Analyzer analyzer(mesh);
  check_same(analyzer.view(from_above(), analyzer.world(lamp())), expected);
  const MeshContacts contacts = find_contacts(mesh);
  const AnalysisOptions on_grid{.precision = {}};
  check_same(Analyzer(cut_along_common_lines(mesh, contacts), on_grid, contacts).view(from_above(), lamp()),
             Analyzer(mesh, on_grid).view(from_above(), lamp()));
  check_same(analyzer.view(from_above(), std::vector<Panel>{}), analyzer.view(from_above()));
}

TEST_CASE("analyzer: several threads ask for views at once, and these outlive the analyzer") {
  std::vector<View> views(4);
  std::vector<View> expected;
  {
    const Analyzer analyzer(crossing_sheets());
    for (std::size_t i = 0; i < views.size(); ++i)
      expected.push_back(analyzer.view(from_above(0.1 * static_cast<double>(i))));
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < views.size(); ++i)
      threads.emplace_back([&, i] { views[i] = analyzer.view(from_above(0.1 * static_cast<double>(i))); });
  }
  for (std::size_t i = 0; i < views.size(); ++i) {
    check_same(views[i], expected[i]);
    CHECK(views[i].mesh().face_count() == 2);
  }
}

TEST_CASE("analyzer: without contacts automatic sides are both") {
  const Mesh mesh = crossing_sheets();
  const Analyzer analyzer(uncrossed(mesh));
  CHECK(analyzer.sides(from_above()).sides == Sides::both);
}

}  // namespace sightline::tests::analyzer_test
