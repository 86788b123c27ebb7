#include "formats/importing/mesh_import.h"

#include "formats/importing/gltf_reader.h"
#include "formats/importing/three_mf_reader.h"
#include "formats/importing/whole_file.h"
#include "formats/reading/file_bytes.h"
#include "formats/reading/mesh_format.h"
#include "formats/reading/mesh_reader.h"
#include "formats/reading/printable.h"
#include "geometry/numbers/errors.h"

namespace sightline::inline formats {

namespace {

// A pipe is left as it is: it gives its bytes only once, and the library takes it as it comes.
MeshFormat format_in(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return MeshFormat::obj;
  const OpenedFile opened = open_file(file, format_head_size);
  return format_of(opened.head, opened.size).format;
}

MeshFile import_bytes(MeshFormat format, std::string_view bytes, const std::string& name, const FileBeside& file_beside,
                      const ReadLimits& limits, Normals normals) {
  if (format == MeshFormat::three_mf) return read_three_mf(bytes, name, limits, normals);
  return read_gltf(bytes, name, file_beside, limits, normals);
}

}  // namespace

MeshFile import_mesh(const std::filesystem::path& file, const ReadLimits& limits, Normals normals) {
  const MeshFormat format = format_in(file);
  if (!is_imported(format)) return read_mesh(file, limits, normals);
  const std::string bytes = whole_file(file, limits);
  const auto file_beside = [&](const std::string& name) {
    const std::filesystem::path beside = file.parent_path() / name;
    if (!std::filesystem::is_regular_file(beside))
      throw GltfError("the buffer \"" + printable(name) + "\" is not beside the mesh");
    return whole_file(beside, limits);
  };
  return import_bytes(format, bytes, file.string(), file_beside, limits, normals);
}

MeshFile import_mesh(std::string_view bytes, const std::string& file_name, const ReadLimits& limits, Normals normals) {
  const MeshFormat format = format_of(bytes.substr(0, format_head_size), bytes.size()).format;
  if (!is_imported(format)) return read_mesh(bytes, file_name, limits, normals);
  return import_bytes(format, bytes, file_name, nullptr, limits, normals);
}

}  // namespace sightline::inline formats
