// A mesh from a file of any format that the command reads: those of the library (mesh_reader.h), glTF, and 3MF where it
// is built with Expat.
//
// In:  the path of a file, or its bytes. The first bytes tell what it is (mesh_format.h). glTF may keep its numbers in
//      files beside it, which are opened by their plain name; none is for bytes.
// Out: the mesh, and what its reader has to say of it.
// Errors: InputError (see the readers).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "formats/reading/mesh_file.h"
#include "formats/reading/read_limits.h"

namespace sightline::inline formats {

[[nodiscard]] MeshFile import_mesh(const std::filesystem::path& file, const ReadLimits& limits, Normals normals);

// file_name is for messages.
[[nodiscard]] MeshFile import_mesh(std::string_view bytes, const std::string& file_name, const ReadLimits& limits,
                                   Normals normals);

}  // namespace sightline::inline formats
