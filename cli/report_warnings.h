// The report's warnings, one line each: what the reader skipped, faces that interpenetrate, polygons below resolution.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "cli/view_analysis.h"

namespace sightline {

// Pairs of faces that interpenetrate, smaller id first; sorted, distinct: those that cross, and those that the sweep
// saw before each other in both orders.
[[nodiscard]] std::vector<std::array<FaceId, 2>> interpenetrating_faces(const MeshInput& input, const View& view);

// Faces with a visible polygon below resolution; sorted, distinct.
[[nodiscard]] std::vector<FaceId> faces_below_resolution(const VisiblePolygons& polygons);

[[nodiscard]] std::vector<std::string> report_warnings(const MeshInput& input, const View& view);

}  // namespace sightline
