// A temporary folder beside the results, in which they are made; gone when the process ends, whatever ends it.
//
// In:  the folder the results are for; it is made where it is missing.
// Out: PARENT/.sightline-partial-XXXXXX, with the folders `new` (what is made) and `old` (what it replaces).
// Holds:
//   - the destructor removes it, and so do SIGINT, SIGTERM and SIGHUP (see SignalWatch); what was made of PARENT and is
//     empty then goes too;
//   - what a run that was killed has left is removed when the next one is made in the same PARENT: the folder is locked
//     (flock) as long as its process lives, so one that can be locked is nobody's. Where a killed run had an old result
//     in `old` and PARENT has none of the name, it goes back;
//   - a file system without locks gets no clean-up of leftovers, since they could be another run's.
// Errors: OutputError.
#pragma once

#include <filesystem>
#include <mutex>
#include <vector>

#include "cli/system/durable_file.h"
#include "cli/system/signal_watch.h"

namespace sightline::cli {

class StagingFolder {
 public:
  explicit StagingFolder(const std::filesystem::path& parent);
  StagingFolder(const StagingFolder&) = delete;
  StagingFolder& operator=(const StagingFolder&) = delete;
  ~StagingFolder();

  [[nodiscard]] std::filesystem::path fresh() const { return path_ / "new"; }
  [[nodiscard]] std::filesystem::path old() const { return path_ / "old"; }

  // To be held while names are made or moved: a signal waits for the end of it, and afterwards nobody gets it.
  [[nodiscard]] std::unique_lock<std::mutex> names() { return std::unique_lock(names_); }

 private:
  StagingFolder();
  void remove();

  std::vector<std::filesystem::path> made_;  // folders that were missing, the outermost first
  std::filesystem::path path_;
  Descriptor lock_;
  std::mutex names_;
  SignalWatch watch_;  // the last member: it is the first to go, and its thread uses the others
};

}  // namespace sightline::cli
