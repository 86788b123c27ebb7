// OFF (Geomview): vertices, and faces as lists of them, in text.
//
// In:  the bytes: [ST][C][N]OFF, the numbers of vertices, faces and (which may be missing) edges, then a line for each
//      vertex and each face. A comment goes from `#` to the end of its line.
// Out: the mesh, with every coordinate the correctly rounded double of what the file says; the normals of NOFF, where
//      asked for. Colours and texture coordinates are passed over; faces may have colours (up to 4 numbers) in any OFF.
//
// What is refused (InputError with the line): OFF in binary, of another dimension (4OFF, nOFF); a count or an index that
// is no integer, negative, or names no vertex; a coordinate that is no number, not finite, or beyond the range of double;
// a line of a vertex or face with more numbers than it may have, since they may be another vertex; a file that ends
// before its last face; a face of more than 10 000 corners; more vertices and faces than the limit on memory allows,
// before they are read.
//
// Complexity: O(bytes), and build_mesh.
// Why not a library: Assimp holds floats, and takes a count that is too large for the truth.
#pragma once

#include "formats/reading/input_bytes.h"
#include "formats/reading/mesh_file.h"
#include "formats/reading/read_limits.h"

namespace sightline::inline formats {

// Returns whether a file that begins so is OFF of any kind, whether it is read or refused.
[[nodiscard]] bool is_off_keyword(std::string_view token);

[[nodiscard]] MeshFile read_off(InputBytes& in, const ReadLimits& limits, Normals normals);

}  // namespace sightline::inline formats
