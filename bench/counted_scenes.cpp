// Analyses one fixed scene, once. scripts/instruction-counts has valgrind count the instructions.
//
//     build/release/bench/sightline_counted_scenes sphere|terrain|sheets [grid]      (grid: rounded to it)

#include <tbb/global_control.h>

#include <cstdio>
#include <optional>
#include <string_view>

#include "bench/scenes/generated_scenes.h"
#include "sightline/analyzer.h"

namespace sightline::bench {
namespace {

struct Case {
  Mesh mesh;
  Camera camera;
  Sides sides;
};

std::optional<Case> case_named(std::string_view name) {
  if (name == "sphere") return Case{folded_sphere(10000), overview(), Sides::front};
  if (name == "terrain") return Case{terrain(10000), grazing_view(), Sides::both};
  if (name == "sheets") return Case{sheets(10000, 8, FrontSheet::whole), view_into_box(), Sides::both};
  return std::nullopt;
}

// Valgrind counts between this function's entry and its end, by its name: to make the mesh does not count.
// Valgrind counts one thread.
[[gnu::noinline]] View counted_analysis(const Case& c, Arithmetic arithmetic) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  return Analyzer(uncrossed(c.mesh), {.sides = policy_of(c.sides), .precision = {arithmetic}}).view(c.camera);
}

}  // namespace
}  // namespace sightline::bench

int main(int argc, char** argv) {
  using namespace sightline;
  const bool on_grid = argc == 3 && std::string_view(argv[2]) == "grid";
  const std::optional<bench::Case> chosen = argc == 2 || on_grid ? bench::case_named(argv[1]) : std::nullopt;
  if (!chosen) {
    std::fputs("usage: sightline_counted_scenes sphere|terrain|sheets [grid]\n", stderr);
    return 2;
  }
  const View view = bench::counted_analysis(*chosen, on_grid ? Arithmetic::exact : Arithmetic::unrounded);
  std::printf("%zu triangles, %zu visible polygons\n", chosen->mesh.facet_count(), view.polygons.polygons.size());
}
