#include "formats/reading/mesh_reader.h"

#include "formats/reading/file_bytes.h"
#include "formats/reading/input_bytes.h"
#include "formats/reading/mesh_format.h"
#include "formats/reading/obj_materials.h"
#include "formats/reading/obj_reader.h"
#include "formats/reading/obj_source.h"
#include "formats/reading/off_reader.h"
#include "formats/reading/ply_reader.h"
#include "formats/reading/stl_reader.h"

namespace sightline::inline formats {

namespace {

std::string refusal_of_import(MeshFormat format) {
  const std::string name = format == MeshFormat::three_mf ? "3MF" : format == MeshFormat::gltf ? "glTF" : "binary glTF";
  return name +
         " is read by the command sightline from a file, and not by the library; save the mesh as PLY, STL or OBJ";
}

// Reads what is not OBJ.
MeshFile read_found(const FoundFormat& found, InputBytes& in, const ReadLimits& limits, Normals normals) {
  switch (found.format) {
    case MeshFormat::stl_text:
      return read_stl_text(in, limits, normals);
    case MeshFormat::stl_binary:
      return read_stl_binary(in, limits, normals);
    case MeshFormat::ply:
      return read_ply(in, limits, normals);
    case MeshFormat::off:
      return read_off(in, limits, normals);
    default:
      throw InputError(in.name(), 0, is_imported(found.format) ? refusal_of_import(found.format) : found.refusal);
  }
}

}  // namespace

MeshFile read_mesh(const std::filesystem::path& file, const ReadLimits& limits, Normals normals) {
  OpenedFile opened = open_file(file, format_head_size);
  const FoundFormat found = format_of(opened.head, opened.size);
  if (found.format == MeshFormat::obj) {
    // A pipe gives its bytes only once.
    return opened.size
               ? read_obj(file, limits, normals)
               : read_obj(std::move(opened.bytes), file.string(), limits, normals, files_in_folder(file.parent_path()));
  }
  InputBytes in(std::move(opened.bytes), file.string());
  return read_found(found, in, limits, normals);
}

MeshFile read_mesh(std::string_view bytes, const std::string& file_name, const ReadLimits& limits, Normals normals) {
  const FoundFormat found = format_of(bytes.substr(0, format_head_size), bytes.size());
  if (found.format == MeshFormat::obj) return read_obj(bytes, file_name, limits, normals);
  InputBytes in(bytes, file_name);
  return read_found(found, in, limits, normals);
}

}  // namespace sightline::inline formats
