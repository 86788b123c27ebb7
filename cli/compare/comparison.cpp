#include "cli/compare/comparison.h"

namespace sightline::cli {

std::string picture_name(const CompareRun& run) {
  return run.peer.name + (run.resolution ? "-" + std::to_string(*run.resolution) : "");
}

std::vector<std::vector<const CompareRun*>> by_peer(const Comparison& comparison) {
  std::vector<std::vector<const CompareRun*>> groups;
  for (const CompareRun& run : comparison.runs) {
    if (groups.empty() || groups.back().front()->peer.name != run.peer.name) groups.emplace_back();
    groups.back().push_back(&run);
  }
  return groups;
}

}  // namespace sightline::cli
