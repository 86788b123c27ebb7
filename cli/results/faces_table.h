// faces.csv: one row per input face, in file order, index from 0 (columns: see FaceMeasures).
#pragma once

#include <string>
#include <vector>

#include "cli/results/face_measures.h"
#include "formats/writing/text_buffer.h"

namespace sightline::cli {

// panels: their names; per panel a column reflecting_area:NAME.
void write_faces_table(const std::vector<FaceMeasures>& faces, const std::vector<std::string>& panels, TextBuffer& out);

}  // namespace sightline::cli
