// labelled.obj has the refined surface with one group per label, for tools that read no PLY properties. Triangles that
// mirror panels are in groups of their own: "g visible reflecting_NAME ...".
//
// Vertices are as in labelled.ply, exact decimals; triangles are sorted by label, then by input face.
#pragma once

#include <string>
#include <vector>

#include "formats/writing/text_buffer.h"
#include "geometry/numbers/export.h"
#include "reconstruct/labelling/labelled_mesh.h"

namespace sightline::inline formats {

SIGHTLINE_EXPORT void write_labelled_obj(const LabelledMesh& labelled, const std::vector<std::string>& panels,
                                         TextBuffer& out);

}  // namespace sightline::inline formats
