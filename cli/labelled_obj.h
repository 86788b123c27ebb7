// labelled.obj: the refined surface with one group per label, for tools that read no PLY properties.
//
// Vertices as in labelled.ply, exact decimals; triangles by label, then by input face.
#pragma once

#include <string>

#include "reconstruct/labelled_mesh.h"

namespace sightline {

[[nodiscard]] std::string labelled_obj(const LabelledMesh& labelled);

}  // namespace sightline
