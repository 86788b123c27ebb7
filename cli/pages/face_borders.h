// Which edges of the refined triangles are pieces of the edges of their faces.
//
// In:  a labelled mesh. Out: per triangle three bits: bit i is the edge from corner i to the next one.
// Holds: what lies between two triangles of one face is not on its border.
// Complexity: O(n log k) for faces of k triangles.
#pragma once

#include <cstdint>
#include <vector>

#include "reconstruct/labelling/labelled_mesh.h"

namespace sightline::cli {

[[nodiscard]] std::vector<std::uint8_t> face_borders(const LabelledMesh& labelled);

}  // namespace sightline::cli
