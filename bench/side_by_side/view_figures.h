// These figures say what one view of a scene costs sightline: time per stage, and memory.
#pragma once

#include "bench/measuring/figure.h"
#include "bench/scenes/side_by_side_scenes.h"
#include "geometry/numbers/arithmetic.h"

namespace sightline::bench {

struct ViewFigures {
  Figure project;
  Figure sweep;
  Figure polygons;
  Figure label;
  Figure sum;
  Figure bytes_per_triangle;
};

// The work refers to the scene.
[[nodiscard]] Work view_work(const BenchScene& scene, Arithmetic arithmetic = Arithmetic::exact);
[[nodiscard]] ViewFigures view_figures(const Outcome& outcome, const RunLimits& limits);

// These say what a square lamp over a terrain costs, all of which is seen from above: the reflection, and the view
// without it.
struct ReflectionFigures {
  Figure reflection;
  Figure visibility;
};

[[nodiscard]] ReflectionFigures measure_reflection(std::size_t triangles, const RunLimits& limits);

}  // namespace sightline::bench
