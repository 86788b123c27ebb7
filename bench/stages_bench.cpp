// This runs the stages of one view on generated scenes, on one core: it prints the time per stage, and sweep points per
// second.
//
//     build/release/bench/sightline_bench

#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include "bench/scenes/generated_scenes.h"
#include "sightline/analyzer.h"

namespace sightline::bench {
namespace {

struct Case {
  std::shared_ptr<const CutMesh> mesh;
  Camera camera;
  Sides sides;
};

Case case_of(Mesh mesh, const Camera& camera, Sides sides) {
  return {std::make_shared<const CutMesh>(uncrossed(std::move(mesh))), camera, sides};
}

Case sphere_case(std::size_t triangles, Sides sides) { return case_of(folded_sphere(triangles), overview(), sides); }
Case terrain_case(std::size_t triangles) { return case_of(terrain(triangles), grazing_view(), Sides::both); }

// Adds up how long the sweeps take.
class SweepTime : public AnalysisHook {
 public:
  void ended(Stage stage, double seconds) override { seconds_ += stage == Stage::sweep ? seconds : 0; }
  [[nodiscard]] double seconds() const { return seconds_; }

 private:
  double seconds_ = 0;
};

void run_view(benchmark::State& state, const Case& c) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  SweepTime time;
  const Analyzer analyzer(c.mesh, {.sides = policy_of(c.sides), .hook = &time});
  std::uint64_t sweep_points = 0;
  for (auto _ : state) {
    const View view = analyzer.view(c.camera);
    sweep_points += view.segments.statistics.sweep_points;
    benchmark::DoNotOptimize(view.labelled.triangles.data());
  }
  state.counters["triangles"] = static_cast<double>(c.mesh->facet_count());
  state.counters["sweep_points"] = static_cast<double>(sweep_points) / static_cast<double>(state.iterations());
  state.counters["sweep_points_per_s"] = static_cast<double>(sweep_points) / time.seconds();
  state.counters["sweep_s"] = time.seconds() / static_cast<double>(state.iterations());
}

void view_of_sphere(benchmark::State& state) {
  run_view(state, sphere_case(static_cast<std::size_t>(state.range(0)), Sides::front));
}
void view_of_sphere_both_sides(benchmark::State& state) {
  run_view(state, sphere_case(static_cast<std::size_t>(state.range(0)), Sides::both));
}
void view_of_terrain(benchmark::State& state) {
  run_view(state, terrain_case(static_cast<std::size_t>(state.range(0))));
}

// All of a terrain is seen, and a square lamp over it. reflect_s is the time to find what reflects it, swept counts the
// pyramids that had an obstacle in them, each of which costs a sweep.
void reflections_of_terrain(benchmark::State& state) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const Analyzer analyzer(uncrossed(terrain(static_cast<std::size_t>(state.range(0)))), {.sides = SidesPolicy::both});
  const MirrorWorld world = analyzer.world({{"lamp", {{-1, 9, -1}, {1, 9, -1}, {1, 9, 1}, {-1, 9, 1}}, {}}});
  const Visibility view = analyzer.visible(view_from_above());
  ReflectedView reflected;
  for (auto _ : state) {
    reflected = find_reflections(world, view.scene, view.segments, view.polygons);
    benchmark::DoNotOptimize(reflected.scene.points.data());
  }
  const Reflections& found = reflected.reflections;
  state.counters["visible"] = static_cast<double>(view.polygons.polygons.size());
  state.counters["pyramids"] = static_cast<double>(found.statistics.pyramids);
  state.counters["obstacles"] = static_cast<double>(found.statistics.obstacles);
  state.counters["swept"] = static_cast<double>(found.statistics.blocked);
  state.counters["reflecting"] = static_cast<double>(found.panels[0].polygons.polygons.size());
}

BENCHMARK(view_of_sphere)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond);
BENCHMARK(view_of_sphere_both_sides)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond);
BENCHMARK(view_of_terrain)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond);

BENCHMARK(reflections_of_terrain)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace sightline::bench

BENCHMARK_MAIN();
