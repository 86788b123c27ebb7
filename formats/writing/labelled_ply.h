// labelled.ply has the refined surface as binary little-endian PLY.
//
// vertex: double x, y, z (the first ones are the input's, in order). face: list uchar int vertex_indices, then int face
// (the input face), uchar label (see Label), uchar seen (1: the camera sees it), and per panel uchar reflecting_NAME
// (1: it mirrors the panel into the camera).
#pragma once

#include <string>
#include <vector>

#include "formats/writing/text_buffer.h"
#include "geometry/numbers/export.h"
#include "reconstruct/labelling/labelled_mesh.h"

namespace sightline::inline formats {

SIGHTLINE_EXPORT void write_labelled_ply(const LabelledMesh& labelled, const std::vector<std::string>& panels,
                                         TextBuffer& out);

}  // namespace sightline::inline formats
