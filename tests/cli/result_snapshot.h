// A snapshot has what is in a folder of results, for comparing byte for byte.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace sightline::tests {

// Every file below the folder has its content, by its path in it; a report.json has it without what two runs may differ
// in (times and memory). Folders of unfinished runs are left out.
using Snapshot = std::map<std::string, std::string>;
[[nodiscard]] Snapshot snapshot_of(const std::filesystem::path& folder);

// Returns what runs that were stopped have left.
[[nodiscard]] std::size_t leftovers_in(const std::filesystem::path& folder);

// Returns a scene file with three cameras, `near`, `far` and `sun`, at fixtures/fang, the eyes off by `shift`.
[[nodiscard]] std::string three_camera_scene(int shift);

}  // namespace sightline::tests
