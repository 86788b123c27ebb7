// PLY (Stanford), in text and in binary of both byte orders: the vertices and faces of a file, as a mesh.
//
// In:  the bytes. Of the element `vertex` the properties x, y, z are read, and nx, ny, nz where normals are asked for; of
//      the element `face` the list vertex_indices (or vertex_index). Types have their old or new names (uchar, uint8).
// Out: the mesh. A number in text is the correctly rounded double of what the file says, whatever its property's type; a
//      double or float in binary is kept as it is, an integer is exact.
//
// All other elements and properties are passed over, lists too (colours, labels, texture coordinates, edges), and so is
// what follows the last element, and in text what a line has more than the header declares, with a warning. A file without faces is an empty scene, with a warning. So sightline
// reads its own labelled.ply back.
//
// What is refused (InputError, with the line in text and in the header, with the byte in binary data): triangle strips
// (tristrips); a header that is not as PLY 1.0 says, has no vertices, or vertices without x, y, z, or faces without
// their list; a file that ends before its last element;
// an index that names no vertex; a coordinate that is no number, not finite, or beyond the range of double; a face of
// more than 10 000 corners; more vertices and faces than the limit on memory allows, before they are read.
//
// Complexity: O(bytes), and build_mesh.
// Why not a library: Assimp holds floats; miniply, happly and tinyply are not in Debian, and none of them refuses all of this.
#pragma once

#include "formats/reading/input_bytes.h"
#include "formats/reading/mesh_file.h"
#include "formats/reading/read_limits.h"

namespace sightline::inline formats {

[[nodiscard]] MeshFile read_ply(InputBytes& in, const ReadLimits& limits, Normals normals);

}  // namespace sightline::inline formats
