// The sweep: projected scene in, visible segments out.
//
// In:  a mesh whose facets do not pass through each other (cut_along_common_lines), its projected scene, and optionally
//      an observer.
// Out: VisibleSegments (see there for what holds). Where facets overlap in the rounded image only, their order may be
//      no order; the topmost facet of a span depends on nothing but the span's facets (node_list.h), so that every ring
//      closes all the same. The same holds, with the wrong facet on top in places, for facets that pass through each
//      other.
//      In float and double (scene.arithmetic) the sweep's decisions may contradict each other. It then ends with an
//      ArithmeticError, or with a result of which `validate` may complain, but whose points all have a place. It ends:
//      two edges swap at most once, since below a common point their slopes decide, and slopes are numbers.
// Complexity: O((n + k) (log n + d)) for n edges, k crossings and d facets over one point of the image.
// Errors: InternalError where an invariant of the sweep does not hold, with the sweep point; in float and double
//      ArithmeticError instead.
// Source: Fang 1993, section 5.3.1 and appendix B; Sechrest and Greenberg 1982; Nurmi 1985.
#pragma once

#include "geometry/mesh/cut_mesh.h"
#include "geometry/numbers/export.h"
#include "geometry/projection/projected_scene.h"
#include "sweep/plain/depth_ranges.h"
#include "sweep/segments/visible_segments.h"

namespace sightline::inline sweep {

class SweepState;

// An observer is called at every sweep point, after it has been worked off. Teaching, tracing, progress and statistics
// hang on it.
class SIGHTLINE_EXPORT SweepObserver {
 public:
  virtual ~SweepObserver() = default;

  struct SweepPoint {
    PointId vertex;  // valid where a vertex lies here
    double x = 0;    // in the window's units, rounded
    double y = 0;
    std::size_t crossings = 0;    // pairs of edges that were found to cross here
    std::size_t points_done = 0;  // of the scene's points
  };
  virtual void on_point(const SweepPoint& point) = 0;

  // A sweep of everything calls this after `on_point`, for whoever wants to see more (sweep_state.h). The fast engine's bands
  // are parts of the scene, and are not shown.
  virtual void on_state(const SweepState& /*state*/) {}
};

[[nodiscard]] SIGHTLINE_EXPORT VisibleSegments plain_sweep(const ProjectedScene& scene,
                                                           SweepObserver* observer = nullptr);

// depths: as depth_ranges(scene) gives them for the facets in view, where they are known already.
[[nodiscard]] SIGHTLINE_EXPORT VisibleSegments plain_sweep(const ProjectedScene& scene,
                                                           std::span<const DepthRange> depths, SweepObserver* observer);

}  // namespace sightline::inline sweep
