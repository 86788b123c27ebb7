// report.json: what was analysed, how, what came out, what it cost.
//
// Equal between runs except for times_s and peak_memory_bytes. Lengths and areas in input units, image areas in the
// window
// [-1, 1]^2. A number beyond the range of double is null.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "cli/analyze/view_analysis.h"
#include "cli/results/face_measures.h"
#include "cli/scene/scene.h"

namespace sightline::cli {

using Report = nlohmann::ordered_json;

// faces: measure_faces(analysis.view). write_seconds: for the other files.
[[nodiscard]] Report make_report(const Scene& scene, const MeshInput& input, const ViewAnalysis& analysis,
                                 const std::vector<FaceMeasures>& faces, double write_seconds);

// Indented, with a line end; bytes that are not UTF-8 (in file names) are replaced.
[[nodiscard]] std::string report_text(const Report& report);

}  // namespace sightline::cli
