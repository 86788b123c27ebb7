// The report's warnings, one line each: what the reader skipped, faces that interpenetrate, polygons below resolution.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "cli/view_analysis.h"

namespace sightline {

// Pairs of faces that cross, smaller id first; sorted, distinct.
[[nodiscard]] std::vector<std::array<FaceId, 2>> crossing_faces(const MeshInput& input);

// Faces with a visible polygon below resolution; sorted, distinct.
[[nodiscard]] std::vector<FaceId> faces_below_resolution(const VisiblePolygons& polygons);

[[nodiscard]] std::vector<std::string> report_warnings(const MeshInput& input, const View& view);

}  // namespace sightline
