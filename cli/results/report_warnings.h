// The report's warnings, one line each: what the reader skipped, polygons below resolution; and lists of faces.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "cli/analyze/view_analysis.h"

namespace sightline::cli {

// Pairs of faces that pass through each other, smaller id first; sorted, distinct. The mesh is cut along common lines.
[[nodiscard]] std::vector<std::array<FaceId, 2>> crossing_faces(const CutMesh& mesh);

// Faces with a visible polygon below resolution; sorted, distinct.
[[nodiscard]] std::vector<FaceId> faces_below_resolution(const VisiblePolygons& polygons);

[[nodiscard]] std::vector<std::string> report_warnings(const MeshInput& input, const View& view);

}  // namespace sightline::cli
