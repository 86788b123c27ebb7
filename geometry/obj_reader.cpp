#include "geometry/obj_reader.h"

#include <array>
#include <fstream>
#include <span>

#include "geometry/obj_statements.h"

namespace sightline {

namespace {

std::string text_of(const std::filesystem::path& file) {
  std::error_code unused;
  if (std::filesystem::is_directory(file, unused))
    throw InputError(file.string(), 0, "is a directory, not an OBJ file");
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError(file.string(), 0, "cannot be opened");
  constexpr std::size_t chunk = std::size_t{1} << 20;
  std::string text;
  while (in) {
    const std::size_t size = text.size();
    text.resize(size + chunk);
    in.read(text.data() + size, chunk);
    text.resize(size + static_cast<std::size_t>(in.gcount()));
  }
  if (in.bad()) throw InputError(file.string(), 0, "cannot be read to its end");
  return text;
}

// "3, 7, 12", at most ten of them.
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

}  // namespace

ObjFile read_obj(std::string_view text, const std::string& file_name) {
  ObjStatements statements = parse_obj_statements(text, file_name);
  ObjFile result;
  warn_about_statements(statements, file_name, result.warnings);
  result.mesh = build_mesh(std::move(statements.vertices), std::move(statements.faces));
  warn_about_defects(result.mesh, file_name, result.warnings);
  if (result.mesh.facet_count() == 0)
    result.warnings.push_back(file_name + ": the scene is empty: no face is left to draw");
  return result;
}

ObjFile read_obj(const std::filesystem::path& file) { return read_obj(text_of(file), file.string()); }

}  // namespace sightline
