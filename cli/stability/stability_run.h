// One scene in one arithmetic, held against the oracle.
//
// In:  a scene of a family. Out: StabilityRun, equal in every run but for `seconds`.
// Areas are parts of the window, from 0 to 1.
// grid_bound: what rounding the image's points to the grid can explain of mislabelled_area. Every point moves by at most
//      d = sqrt(1/2) of the grid's spacing s (s/2 in x and in y), and with its ends every edge; while all move, a place's
//      cover changes only where an edge passes over it, and depth is not rounded. An edge of length l sweeps at most (l +
//      2 d) d. So the wrong area is at most the sum of (l + 2 d) d over the true edges; l is at most the rounded edge's
//      length + 2 d.
// Errors: none of sightline's; those of the run are in it.
#pragma once

#include <array>
#include <string>

#include "cli/scene/extreme_families.h"
#include "geometry/numbers/arithmetic.h"

namespace sightline::cli {

inline constexpr std::array arithmetics{Arithmetic::single_precision, Arithmetic::double_precision, Arithmetic::exact};

struct StabilityRun {
  double value = 0;  // of the family's parameter
  Arithmetic arithmetic = Arithmetic::exact;
  int grid_bits = default_grid_bits;
  std::size_t faces = 0;
  bool finished = false;        // there are visible polygons
  std::string broken;           // the first invariant that does not hold, with its stage; empty: valid
  double area_error = 0;        // sum over faces of |visible area - true visible area|
  double mislabelled_area = 0;  // where the window shows another face than the one it should
  double grid_bound = 0;
  double seconds = 0;  // projection, sweep and polygons, the fastest of some
};

[[nodiscard]] StabilityRun run_stability(const ExtremeFamily& family, double value, Arithmetic arithmetic);

}  // namespace sightline::cli
