#include "peers/painters/sweep_peers.h"

#include "peers/scene/exact_parts.h"
#include "sightline/analyzer.h"

namespace sightline::peers {
namespace {

template <Arithmetic arithmetic, int grid_bits>
Outcome run_sweep(const FlatScene& flat, int /*resolution*/) {
  const ProjectedScene& projected = *flat.projected;
  const Analyzer analyzer(projected.surface,
                          {.sides = policy_of(projected.sides_shown), .precision = {arithmetic, grid_bits}});
  const auto [sides, scene, segments, polygons] = analyzer.visible(projected.camera);
  Outcome outcome{visible_parts(scene, segments, polygons), {}};
  outcome.counts.push_back({"sweep points", segments.statistics.sweep_points});
  outcome.counts.push_back({"crossings", segments.statistics.crossings});
  outcome.counts.push_back({"visible segments", segments.segments.size()});
  return outcome;
}

constexpr const char* does =
    "A line sweeps the image from top to bottom, stops where edges begin, end or cross, and keeps the edges it crosses "
    "in order with the faces between them in order of depth. Wherever the nearest face changes, a visible segment "
    "begins or ends; segments are linked to the visible polygons.";

Peer peer_of(std::string name, std::string title, std::string errs, decltype(Peer::run) run) {
  return {std::move(name),
          std::move(title),
          "Sechrest and Greenberg 1982, Nurmi 1985, Fang 1993 (5.3)",
          ComputedAt::object_precision,
          does,
          std::move(errs),
          run};
}

template <int grid_bits>
Peer on_grid() {
  const std::string bits = std::to_string(grid_bits);
  return peer_of("sweep-grid-" + bits, "Sweep, exact, on a grid of " + bits + " bits",
                 "Every point of the image is moved to a grid of 2^" + bits +
                     " cells in the half window before the exact sweep: what is smaller than a cell is lost.",
                 run_sweep<Arithmetic::exact, grid_bits>);
}

}  // namespace

std::vector<Peer> sweep_peers() {
  constexpr int finest = default_grid_bits;
  const std::string plain =
      "Every decision is a plain evaluation, which may contradict another one: an order that is none, or a ring that "
      "does not close. Then the sweep ends without a result, or with a wrong one.";
  return {peer_of("sweep-exact", "Sweep, exact",
                  "It is what the others are held against. What remains is the rounding of the image's points to its "
                  "grid of 2^40 cells in the half window.",
                  run_sweep<Arithmetic::exact, finest>),
          peer_of("sweep-double", "Sweep in double", plain, run_sweep<Arithmetic::double_precision, finest>),
          peer_of("sweep-float", "Sweep in float", plain, run_sweep<Arithmetic::single_precision, finest>),
          on_grid<32>(),
          on_grid<24>(),
          on_grid<16>(),
          on_grid<12>(),
          on_grid<8>()};
}

}  // namespace sightline::peers
