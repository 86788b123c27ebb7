// A mesh as an OBJ file, which is there as long as the value is.
//
// In:  a mesh. Out: a file in the folder for temporary files: `v` with nine significant digits, and `f`.
// Complexity: O(n). Errors: std::runtime_error where it cannot be written.
#pragma once

#include <filesystem>

#include "geometry/mesh/mesh.h"

namespace sightline::bench {

class TemporaryObj {
 public:
  explicit TemporaryObj(const PolygonMesh& mesh);
  TemporaryObj(const TemporaryObj&) = delete;
  TemporaryObj& operator=(const TemporaryObj&) = delete;
  ~TemporaryObj();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace sightline::bench
