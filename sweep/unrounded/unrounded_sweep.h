// The sweep without rounding: what of every facet is seen, where it is seen, with facets that pass through each other.
//
// In:  an unrounded scene (Arithmetic::unrounded); its depth ranges.
// Out: VisibleSegments as the sweep of everything gives them (plain/sweep.h), with swap edges, along which two surfaces change
//      places.
// Holds: what holds of visible segments. The visible parts are exactly those of the input: tests hold their areas to the truth
//      in rationals (tests/sweep/unrounded_test.cpp).
// Complexity: that of the sweep of everything; integers of any size where a filter does not decide (unrounded_image.h).
// Source: docs/unrounded.md; Fang 1993, appendix B, for the sweep.
#pragma once

#include <span>

#include "sweep/plain/sweep.h"
#include "sweep/segments/unrounded_image.h"

namespace sightline::inline sweep {

[[nodiscard]] VisibleSegments unrounded_sweep(const ProjectedScene& scene, std::span<const DepthRange> depths,
                                              SweepObserver* observer = nullptr, UnroundedCounts* counts = nullptr);

}  // namespace sightline::inline sweep
