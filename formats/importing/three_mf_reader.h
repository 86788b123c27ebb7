// 3MF: the triangles of the objects that are to be built, as a mesh.
//
// In:  the bytes of the package, a ZIP archive; the part in it that _rels/.rels names as the 3D model.
// Out: the mesh: for every item of <build> the object it names, with its components, where their transforms place them;
//      each time with vertices of its own. Coordinates and transforms are the correctly rounded doubles of what the file
//      says, and are multiplied in double: what is not moved keeps them bit for bit. A transform that mirrors turns the
//      triangles round. Units stay those of the file.
//
// Materials, colours, textures, metadata, slices and beams are passed over.
//
// What is refused (InputError without a line; the cause has the line of the model): an archive or XML that is damaged or
// encrypted; objects in other parts of the package (production extension), and other extensions that the model requires;
// an index or object id that names nothing before it; a coordinate that is no number or not finite; more than a million
// placed objects; more than the limit on memory allows.
//
// Complexity: O(bytes + triangles), and build_mesh.
// Why not Assimp: it holds floats, where the file has decimals, and Debian's 5.2.5 frees memory twice after reading a
// clean public file. The archive is unpacked by zlib, the XML read by Expat, both while they come: this is a part of the
// command, and needs Expat to be there when it is built.
#pragma once

#include <string>
#include <string_view>

#include "formats/reading/mesh_file.h"
#include "formats/reading/read_limits.h"

namespace sightline::inline formats {

[[nodiscard]] MeshFile read_three_mf(std::string_view bytes, const std::string& file_name, const ReadLimits& limits,
                                     Normals normals);

}  // namespace sightline::inline formats
