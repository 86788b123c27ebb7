// The whole path runs on one scene, and is held against the oracle and against every stage's own checker.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "oracle/lattice/oracle.h"
#include "oracle/scenes/random_scenes.h"
#include "sightline/analyzer.h"

namespace sightline::lattice {

using Complaints = std::vector<std::string>;

// Returns the mesh cut along the common lines of its facets.
[[nodiscard]] CutMesh cut(const Mesh& mesh);

// Returns what the checkers of all stages say, each line with the stage in front.
[[nodiscard]] Complaints complaints_of_stages(const View& view);

// Returns the exact visible area per face, in grid units squared: its polygons together.
[[nodiscard]] std::vector<Rational> visible_areas(const View& view);

// Returns how much a visible area may differ from the truth, in window units squared: it is bounded by the scene's
// edges, and rounding moves every end of an edge by at most half a spacing of the grid per axis, less than one spacing
// in all. So no area is off by more than the length of all edges times the spacing.
[[nodiscard]] double rounding_bound(const ProjectedScene& scene);

// Returns the window's area in grid units squared.
[[nodiscard]] Rational window_area(int grid_bits);

struct Verdict {
  Complaints complaints;
  SweepStatistics statistics;
  Degeneracy degeneracy;
};

// Returns every difference between sightline and the oracle. An exception that sightline throws is a complaint.
[[nodiscard]] Verdict judge(const RandomScene& scene);

// Returns the scene without the faces (and then vertices) that are not needed for `fails` to stay true.
[[nodiscard]] RandomScene reduced(RandomScene scene, const std::function<bool(const RandomScene&)>& fails);

// Returns how many random scenes a test looks at: `full`, or less where the environment variable
// SIGHTLINE_RANDOM_SCENES says so (for builds with sanitizers).
[[nodiscard]] std::uint64_t scene_count(std::uint64_t full);

[[nodiscard]] std::string joined(const Complaints& complaints);

}  // namespace sightline::lattice
