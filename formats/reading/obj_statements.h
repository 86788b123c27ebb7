// The statements of an OBJ file that make geometry are read here, without a mesh yet; obj_reader.h says what is read
// and refused.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "formats/reading/face_regions.h"
#include "formats/reading/obj_scanner.h"
#include "formats/reading/read_limits.h"
#include "geometry/mesh/mesh.h"

namespace sightline::inline formats {

// A mtllib statement: the names of files, which a blank separates; or they are one name with blanks.
struct MaterialLibraries {
  std::vector<std::string> names;
  std::size_t line = 0;
};

struct ObjStatements {
  std::vector<Point3> vertices;
  PolygonList faces;
  std::vector<Vector3> corner_normals;  // where asked for: parallel to faces.corners, zero where the file gives none
  std::vector<FaceId> faces_with_missing_attributes;  // whose texture or normal indices name nothing
  FaceRegions regions;
  std::vector<std::string> region_limits;  // one line for each limit on regions that was met
  std::vector<MaterialLibraries> libraries;
  std::size_t unknown_count = 0;  // statements with an unknown keyword
  std::size_t unknown_line = 0;   // the line of the first of them
  std::string unknown_keyword;    // and its keyword, quoted
};

// Takes the text from the scanner, which is at its beginning. Throws InputError.
[[nodiscard]] ObjStatements parse_obj_statements(ObjScanner& scanner, const std::string& file_name,
                                                 const ReadLimits& limits, Normals normals = Normals::passed_over);

}  // namespace sightline::inline formats
