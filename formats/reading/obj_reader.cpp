#include "formats/reading/obj_reader.h"

#include <array>
#include <fstream>
#include <memory>
#include <span>

#include "formats/reading/obj_materials.h"
#include "formats/reading/obj_statements.h"

namespace sightline::inline formats {

namespace {

// Returns the bytes of a file, in order.
ByteSource bytes_of(const std::filesystem::path& file) {
  std::error_code unused;
  if (std::filesystem::is_directory(file, unused))
    throw InputError(file.string(), 0, "is a directory, not an OBJ file");
  const auto in = std::make_shared<std::ifstream>(file, std::ios::binary);
  if (!*in) throw InputError(file.string(), 0, "cannot be opened");
  return [in, name = file.string()](std::span<char> to) {
    in->read(to.data(), static_cast<std::streamsize>(to.size()));
    if (in->bad()) throw InputError(name, 0, "cannot be read to its end");
    return static_cast<std::size_t>(in->gcount());
  };
}

// Returns a list like "3, 7, 12", of at most ten of them.
std::string id_list(std::span<const FaceId> faces) {
  std::string list;
  for (std::size_t i = 0; i < faces.size() && i < 10; ++i) {
    list += (i == 0 ? "" : ", ") + std::to_string(faces[i].value);
  }
  return list + (faces.size() > 10 ? ", ..." : "");
}

std::string counted(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

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

void warn_about_defects(const Mesh& mesh, const std::string& name, std::vector<std::string>& warnings) {
  for (const Defect defect : {Defect::too_few_corners, Defect::zero_area, Defect::self_crossing, Defect::repeated_face,
                              Defect::repeated_corner}) {
    std::vector<FaceId> faces;
    for (const FaceDefect& d : mesh.defects) {
      if (d.defect == defect) faces.push_back(d.face);
    }
    if (faces.empty()) continue;
    const char* const done = is_skipped(defect) ? " skipped (" : " mended (";
    warnings.push_back(name + ": " + counted(faces.size(), "face") + done + to_string(defect) + "): " + id_list(faces));
  }
}

MeshFile read_from(ObjScanner& scanner, const std::string& name, const ReadLimits& limits, Normals normals,
                   const FilesBeside& beside) {
  ObjStatements statements = parse_obj_statements(scanner, name, limits, normals);
  MeshFile result;
  result.corner_normals = std::move(statements.corner_normals);
  result.regions = std::move(statements.regions);
  warn_about_statements(statements, name, result.warnings);
  for (const std::string& line : statements.region_limits) result.warnings.push_back(name + ": " + line);
  find_materials(result.regions, statements.libraries, beside, name, result.warnings);
  result.mesh = build_mesh(std::move(statements.vertices), std::move(statements.faces));
  warn_about_defects(result.mesh, name, result.warnings);
  if (result.mesh.facet_count() == 0) result.warnings.push_back(name + ": the scene is empty: no face is left to draw");
  return result;
}

}  // namespace

MeshFile read_obj(const std::filesystem::path& file, const ReadLimits& limits, Normals normals) {
  ObjScanner scanner(bytes_of(file));
  return read_from(scanner, file.string(), limits, normals, files_in_folder(file.parent_path()));
}

MeshFile read_obj(std::string_view text, const std::string& file_name, const ReadLimits& limits, Normals normals,
                  const FilesBeside& beside) {
  ObjScanner scanner(text);
  return read_from(scanner, file_name, limits, normals, beside);
}

}  // namespace sightline::inline formats
