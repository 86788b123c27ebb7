// Visible segments, by the sweep of everything or of what a scene requires.
//
// In:  as the sweep (sweep.h), and which engine.
// Out: the same VisibleSegments from both, but for the statistics, which count what was swept.
//   - full: the sweep of all facets in view.
//   - fast: facets that covers hide are left out; patches that no contour edge comes near are seen whole or not at all,
//     which the sweep of the others tells. It needs the mesh's contacts (Mesh::touched; cut_along_common_lines) and
//     exact arithmetic; without, all is swept. So it is where depths turn out not to be transitive (sweep.h): what is
//     seen there depends on all facets.
// Complexity: O(n log n) and the sweep of what is left: of a smooth surface, some square root of n.
// Errors: as the sweep.
// Source: DESIGN.md section 8.
#pragma once

#include <cstdint>

#include "sweep/sweep.h"

namespace sightline {

enum class Engine : std::uint8_t { fast, full };

[[nodiscard]] VisibleSegments find_visible_segments(const Mesh& mesh, const ProjectedScene& scene,
                                                    Engine engine = Engine::fast, SweepObserver* observer = nullptr);

// The fast engine with a grid of 2^level cells along each side of the window: the result does not depend on it.
[[nodiscard]] VisibleSegments fast_visible_segments(const Mesh& mesh, const ProjectedScene& scene, int level,
                                                    SweepObserver* observer = nullptr);

}  // namespace sightline
