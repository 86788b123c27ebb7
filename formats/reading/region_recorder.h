// What a file says of regions, noted face by face.
//
// In:  which object, material, smoothing group and groups faces are in from here on, in the file's bytes; and each face.
// Out: the regions of all faces (face_regions.h), and what of its limits was met.
// Complexity: O(log regions) per change, O(1) per face.
#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "formats/reading/face_regions.h"

namespace sightline::inline formats {

class RegionRecorder {
 public:
  // What is said from the next face on. `bytes` are as the file has them.
  void set(RegionKind kind, std::string_view bytes);
  void set_groups(const std::vector<std::string>& names);
  void add_face();

  [[nodiscard]] std::uint64_t memory() const;  // in bytes, about
  // One line for each limit that was met.
  [[nodiscard]] std::vector<std::string> limits_met() const;
  [[nodiscard]] FaceRegions take() { return std::move(result_); }

 private:
  RegionId id_of(RegionKind kind, const std::string& name);
  [[nodiscard]] std::string named(std::string_view bytes);
  void begin_state();
  void begin_groups();

  FaceRegions result_;
  std::map<std::pair<RegionKind, std::string>, RegionId> ids_;
  std::array<std::size_t, region_kinds.size()> counts_{};
  std::array<std::string, region_kinds.size()> names_;  // of the kinds that a face has one of
  std::vector<std::string> groups_{""};
  std::uint32_t first_group_ = 0;  // of the last state
  bool changed_ = true;
  bool groups_changed_ = true;
  std::array<bool, region_kinds.size()> too_many_{};
  bool cut_name_ = false;
  bool cut_groups_ = false;
};

}  // namespace sightline::inline formats
