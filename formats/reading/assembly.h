// Several meshes, each placed, as one.
//
// In:  what their files hold, the name and the placement of each.
// Out: one mesh: vertices and faces numbered on in order. Each face is in the mesh's region of its own part; where a file names no
//      objects, its faces are in one object of the mesh's name. Warnings are those of the files, which count faces within their
//      file, and one for each kind of thing that is skipped or mended here but was not in its own file (copies of a face of
//      another mesh; faces that a placement flattens), which counts as the scene does.
// Holds: one part that is not moved and has no name is left as it is.
// Complexity: that of build_mesh.
// Errors: PlacementError; InputError where all of it needs more memory than the limit allows.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "formats/reading/mesh_file.h"
#include "formats/reading/read_limits.h"
#include "geometry/mesh/placement.h"

namespace sightline::inline formats {

struct MeshPart {
  std::string file_name;  // for messages
  std::string name;       // empty only where there is one part
  Placement placement;
  MeshFile file;
};

[[nodiscard]] MeshFile assembled(std::vector<MeshPart> parts, const ReadLimits& limits = {});

// Returns the mesh without these faces (1 per face that is left out): they keep their numbers and have no corners, so that they
// are neither seen nor in the way of anything.
[[nodiscard]] MeshFile without_faces(MeshFile mesh, const std::vector<std::uint8_t>& left_out);

}  // namespace sightline::inline formats
