// A mesh from a file of any format that is read here.
//
// In:  the path of a file. Its first bytes tell what it is, not its name.
// Out: the mesh, and what its reader has to say of it; the header of each reader says what it reads, mends, skips, refuses.
// Errors: InputError (see the readers).
#pragma once

#include <filesystem>

#include "formats/reading/mesh_file.h"
#include "formats/reading/read_limits.h"
#include "geometry/numbers/export.h"

namespace sightline::inline formats {

[[nodiscard]] SIGHTLINE_EXPORT MeshFile read_mesh(const std::filesystem::path& file, const ReadLimits& limits = {},
                                                  Normals normals = Normals::passed_over);

}  // namespace sightline::inline formats
