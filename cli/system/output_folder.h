// One folder of results that appears at once; result_folders.h says what holds.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "cli/system/result_folders.h"

namespace sightline::cli {

class OutputFolder {
 public:
  // parent/name; parents are made where they are missing.
  OutputFolder(const std::filesystem::path& parent, std::string name) : folders_(parent), name_(std::move(name)) {}

  void write(const std::string& file, std::string_view content) { folders_.write(name_, file, content); }
  void publish() { folders_.publish(); }

 private:
  ResultFolders folders_;
  std::string name_;
};

// The folder at the path, however that is written: "results", "results/", "../a/.".
[[nodiscard]] inline OutputFolder output_folder_at(const std::string& path) {
  const auto place = std::filesystem::absolute(path + "/.").lexically_normal().parent_path();
  return {place.parent_path(), place.filename().string()};
}

}  // namespace sightline::cli
