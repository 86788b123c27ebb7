// This checks what must hold of a mesh that was cut along common lines, beyond what holds of the mesh before
// (Mesh::cuts).
#pragma once

#include <string>
#include <vector>

#include "geometry/mesh/cut_mesh.h"

namespace sightline::inline geometry {

void check_cuts(const CutMesh& mesh, std::vector<std::string>& messages);

}  // namespace sightline::inline geometry
