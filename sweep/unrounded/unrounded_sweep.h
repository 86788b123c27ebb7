// The sweep without rounding: what of every facet is seen, where it is seen, with facets that pass through each other.
//
// In:  an unrounded scene.
// Out: VisibleSegments as the sweep of everything gives them (plain/sweep.h), but that edges whose ids follow those of the
//      scene are swap edges, along which two surfaces change places; and the exact places of its points.
// Holds: what holds of visible segments. The visible parts are exactly those of the input: tests hold their areas to the truth
//      in rationals (tests/sweep/unrounded_test.cpp).
// Complexity: that of the sweep of everything; integers of any size where a filter does not decide (unrounded_decider.h).
// Source: docs/design.md, section 9; Fang 1993, appendix B, for the sweep.
#pragma once

#include <memory>

#include "sweep/segments/visible_segments.h"
#include "sweep/unrounded/unrounded_decider.h"

namespace sightline::inline sweep {

// The scene outlives it, and stays where it is.
struct UnroundedSegments {
  VisibleSegments segments;
  std::unique_ptr<UnroundedDecider> decider;  // knows the swap edges
  std::size_t vertex_count = 0;

  [[nodiscard]] ExactPlace exact(PointId p) const;
  [[nodiscard]] std::array<double, 2> in_window(PointId p) const;
  [[nodiscard]] const CertifiedPlace& certified(PointId p) const;

 private:
  [[nodiscard]] UnroundedDecider::Place crossing(PointId p) const;
};

[[nodiscard]] UnroundedSegments unrounded_sweep(const UnroundedScene& scene);
UnroundedSegments unrounded_sweep(UnroundedScene&&) = delete;

}  // namespace sightline::inline sweep
