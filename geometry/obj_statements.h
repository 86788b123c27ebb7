// The statements of an OBJ file that make geometry, without a mesh yet; obj_reader.h says what is read and refused.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/mesh.h"

namespace sightline {

struct ObjStatements {
  std::vector<Point3> vertices;
  PolygonList faces;
  std::vector<FaceId> faces_with_missing_attributes;  // whose texture or normal indices name nothing
  std::size_t unknown_count = 0;                      // statements with an unknown keyword
  std::size_t unknown_line = 0;                       // the line of the first of them
  std::string unknown_keyword;                        // and its keyword, quoted
};

// Throws InputError.
[[nodiscard]] ObjStatements parse_obj_statements(std::string_view text, const std::string& file_name);

}  // namespace sightline
