// The part of a facet outside the view volume, in triangles.
//
// In:  a facet that crosses the view volume's border, and the points that split its line along that border.
// Out: triangles in the facet's orientation, which together with the facet's part in view cover it. The corners are
//      exact points (the clipping is done again, in integers), so the triangulation is exact; the splits are put on
//      the sides of its triangles afterwards, by their order alone.
// Complexity: O(c log c) big-integer operations for c corners.
#pragma once

#include <array>
#include <vector>

#include "reconstruct/labelling/facet_border.h"

namespace sightline::inline reconstruct {

[[nodiscard]] std::vector<std::array<VertexId, 3>> outside_triangles(const LabelSources& from, FacetId facet,
                                                                     std::span<const EdgeSplit> splits_of_view_border,
                                                                     InnerVertices& inner);

}  // namespace sightline::inline reconstruct
