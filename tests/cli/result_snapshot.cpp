#include "tests/cli/result_snapshot.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/tools/command_runner.h"

namespace sightline::tests {

namespace {

namespace fs = std::filesystem;

constexpr const char* leftover_prefix = ".sightline-partial-";

bool is_leftover(const fs::directory_entry& entry) {
  return entry.path().filename().string().starts_with(leftover_prefix);
}

// A report that is cut off is no JSON, and stays as it is.
std::string without_costs(const std::string& report) {
  auto json = nlohmann::ordered_json::parse(report, nullptr, false);
  if (json.is_discarded()) return report;
  json.erase("times_s");
  json.erase("peak_memory_bytes");
  return json.dump();
}

std::string camera(const char* name, int eye_x, const char* lens) {
  return std::string("[[camera]]\nname = \"") + name + "\"\neye = [" + std::to_string(eye_x) +
         ", 8, 30]\ntarget = [8, 8, 0]\n" + lens + "\n";
}

}  // namespace

Snapshot snapshot_of(const fs::path& folder) {
  Snapshot snapshot;
  for (auto at = fs::recursive_directory_iterator(folder); at != fs::recursive_directory_iterator(); ++at) {
    if (is_leftover(*at)) at.disable_recursion_pending();
    if (!at->is_regular_file()) continue;
    const std::string text = read_text(at->path());
    snapshot[at->path().lexically_relative(folder).string()] =
        at->path().filename() == "report.json" ? without_costs(text) : text;
  }
  return snapshot;
}

std::size_t leftovers_in(const fs::path& folder) {
  return static_cast<std::size_t>(std::count_if(fs::directory_iterator(folder), {}, is_leftover));
}

std::string three_camera_scene(int shift) {
  return "[mesh]\nfile = \"" SIGHTLINE_FIXTURES_DIR "/fang/fang.obj\"\n" + camera("near", 8 + shift, "fov_y_deg = 40") +
         camera("far", 9 + shift, "fov_y_deg = 60") + camera("sun", 10 + shift, "orthographic_height = 16");
}

}  // namespace sightline::tests
