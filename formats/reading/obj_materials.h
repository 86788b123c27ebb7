// What the MTL files of an OBJ file say of its materials; obj_reader.h says which files are opened.
#pragma once

#include <string>
#include <vector>

#include "formats/reading/obj_reader.h"
#include "formats/reading/obj_statements.h"

namespace sightline::inline formats {

// Returns whether it is the name of a file in the folder of the one that names it, on any system.
[[nodiscard]] bool is_plain_file_name(std::string_view name);

// Gives the regions that are materials what the libraries say of them, the first one that defines a name. Appends a warning, with
// the mesh's name, for each library that is missing or refused, and one for materials that none of them defines.
void find_materials(FaceRegions& regions, const std::vector<MaterialLibraries>& libraries, const FilesBeside& beside,
                    const std::string& mesh_name, std::vector<std::string>& warnings);

// The files in a folder. Links to regular files count as files.
[[nodiscard]] FilesBeside files_in_folder(const std::filesystem::path& folder);

}  // namespace sightline::inline formats
