// faces.csv: one row per input face, in file order, index from 0 (columns: see FaceMeasures).
#pragma once

#include <string>
#include <vector>

#include "cli/face_measures.h"
#include "cli/text_buffer.h"

namespace sightline {

// panels: their names; per panel a column reflecting_area:NAME.
void write_faces_table(const std::vector<FaceMeasures>& faces, const std::vector<std::string>& panels, TextBuffer& out);

}  // namespace sightline
