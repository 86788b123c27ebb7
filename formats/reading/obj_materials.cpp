#include "formats/reading/obj_materials.h"

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

#include "formats/reading/mtl_reader.h"
#include "formats/reading/printable.h"

namespace sightline::inline formats {

namespace {

constexpr std::size_t most_warnings = 10;

using Materials = std::map<std::string, Material>;

std::string joined_names(const std::vector<std::string>& names) {
  std::string result;
  for (const std::string& name : names) result += (result.empty() ? "" : " ") + name;
  return result;
}

// Reads the libraries one by one, each once.
class LibrarySearch {
 public:
  LibrarySearch(const FilesBeside& beside, const std::string& mesh_name, std::vector<std::string>& warnings)
      : beside_(beside), mesh_name_(mesh_name), warnings_(warnings) {}

  void add(const MaterialLibraries& libraries) {
    const std::string one_name = joined_names(libraries.names);
    if (libraries.names.size() > 1 && is_plain_file_name(one_name) && beside_(one_name).has_value()) {
      add(one_name, libraries.line);
      return;
    }
    for (const std::string& name : libraries.names) add(name, libraries.line);
  }

  [[nodiscard]] const Materials& found() const { return found_; }
  // The libraries that are not read, beyond those that there are warnings of.
  [[nodiscard]] std::size_t not_warned() const { return warned_ - std::min(warned_, most_warnings); }
  [[nodiscard]] bool is_complete() const { return is_complete_; }

 private:
  void add(const std::string& name, std::size_t line) {
    if (!seen_.insert(name).second) return;
    if (!is_plain_file_name(name))
      return warn(name, line, "is not opened: only files beside the mesh are, by their plain name; put it there");
    try {
      const std::optional<std::string> text = beside_(name);
      if (!text) return warn(name, line, "is not beside the mesh; put it there, or remove the statement");
      found_.merge(read_mtl(*text));
    } catch (const std::length_error& error) {
      warn(name, line, std::string(error.what()) + "; its materials are not known");
    }
  }

  void warn(const std::string& name, std::size_t line, const std::string& what) {
    is_complete_ = false;
    if (warned_++ >= most_warnings) return;
    warnings_.push_back(mesh_name_ + ":" + std::to_string(line) + ": material library \"" + printable(name) + "\" " +
                        what);
  }

  const FilesBeside& beside_;
  const std::string& mesh_name_;
  std::vector<std::string>& warnings_;
  std::set<std::string> seen_;
  Materials found_;
  bool is_complete_ = true;
  std::size_t warned_ = 0;
};

// Returns the names of the materials that are not defined, three at most.
std::string assign_materials(FaceRegions& regions, const Materials& materials) {
  std::size_t missing = 0;
  std::string names;
  for (Region& region : regions.regions) {
    if (region.kind != RegionKind::material || region.name.empty()) continue;
    const auto found = materials.find(region.name);
    if (found != materials.end()) {
      region.material = found->second;
    } else if (missing++ < 3) {
      names += (names.empty() ? "" : ", ") + printable(region.name);
    }
  }
  return names + (missing > 3 ? ", ..." : "");
}

}  // namespace

bool is_plain_file_name(std::string_view name) {
  constexpr std::string_view separators("/\\:\0", 4);
  return !name.empty() && name.size() <= longest_region_name && name != "." && name != ".." &&
         name.find_first_of(separators) == std::string_view::npos;
}

void find_materials(FaceRegions& regions, const std::vector<MaterialLibraries>& libraries, const FilesBeside& beside,
                    const std::string& mesh_name, std::vector<std::string>& warnings) {
  if (!beside || libraries.empty()) return;
  LibrarySearch search(beside, mesh_name, warnings);
  for (const MaterialLibraries& library : libraries) search.add(library);
  if (search.not_warned() > 0)
    warnings.push_back(mesh_name + ": " + std::to_string(search.not_warned()) +
                       " more material libraries are not read");
  const std::string missing = assign_materials(regions, search.found());
  if (search.is_complete() && !missing.empty())
    warnings.push_back(mesh_name + ": materials that no library defines: " + missing);
}

FilesBeside files_in_folder(const std::filesystem::path& folder) {
  return [folder](const std::string& name) -> std::optional<std::string> {
    const std::filesystem::path file = folder / name;
    std::error_code unknown;
    if (!std::filesystem::is_regular_file(file, unknown)) return std::nullopt;
    const auto size = std::filesystem::file_size(file, unknown);
    if (unknown) return std::nullopt;
    if (size > longest_mtl_file)
      throw std::length_error("has more than " + std::to_string(longest_mtl_file) + " bytes");
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    if (size > 0) text << in.rdbuf();
    if (!in) return std::nullopt;
    return text.str();
  };
}

}  // namespace sightline::inline formats
