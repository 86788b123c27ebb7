// What one view of a scene costs sightline: time per stage, and memory.
//
// In:  a scene, the arithmetic, limits.
// Out: figures, in seconds of processor time. Memory is the peak above what the mesh holds before the first stage, per
//      facet.
// Holds: each run is in a process of its own, so none finds memory that an earlier one has left.
// Complexity: of the stages, once per run. Errors: none; an error of a stage makes the figures `failed`.
#pragma once

#include "bench/figure.h"
#include "bench/side_by_side_scenes.h"
#include "geometry/arithmetic.h"

namespace sightline::bench {

struct ViewFigures {
  Figure project;
  Figure sweep;
  Figure polygons;
  Figure label;
  Figure sum;
  Figure bytes_per_triangle;
};

[[nodiscard]] ViewFigures measure_view(const BenchScene& scene, const RunLimits& limits,
                                       Arithmetic arithmetic = Arithmetic::exact);

// What a square lamp over a terrain costs, all of which is seen from above: the reflection, and the view without it.
struct ReflectionFigures {
  Figure reflection;
  Figure visibility;
};

[[nodiscard]] ReflectionFigures measure_reflection(std::size_t triangles, const RunLimits& limits);

}  // namespace sightline::bench
