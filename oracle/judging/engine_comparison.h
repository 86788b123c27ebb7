// The fast engine's segments are compared with those of the sweep of everything.
#pragma once

#include <initializer_list>
#include <string>

#include "sweep/engine.h"

namespace sightline::lattice {

// The tally says how much was swept with one band: with several, some facets are known to more than one sweep.
struct EngineTally {
  std::uint64_t points = 0;  // of the sweep of everything
  std::uint64_t swept = 0;
};

// Compares as the fast engine chooses by itself, and as each of the options says; the result is empty where nothing
// differs.
[[nodiscard]] std::string engine_differences(const ProjectedScene& scene, std::initializer_list<FastOptions> all,
                                             EngineTally& tally);

}  // namespace sightline::lattice
