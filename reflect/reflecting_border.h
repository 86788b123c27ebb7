// The borders of reflecting polygons as visible segments, ready for reconstruction and labelling.
//
// In:  the merged scene, and the numbered segments of each surface's border.
// Out: segments in sweep order with the threads from their holes (Fang 5.3), and the places where they split mesh
//      edges.
// Complexity: O(m log m), and O(m) more per hole, for m segments.
#pragma once

#include <span>

#include "geometry/mesh/cut_mesh.h"
#include "reflect/merged_scene.h"

namespace sightline::inline reflect {

struct SurfaceSegment {
  FacetId surface;
  NumberedSegment segment;
};

[[nodiscard]] VisibleSegments reflecting_segments(const MergedScene& merged, std::vector<SurfaceSegment> segments);

// Gives the reflecting segments their splits, which are where their ends lie strictly inside edges of their own
// surface, which the labelled surface must split for all faces on them. `visible` has the view's visible segments, on
// whose edges these ends can lie.
void find_splits(VisibleSegments& reflecting, const ProjectedScene& scene, const VisibleSegments& visible);

}  // namespace sightline::inline reflect
