// The tables and pictures of one view, as files of its camera's folder: all but report.json.
//
// In:  a view, and what was measured of it.
// Out: files in the folder of the camera's name.
// Complexity: of the files' sizes. Errors: OutputError.
#pragma once

#include <string>
#include <vector>

#include "cli/results/face_measures.h"
#include "cli/system/result_folders.h"
#include "sightline/view.h"

namespace sightline::cli {

// places: window_points(view).
void write_view_files(ResultFolders& results, const View& view, const std::vector<std::string>& panels,
                      const std::vector<FaceMeasures>& faces, const std::vector<Point2>& places);

}  // namespace sightline::cli
