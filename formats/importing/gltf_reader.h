// glTF 2.0, as JSON or as a binary container (GLB): the triangles of the default scene, as a mesh.
//
// In:  the bytes. Buffers are in the file (GLB chunk, base64), or files beside it, by their plain name; no other file is
//      opened.
// Out: the mesh: for every node of the default scene (where there is none: the first scene, or all nodes) and every
//      primitive of its mesh the vertices as they are, and the triangles, in the order of the file. Nothing is joined or
//      reordered, and a mesh that several nodes use is there as often. Positions are floats in the file; the nodes' maps
//      are applied to them in double, so a node that moves nothing keeps them bit for bit. A map that mirrors turns the
//      triangles round, as glTF says. Normals are read and mapped where asked for.
//
// Triangles, strips and fans are read; points and lines are passed over, with a warning. So are skins and morph targets,
// with one: the mesh is there as it is at rest. Materials, textures, cameras, animations are passed over.
//
// What is refused (InputError without a line): other versions; an extension that is required and may say where the
// surface is (Draco, meshopt, instancing); JSON that is none; what leads nowhere (an index, a view beyond its buffer); a
// node in two places; sparse accessors; a coordinate that is not finite; more than the limit on memory allows.
//
// Complexity: O(bytes + triangles), and build_mesh.
// Why not Assimp: its maps are floats. Version 5.2.5, Debian's,
// ends with memory freed twice after a clean public 3MF file. JSON is read by nlohmann's library, which the command has
// anyway; that is why this is a part of the command, not of the library.
#pragma once

#include <string>
#include <string_view>

#include "formats/importing/gltf_document.h"
#include "formats/reading/mesh_file.h"
#include "formats/reading/read_limits.h"

namespace sightline::inline formats {

[[nodiscard]] MeshFile read_gltf(std::string_view bytes, const std::string& file_name, const FileBeside& file_beside,
                                 const ReadLimits& limits, Normals normals);

}  // namespace sightline::inline formats
