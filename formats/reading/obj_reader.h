// Wavefront OBJ: the vertices and faces of a file, as a mesh.
//
// In:  the statements `v x y z` and `f v[/[vt][/[vn]]] ...`, and `vn x y z` where normals are asked for; `o`, `g`, `usemtl` and
//      `s`, which say what regions faces are in, and `mtllib`; everything else is passed over.
// Out: the mesh, with every coordinate the correctly rounded double of what the file says; its regions (face_regions.h), with
//      what MTL files say of materials (mtl_reader.h); and one line for each kind of thing that was skipped or mended (ids
//      are face indices from 0).
//
// Of other files only those are opened that mtllib names and that are beside the mesh: regular files, called by a plain name,
// which has no slash or backslash and is not `..`. One that is missing, too large or called otherwise is a warning; geometry
// never depends on it.
//
// What is refused (InputError with file and line): an index that is no integer, is 0, or names no vertex; a coordinate
// that is missing, no decimal number (a hexadecimal one is none), not finite, or beyond the range of double; UTF-16
// text; a file in which no statement has an OBJ keyword; a file that cannot be read; a word of more than 2^20 bytes, a
// face of more than 10 000 corners (see most_corners), more statements than the limit on memory allows. Lines may be of
// any length: the file is read in portions of 1 MiB, and what is held of it are its vertices and faces.
//
// What is skipped, counted and listed in a warning: faces with a Defect (see mesh.h); statements with a keyword that is
// none, or that describes geometry not read here (curves, surfaces, call, fo), so also binary or NUL bytes outside v
// and f. Texture and normal indices must be integers; one that names nothing (above its face) is a warning. Only where
// normals are asked for does it matter what a `vn` says: then its numbers are read like those of `v`.
//
// Chosen where readers differ:
//   - A positive index may name a vertex that follows further down (it means the same wherever the face stands). A
//     negative one counts back from the vertices above it.
//   - Columns of v after the third (w, colours) are not looked at.
//   - Keywords are lower case, and end at a blank: `V`, `F`, `v1` are unknown keywords.
//   - `o` and `usemtl` take the rest of their line as one name, `g` each word as a group. Where mtllib has several words, they
//     are one name with blanks if there is a file called so, else a name each.
//   - A backslash at the end of a line continues the statement on the next line, and separates like a blank. It does
//     not continue a comment.
//   - A file without faces is an empty scene, with a warning.
//
// Complexity: O(bytes), and build_mesh.
// Why not tinyobjloader: by default it holds positions as float, and its variant for double does not round correctly:
// of 10^5 random numbers in [0, 1) with 17 digits it reads 67 831 as another double. And it takes without complaint
// what makes the geometry ambiguous: `v nan 0 0`, `v one 0 0` and `v 0x1p0 0 0` (all become 0), `v 1 0` (z becomes 0),
// `v 0 1,5 0` (becomes 1), `v 1e999 0 0` (infinity), `f 1.0 2 3`, `f 1 2 4294967299` (becomes the third vertex), and
// `f -1 -2 -4` with three vertices (becomes index -1).
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "formats/reading/mesh_file.h"
#include "formats/reading/read_limits.h"
#include "geometry/numbers/errors.h"
#include "geometry/numbers/export.h"

namespace sightline::inline formats {

// Returns the text of the file of this plain name beside the mesh; nothing where there is none. May throw std::length_error,
// which says what is the matter with it.
using FilesBeside = std::function<std::optional<std::string>(const std::string& name)>;

[[nodiscard]] SIGHTLINE_EXPORT MeshFile read_obj(const std::filesystem::path& file, const ReadLimits& limits = {},
                                                 Normals normals = Normals::passed_over);

// Reads the same from text in memory; file_name is for messages. No file is opened: what is beside the mesh, `beside` has; where
// that is empty, mtllib is passed over.
[[nodiscard]] SIGHTLINE_EXPORT MeshFile read_obj(std::string_view text, const std::string& file_name,
                                                 const ReadLimits& limits = {}, Normals normals = Normals::passed_over,
                                                 const FilesBeside& beside = {});

}  // namespace sightline::inline formats
