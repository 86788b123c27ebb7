// Names of cameras that come from files: "./images/2.jpeg" is no folder's name, but "2" is.
//
// In:  names as files have them. Out: for each a name that name_defect has nothing against, all distinct.
// The rule: what follows the last slash or backslash counts, without its ending (a dot and one to five characters, a letter among them);
// what no name may have becomes a hyphen at its place, is left out at an end, and what is longer than 100 bytes is cut. An
// empty one is "camera". A name that was there before gets -2, -3, ...
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

namespace sightline::cli {

[[nodiscard]] std::string folder_name(std::string_view raw);

// Gives names that are distinct from those that it gave before.
class DistinctNames {
 public:
  [[nodiscard]] std::string next(const std::string& name);

 private:
  std::set<std::string> taken_;
  std::map<std::string, std::size_t> repeated_;  // how often
};

}  // namespace sightline::cli
