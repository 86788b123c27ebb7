// What the same scene costs the rivals.
//
// In:  a scene, limits.
// Out: figures, in seconds of processor time; `not_installed`, or `unknown` where rivals are not wanted.
// Holds: each run is in a process of its own.
// Complexity: of the rivals, once per run. Errors: std::runtime_error where the scene cannot be written for a rival that
//      reads it; an error of a rival makes its figure `failed`.
#pragma once

#include "bench/figure.h"
#include "bench/side_by_side_scenes.h"

namespace sightline::bench {

struct RivalFigures {
  Figure parse;
  Figure sort;
  Figure embree_hierarchy;
  Figure embree_rays;
  Figure embree;  // both
  Figure gl2ps;
};

[[nodiscard]] RivalFigures measure_rivals(const BenchScene& scene, const RunLimits& limits);

struct CgalFigures {
  std::size_t triangles = 0;  // in the image
  Figure envelope;
};

[[nodiscard]] CgalFigures measure_cgal(const BenchScene& scene, const RunLimits& limits);

}  // namespace sightline::bench
