// The sweep as a peer errs in float and double, or does not end, where the stability runs say so; exact, it does not.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "cli/stability/stability_run.h"
#include "geometry/cutting/common_lines.h"
#include "geometry/cutting/interpenetration.h"
#include "peers/errors/part_errors.h"
#include "peers/painters/sweep_peers.h"
#include "sweep/engine.h"
#include "tests/tools/analyzed.h"

namespace sightline::tests::peer_sweeps_test {
using namespace cli;
using namespace peers;

namespace {

const ExtremeFamily& family_named(std::string_view name) {
  const auto& all = extreme_families();
  return *std::find_if(all.begin(), all.end(), [name](const ExtremeFamily& family) { return family.name == name; });
}

const Peer& peer_named(const std::vector<Peer>& all, std::string_view name) {
  return *std::find_if(all.begin(), all.end(), [name](const Peer& peer) { return peer.name == name; });
}

// Returns the part of the window with the wrong face, against the exact sweep; nothing where it did not end.
std::optional<double> wrong_share(const Peer& peer, const ProjectedScene& scene) {
  const VisibleSegments segments = find_visible_segments(scene);
  const ExactParts exact = exact_parts(scene, segments, reconstruct_polygons(scene, segments));
  try {
    return errors_of(std::get<VisibleParts>(peer.run(flat_scene(scene), 0).seen), exact).wrong_share;
  } catch (const ArithmeticError&) {
    return std::nullopt;
  }
}

}  // namespace

TEST_CASE("sweep peers err where the stability runs say so, and by as much") {
  const std::vector<Peer> peers = sweep_peers();
  int worse_than_grid = 0;
  for (const char* name : {"needle_width", "depth_gap"}) {
    const ExtremeFamily& family = family_named(name);
    for (const double value : family.values) {
      CAPTURE(name);
      CAPTURE(value);
      const FamilyScene made = family.make(value);
      REQUIRE(made.grid_bits == default_grid_bits);
      const MeshContacts contacts = find_contacts(made.mesh);
      const CutMesh mesh = cut_along_common_lines(Mesh(made.mesh), contacts);
      const ProjectedScene scene = project(mesh, made.camera, Sides::both);
      CHECK(wrong_share(peer_named(peers, "sweep-exact"), scene).value() < 1e-12);
      const StabilityRun run = run_stability(family, value, Arithmetic::single_precision);
      const std::optional<double> in_float = wrong_share(peer_named(peers, "sweep-float"), scene);
      REQUIRE(in_float.has_value() == run.finished);
      if (!in_float) continue;
      // The oracle is not on the grid: each may be off by what the grid explains.
      CHECK(std::abs(*in_float - run.mislabelled_area) <= run.grid_bound + 1e-12);
      worse_than_grid += *in_float > run.grid_bound ? 1 : 0;
    }
  }
  CHECK(worse_than_grid > 0);
}

}  // namespace sightline::tests::peer_sweeps_test
