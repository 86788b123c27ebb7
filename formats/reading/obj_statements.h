// The statements of an OBJ file that make geometry are read here, without a mesh yet; obj_reader.h says what is read
// and refused.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "formats/reading/obj_scanner.h"
#include "geometry/mesh/mesh.h"

namespace sightline::inline formats {

struct ObjStatements {
  std::vector<Point3> vertices;
  PolygonList faces;
  std::vector<Vector3> corner_normals;  // where asked for: parallel to faces.corners, zero where the file gives none
  std::vector<FaceId> faces_with_missing_attributes;  // whose texture or normal indices name nothing
  std::size_t unknown_count = 0;                      // statements with an unknown keyword
  std::size_t unknown_line = 0;                       // the line of the first of them
  std::string unknown_keyword;                        // and its keyword, quoted
};

// A file that needs more is refused at the statement where that shows.
struct ReadLimits {
  std::uint64_t memory = std::numeric_limits<std::uint64_t>::max();  // in bytes; see memory_for_mesh
};

enum class Normals : std::uint8_t { passed_over, read };

// No face has more corners: one that is not convex is triangulated in O(k^2), and a star of so many corners takes a
// quarter of a minute.
constexpr std::size_t most_corners = 10000;

// Returns what it takes to hold the statements, to build a mesh of them, to look for facets that meet, and to project
// it: a measured upper bound (obj_statements.cpp says how) where no more facets meet than there are.
[[nodiscard]] std::uint64_t memory_for_mesh(std::uint64_t vertices, std::uint64_t corners, std::uint64_t faces);

// Takes the text from the scanner, which is at its beginning. Throws InputError.
[[nodiscard]] ObjStatements parse_obj_statements(ObjScanner& scanner, const std::string& file_name,
                                                 const ReadLimits& limits, Normals normals = Normals::passed_over);

}  // namespace sightline::inline formats
