#include "cli/compare_options.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/options/option_values.h"
#include "peers/peer_list.h"

namespace sightline::cli {

namespace {

constexpr int most_pixels = 16384;  // along each side
constexpr double default_time_limit = 60;

std::vector<std::string> parsed_peers(const std::string& text) {
  std::vector<std::string> known;
  for (const peers::Peer& peer : peers::all_peers()) known.push_back(peer.name);
  if (text.empty()) return known;
  std::vector<std::string> wanted;
  for (const std::string_view name : split(text, ',')) {
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw CommandLineError(fmt::format("--peers: there is no '{}'; there are {}", name, fmt::join(known, ", ")));
    wanted.emplace_back(name);
  }
  return wanted;
}

std::vector<int> parsed_resolutions(const std::string& text) {
  const std::string list = text.empty() ? "64,256,1024" : text;
  std::vector<int> resolutions;
  for (const std::string_view part : split(list, ',')) {
    resolutions.push_back(parsed_whole_number(part, "--resolution", 1, most_pixels));
  }
  std::sort(resolutions.begin(), resolutions.end());
  resolutions.erase(std::unique(resolutions.begin(), resolutions.end()), resolutions.end());
  return resolutions;
}

double parsed_time_limit(const std::string& text) {
  if (text.empty()) return default_time_limit;
  const double seconds = parsed_number(text, "--time-limit");
  if (seconds <= 0) throw CommandLineError(fmt::format("--time-limit: '{}' is not more than 0", text));
  return seconds;
}

}  // namespace

void declare_compare(CLI::App& compare, CompareTexts& texts) {
  compare.add_option("input", texts.input, "a scene file (.toml), or a mesh (.obj) with a camera from the options")
      ->required()
      ->type_name("SCENE.toml|MESH.obj");
  compare.add_option("--camera", texts.camera, "which of the scene's cameras (the first)")->type_name("NAME");
  declare_camera(compare, texts.mesh_camera);
  compare.add_option("--peers", texts.peers, "only these algorithms (all); a wrong name prints the list")
      ->type_name("A,B,...");
  compare.add_option("--resolution", texts.resolution, "pixels along each side of item buffers (64,256,1024)")
      ->type_name("N,N,...");
  compare.add_option("--time-limit", texts.time_limit, "processor time that each of them may take (60)")
      ->type_name("S");
  compare.add_option("-o,--output", texts.output, "folder for compare.html, .csv and .json, and the pictures")
      ->required()
      ->type_name("DIR");
  compare.add_flag("--quiet", texts.quiet, "neither progress nor summary");
  compare.footer("Example: sightline compare fixtures/demo/scene.toml --resolution 64,256 -o compared");
}

CompareOptions options_of(const CompareTexts& texts) {
  CompareOptions options;
  options.input = texts.input;
  options.output = texts.output;
  options.mesh_camera = camera_of(texts.input, texts.mesh_camera);
  if (!texts.camera.empty()) options.camera = texts.camera;
  if (options.camera && options.mesh_camera) throw CommandLineError("--camera goes with a scene file");
  options.peers = parsed_peers(texts.peers);
  options.resolutions = parsed_resolutions(texts.resolution);
  options.limit_seconds = parsed_time_limit(texts.time_limit);
  options.quiet = texts.quiet;
  return options;
}

}  // namespace sightline::cli
