// A folder of results that appears at once: files are written to a temporary sibling and moved when all are there.
//
// Other files in an existing folder are left alone; those of the same names are replaced.
// Errors: OutputError, one line with the path and the cause.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/errors.h"

namespace sightline {

class OutputError : public Error {
  using Error::Error;
};

class OutputFolder {
 public:
  // parent/name; parents are made where they are missing.
  OutputFolder(const std::filesystem::path& parent, const std::string& name);
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;
  // Removes what was written and not published.
  ~OutputFolder();

  void write(const std::string& file, std::string_view content);
  void publish();

 private:
  std::filesystem::path folder_;
  std::filesystem::path temporary_;
  std::vector<std::string> files_;
};

}  // namespace sightline
