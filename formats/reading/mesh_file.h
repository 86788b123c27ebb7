// What a file of a mesh holds, whatever its format.
#pragma once

#include <string>
#include <vector>

#include "formats/reading/face_regions.h"
#include "geometry/mesh/mesh.h"

namespace sightline::inline formats {

struct MeshFile {
  Mesh mesh;
  std::vector<Vector3> corner_normals;  // where asked for: parallel to mesh.faces.corners, zero where none is given
  FaceRegions regions;                  // per face of mesh.faces; empty where the format has none
  std::vector<std::string> warnings;    // "FILE: what", one line each
};

}  // namespace sightline::inline formats
