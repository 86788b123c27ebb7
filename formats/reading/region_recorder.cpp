#include "formats/reading/region_recorder.h"

#include <algorithm>

namespace sightline::inline formats {

namespace {

std::size_t index_of(RegionKind kind) { return static_cast<std::size_t>(kind); }

// The kinds of State::single, in its order.
constexpr std::array single_kinds{RegionKind::mesh, RegionKind::object, RegionKind::material, RegionKind::smoothing};

}  // namespace

std::string RegionRecorder::named(std::string_view bytes) {
  std::string name = region_name(bytes);
  cut_name_ = cut_name_ || bytes.size() > longest_region_name;
  return name;
}

void RegionRecorder::set(RegionKind kind, std::string_view bytes) {
  names_[index_of(kind)] = named(bytes);
  changed_ = true;
}

void RegionRecorder::set_groups(const std::vector<std::string>& names) {
  cut_groups_ = cut_groups_ || names.size() > most_groups_of_face;
  groups_.clear();
  for (std::size_t i = 0; i < std::min(names.size(), most_groups_of_face); ++i) groups_.push_back(named(names[i]));
  if (groups_.empty()) groups_.emplace_back();
  changed_ = true;
  groups_changed_ = true;
}

RegionId RegionRecorder::id_of(RegionKind kind, const std::string& name) {
  const auto known = ids_.find({kind, name});
  if (known != ids_.end()) return known->second;
  std::size_t& count = counts_[index_of(kind)];
  if (count >= most_regions && !name.empty()) {
    too_many_[index_of(kind)] = true;
    return id_of(kind, "");
  }
  ++count;
  const RegionId id(result_.regions.size());
  result_.regions.push_back({kind, "", name, {}});
  ids_.emplace(std::pair(kind, name), id);
  return id;
}

// States share the list of their groups, as long as that does not change.
void RegionRecorder::begin_groups() {
  std::vector<RegionId> groups;
  for (const std::string& name : groups_) groups.push_back(id_of(RegionKind::group, name));
  std::ranges::sort(groups);
  groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
  first_group_ = static_cast<std::uint32_t>(result_.groups.size());
  result_.groups.insert(result_.groups.end(), groups.begin(), groups.end());
  groups_changed_ = false;
}

void RegionRecorder::begin_state() {
  FaceRegions::State state;
  for (std::size_t i = 0; i < single_kinds.size(); ++i)
    state.single[i] = id_of(single_kinds[i], names_[index_of(single_kinds[i])]);
  if (groups_changed_) begin_groups();
  state.first_group = first_group_;
  state.group_count = static_cast<std::uint32_t>(result_.groups.size()) - first_group_;
  result_.states.push_back(state);
}

void RegionRecorder::add_face() {
  if (changed_) begin_state();
  changed_ = false;
  result_.face_state.push_back(static_cast<std::uint32_t>(result_.states.size() - 1));
}

// A region is held with its name twice, and in a tree.
std::uint64_t RegionRecorder::memory() const {
  return 400 * result_.regions.size() + 2 * sizeof(RegionId) * result_.groups.size() +
         2 * sizeof(FaceRegions::State) * result_.states.size() + 2 * sizeof(std::uint32_t) * result_.face_state.size();
}

std::vector<std::string> RegionRecorder::limits_met() const {
  std::vector<std::string> lines;
  for (const RegionKind kind : region_kinds) {
    if (too_many_[index_of(kind)])
      lines.push_back("more than " + std::to_string(most_regions) + " names of kind " + to_string(kind) +
                      ": faces of further ones count as having none");
  }
  if (cut_name_)
    lines.push_back("names of regions of more than " + std::to_string(longest_region_name) + " bytes: they are cut");
  if (cut_groups_)
    lines.push_back("faces in more than " + std::to_string(most_groups_of_face) +
                    " groups: further groups are passed over");
  return lines;
}

}  // namespace sightline::inline formats
