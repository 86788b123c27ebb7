// Visible segments, by the sweep of everything or of what a scene requires.
//
// In:  as the sweep (sweep.h), and which engine.
// Out: the same VisibleSegments from both, but for the statistics, which count what was swept.
//   - full: the sweep of all facets in view.
//   - fast: facets that covers hide are left out; those that nothing else comes near are seen whole; the others are
//     swept, in bands of the image, by all threads of the calling task arena (oneTBB). It needs exact arithmetic;
//     without, all is swept.
// An observer is called for all bands, by one thread at a time, and sees their points in no order of its own.
// Complexity: O(n log n), the pairs of a facet and a cell that it touches, and the sweep of what is left.
// Errors: as the sweep.
// Source: docs/design.md, section 8.
#pragma once

#include <cstdint>
#include <optional>

#include "geometry/numbers/export.h"
#include "sweep/plain/sweep.h"

namespace sightline::inline sweep {

enum class Engine : std::uint8_t { fast, full };

[[nodiscard]] SIGHTLINE_EXPORT VisibleSegments find_visible_segments(const ProjectedScene& scene,
                                                                     Engine engine = Engine::fast,
                                                                     SweepObserver* observer = nullptr);

// The fast engine chooses these by itself; the result does not depend on them.
struct FastOptions {
  std::optional<int> level;          // 2^level cells along each side of the window
  std::optional<std::size_t> bands;  // that are swept in parallel
};
[[nodiscard]] SIGHTLINE_EXPORT VisibleSegments fast_visible_segments(const ProjectedScene& scene,
                                                                     const FastOptions& options,
                                                                     SweepObserver* observer = nullptr);

}  // namespace sightline::inline sweep
