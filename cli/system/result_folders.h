// Folders of results that appear together: PARENT/NAME for each name, and files beside them, PARENT/FILE: made in a
// staging folder and put in place when all are there and on the disk.
//
// Holds: whatever ends the run before publish() is done (an error, a full disk, a signal, a crash), every PARENT/NAME and
// PARENT/FILE is byte for byte what it was; afterwards every one is the new one. What exists is exchanged with the new one
// in one step where the file system can do that (see replacement.h). publish() is one such step per name, and no catchable
// signal comes between: only a kill or a power cut within these microseconds leaves some new and others old, each of them
// whole.
// Files in PARENT/NAME that are not written stay (see replacement.h), and so does everything else in PARENT. Old folders
// and files hand their permissions on.
// A PARENT/NAME that is no folder, and a PARENT/FILE that is no file, is refused; so are links to one, and one name for
// both.
// Errors: OutputError, one line with the path and the cause.
#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "cli/system/replacement.h"
#include "cli/system/staging_folder.h"
#include "formats/writing/text_buffer.h"

namespace sightline::cli {

class ResultFolders {
 public:
  // parent is made where it is missing.
  explicit ResultFolders(const std::filesystem::path& parent) : parent_(parent), staging_(parent) {}

  // Makes the folder at its first file. Returns when the file is on the disk.
  void write(const std::string& name, const std::string& file, std::string_view content);
  // Writes what `write_text` appends, while it does.
  void write(const std::string& name, const std::string& file, const std::function<void(TextBuffer&)>& write_text);

  // A file beside the folders. Returns when it is on the disk.
  void write_beside(const std::string& file, std::string_view content);

  // Refuses early what write_beside would refuse late.
  void require_place_beside(const std::string& file) const;

  void publish();

 private:
  [[nodiscard]] Replacement replacement(const std::string& name) const;
  [[nodiscard]] std::vector<Replacement> prepared() const;
  void make_folder(const std::string& name);

  std::filesystem::path parent_;
  StagingFolder staging_;
  std::set<std::string> made_;   // the names whose folders have been made
  std::set<std::string> files_;  // beside them
};

// One such folder.
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
