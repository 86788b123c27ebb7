// faces.csv: one row per input face, in file order, index from 0 (columns: see FaceMeasures).
#pragma once

#include <string>
#include <vector>

#include "cli/face_measures.h"

namespace sightline {

[[nodiscard]] std::string faces_table(const std::vector<FaceMeasures>& faces);

}  // namespace sightline
