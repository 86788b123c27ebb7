// This is one OBJ file of a test folder, with what reading it must give.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "formats/reading/obj_reader.h"
#include "tests/tools/says_what_to_do.h"

namespace sightline::tests {

constexpr int any_count = -1;
constexpr double any_area = -1;

struct ObjCase {
  std::string file;
  int facets = any_count;
  double area = any_area;           // of all facets, in double arithmetic that is exact for these files
  std::vector<FaceDefect> defects;  // all of them
  std::string warning;              // a part of one of the warnings
  std::string error;                // a part of the message; then nothing is read
  std::size_t line = 0;             // of the error
};

inline ObjCase reads(std::string file, int facets, double area = any_area) {
  return {std::move(file), facets, area, {}, "", "", 0};
}
inline ObjCase fails(std::string file, std::size_t line, std::string error) {
  return {std::move(file), any_count, any_area, {}, "", std::move(error), line};
}
inline ObjCase with_warning(ObjCase c, std::string warning) {
  c.warning = std::move(warning);
  return c;
}
inline ObjCase with_defect(ObjCase c, Defect defect, const std::vector<std::size_t>& faces) {
  for (const std::size_t f : faces) c.defects.push_back({FaceId(f), defect});
  std::ranges::sort(c.defects, {}, &FaceDefect::face);
  return c;
}

inline double area_of(const Mesh& mesh) {
  double area = 0;
  for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
    const auto corners = mesh.corners(FacetId(f));
    Vector3 normal = Vector3::Zero();
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      const Point3& a = mesh.position(corners[0]);
      normal = normal + (mesh.position(corners[i]) - a).cross(mesh.position(corners[i + 1]) - a);
    }
    area += norm(normal) / 2;
  }
  return area;
}

inline bool is_one_line(const std::string& text) {
  return std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) >= 0x20 && c != 0x7f; });
}

inline void check_read(const ObjCase& c, const MeshFile& read) {
  CHECK(validate(read.mesh) == std::vector<std::string>{});
  if (c.facets != any_count) CHECK(read.mesh.facet_count() == static_cast<std::size_t>(c.facets));
  if (c.area != any_area) CHECK(area_of(read.mesh) == c.area);
  REQUIRE(read.mesh.defects.size() == c.defects.size());
  for (std::size_t i = 0; i < c.defects.size(); ++i) {
    CHECK(read.mesh.defects[i].face == c.defects[i].face);
    CHECK(read.mesh.defects[i].defect == c.defects[i].defect);
  }
  CHECK(std::ranges::all_of(read.warnings, is_one_line));
  const auto has = [](const std::string& part) {
    return [&part](const std::string& text) { return text.find(part) != std::string::npos; };
  };
  CHECK(std::ranges::any_of(read.warnings, has("scene is empty")) == (read.mesh.facet_count() == 0));
  if (!c.warning.empty()) CHECK(std::ranges::any_of(read.warnings, has(c.warning)));
  if (c.defects.empty() && c.warning.empty() && c.facets != 0) CHECK(read.warnings.empty());
}

// The message has the path of the file, its line and the cause, in one line.
inline void check_error(const ObjCase& c, const std::string& path, const InputError& error) {
  const std::string message = error.what();
  INFO("error: " << message);
  CHECK(error.line() == c.line);
  CHECK(message.starts_with(path + ":" + std::to_string(c.line) + ": "));
  CHECK(is_one_line(message));
  CHECK(says_what_to_do(message));
  REQUIRE(!c.error.empty());
  CHECK(message.find(c.error) != std::string::npos);
}

inline void check_case(const std::filesystem::path& folder, const ObjCase& c) {
  INFO("file: " << c.file);
  const std::filesystem::path path = folder / c.file;
  try {
    const MeshFile read = read_obj(path);
    CHECK(c.error == "");
    check_read(c, read);
  } catch (const InputError& error) {
    check_error(c, path.string(), error);
  }
}

inline void check_cases(const std::filesystem::path& folder, const std::vector<ObjCase>& cases) {
  for (const ObjCase& c : cases) check_case(folder, c);
}

// Folders, hidden files and notes are left out.
inline std::vector<std::string> files_in(const std::filesystem::path& folder) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_regular_file() && !name.starts_with(".") && !name.ends_with(".md")) files.push_back(name);
  }
  std::ranges::sort(files);
  return files;
}

inline std::vector<std::string> files_of(const std::vector<std::vector<ObjCase>>& tables) {
  std::vector<std::string> files;
  for (const auto& table : tables) {
    for (const ObjCase& c : table) files.push_back(c.file);
  }
  std::ranges::sort(files);
  return files;
}

// Returns the optional folder of public meshes; empty if it is not there.
inline std::filesystem::path shared_folder(const std::string& name) {
  const char* const set = std::getenv("SIGHTLINE_SHARED");
  const std::filesystem::path folder = std::filesystem::path(set != nullptr ? set : SIGHTLINE_SHARED_DIR) / name;
  return std::filesystem::is_directory(folder) ? folder : std::filesystem::path();
}

}  // namespace sightline::tests
