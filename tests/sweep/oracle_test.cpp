// sightline is held against the oracle on random scenes: exact visible area per face.
#include <doctest/doctest.h>

#include "oracle/judging/judge.h"

namespace sightline::tests::oracle_test {
using namespace lattice;

namespace {

struct Tally {
  std::uint64_t scenes = 0;
  std::uint64_t perspective = 0;
  std::uint64_t front = 0;
  std::uint64_t clipped = 0;
  std::uint64_t behind = 0;
  std::uint64_t concave = 0;
  std::uint64_t not_planar = 0;
  std::uint64_t coplanar = 0;
  std::uint64_t edge_on = 0;
  SweepStatistics sweep;
};

void count(Tally& tally, const RandomScene& scene, const Verdict& verdict) {
  ++tally.scenes;
  tally.perspective += scene.camera.projection == Projection::perspective ? 1U : 0U;
  tally.front += scene.sides == Sides::front ? 1U : 0U;
  tally.clipped += scene.notes.clipped ? 1U : 0U;
  tally.behind += scene.notes.behind ? 1U : 0U;
  tally.concave += scene.notes.concave ? 1U : 0U;
  tally.not_planar += scene.notes.not_planar ? 1U : 0U;
  tally.coplanar += scene.notes.coplanar_overlap ? 1U : 0U;
  tally.edge_on += scene.notes.edge_on ? 1U : 0U;
  tally.sweep.sweep_points += verdict.statistics.sweep_points;
  tally.sweep.degenerate_sweep_points += verdict.statistics.degenerate_sweep_points;
}

void report(const RandomScene& scene) {
  const RandomScene small = reduced(scene, [](const RandomScene& s) { return !judge(s).complaints.empty(); });
  FAIL_CHECK(joined(judge(small).complaints), to_text(small));
}

}  // namespace

TEST_CASE("on random scenes the visible areas equal the oracle's, as rationals") {
  const std::uint64_t scenes = scene_count(10000);
  constexpr int enough_failures = 3;
  int failures = 0;
  Tally tally;
  for (std::uint64_t seed = 1; seed <= scenes && failures < enough_failures; ++seed) {
    const RandomScene scene = random_scene(seed);
    const Verdict verdict = judge(scene);
    count(tally, scene, verdict);
    if (verdict.complaints.empty()) continue;
    ++failures;
    report(scene);
  }
  REQUIRE(failures == 0);
  MESSAGE(tally.scenes << " scenes, " << tally.sweep.sweep_points << " sweep points, "
                       << tally.sweep.degenerate_sweep_points << " of them degenerate");
  CHECK(tally.sweep.degenerate_sweep_points * 3 >= tally.sweep.sweep_points);
  // The generator made the hard cases.
  CHECK(tally.perspective * 3 >= tally.scenes);
  CHECK((tally.scenes - tally.perspective) * 3 >= tally.scenes);
  CHECK(tally.front * 6 >= tally.scenes);
  CHECK(tally.clipped * 10 >= tally.scenes);
  CHECK(tally.behind * 50 >= tally.scenes);
  CHECK(tally.concave * 10 >= tally.scenes);
  CHECK(tally.not_planar * 100 >= tally.scenes);
  CHECK(tally.coplanar * 5 >= tally.scenes);
  CHECK(tally.edge_on * 5 >= tally.scenes);
}

}  // namespace sightline::tests::oracle_test
