#include "formats/reading/obj_reader.h"

#include "formats/reading/file_bytes.h"
#include "formats/reading/mesh_warnings.h"
#include "formats/reading/obj_materials.h"
#include "formats/reading/obj_source.h"
#include "formats/reading/obj_statements.h"

namespace sightline::inline formats {

namespace {

void warn_about_statements(const ObjStatements& statements, const std::string& name,
                           std::vector<std::string>& warnings) {
  if (statements.unknown_count > 0) {
    warnings.push_back(name + ": " + counted(statements.unknown_count, "statement") + " not understood, from line " +
                       std::to_string(statements.unknown_line) + " on: " + statements.unknown_keyword);
  }
  const auto& faces = statements.faces_with_missing_attributes;
  if (!faces.empty()) {
    warnings.push_back(name + ": " + counted(faces.size(), "face") +
                       " with texture or normal indices that name nothing: " + id_list(faces));
  }
}

MeshFile read_from(ObjScanner& scanner, const std::string& name, const ReadLimits& limits, Normals normals,
                   const FilesBeside& beside) {
  ObjStatements statements = parse_obj_statements(scanner, name, limits, normals);
  MeshFile result;
  result.corner_normals = std::move(statements.corner_normals);
  result.regions = std::move(statements.regions);
  warn_about_statements(statements, name, result.warnings);
  for (const std::string& line : statements.region_limits) result.warnings.emplace_back(name).append(": ").append(line);
  find_materials(result.regions, statements.libraries, beside, name, result.warnings);
  result.mesh = build_mesh(std::move(statements.vertices), std::move(statements.faces));
  warn_about_defects(result.mesh, name, result.warnings);
  warn_if_empty(result.mesh, name, result.warnings);
  return result;
}

}  // namespace

MeshFile read_obj(const std::filesystem::path& file, const ReadLimits& limits, Normals normals) {
  return read_obj(bytes_of(file), file.string(), limits, normals, files_in_folder(file.parent_path()));
}

MeshFile read_obj(ByteSource bytes, const std::string& file_name, const ReadLimits& limits, Normals normals,
                  const FilesBeside& beside) {
  ObjScanner scanner(std::move(bytes));
  return read_from(scanner, file_name, limits, normals, beside);
}

MeshFile read_obj(std::string_view text, const std::string& file_name, const ReadLimits& limits, Normals normals,
                  const FilesBeside& beside) {
  ObjScanner scanner(text);
  return read_from(scanner, file_name, limits, normals, beside);
}

}  // namespace sightline::inline formats
