// A mesh from a file of any format that is read here: OBJ, STL, PLY, OFF.
//
// In:  the path of a file, or its bytes. The first bytes tell what it is, not the name (mesh_format.h).
// Out: the mesh, and what its reader has to say of it; the header of each reader says what it reads, mends, skips, refuses.
// Errors: InputError (see the readers); for files of other formats it names the format and says what to do. glTF and 3MF
//         are such for the library: the command reads them (formats/importing).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "formats/reading/mesh_file.h"
#include "formats/reading/read_limits.h"
#include "geometry/numbers/export.h"

namespace sightline::inline formats {

[[nodiscard]] SIGHTLINE_EXPORT MeshFile read_mesh(const std::filesystem::path& file, const ReadLimits& limits = {},
                                                  Normals normals = Normals::passed_over);

// Reads the same from bytes in memory; file_name is for messages.
[[nodiscard]] SIGHTLINE_EXPORT MeshFile read_mesh(std::string_view bytes, const std::string& file_name,
                                                  const ReadLimits& limits = {},
                                                  Normals normals = Normals::passed_over);

}  // namespace sightline::inline formats
