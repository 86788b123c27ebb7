// OBJ from bytes that somebody else has opened; obj_reader.h says what is read and refused.
#pragma once

#include "formats/reading/obj_reader.h"
#include "formats/reading/obj_scanner.h"

namespace sightline::inline formats {

[[nodiscard]] MeshFile read_obj(ByteSource bytes, const std::string& file_name, const ReadLimits& limits,
                                Normals normals, const FilesBeside& beside);

}  // namespace sightline::inline formats
