#include "cli/compare/comparison.h"

#include <nlohmann/json.hpp>
#include <variant>

#include "cli/system/resources.h"
#include "cli/system/separate_process.h"
#include "peers/errors/part_errors.h"

namespace sightline::cli {

namespace {

using peers::AreaErrors;
using peers::LineErrors;

void measure(const peers::ItemBuffer& seen, const peers::ExactParts& exact, CompareRun& run) {
  const peers::PixelErrors errors = peers::errors_of(seen, exact);
  run.areas = errors.errors;
  run.pictures = pictures_of(seen, errors.wrong);
}

void measure(const peers::VisibleParts& seen, const peers::ExactParts& exact, CompareRun& run) {
  run.areas = peers::errors_of(seen, exact);
  run.pictures = pictures_of(seen, exact);
}

void measure(const peers::VisibleLines& seen, const peers::ExactParts& exact, CompareRun& run) {
  run.lines = peers::errors_of(seen, exact.lines);
  run.pictures = pictures_of(seen);
}

// In the separate process.
void work(const peers::FlatScene& scene, const peers::ExactParts& exact, const LimitedPartDone& tell, CompareRun& run) {
  reset_peak();
  const std::size_t before = resident_bytes();
  const ProcessorTime watch;
  const peers::Outcome outcome = run.peer.run(scene, run.resolution.value_or(0));
  run.seconds = watch.seconds();
  const std::size_t peak = peak_bytes();
  tell();
  run.peak_bytes = peak > before ? peak - before : 0;
  run.counts = outcome.counts;
  std::visit([&](const auto& seen) { measure(seen, exact, run); }, outcome.seen);
  run.end = CompareEnd::done;
}

void work_or_say_why(const peers::FlatScene& scene, const peers::ExactParts& exact, const LimitedPartDone& tell,
                     CompareRun& run) {
  try {
    work(scene, exact, tell, run);
  } catch (const peers::RefusedScene& refused) {
    run.end = CompareEnd::refused;
    run.why = refused.what();
  } catch (const std::bad_alloc&) {
    run.why = "out of memory";
  } catch (const Error& error) {
    run.why = error.what();
  }
}

nlohmann::json to_json(const AreaErrors& errors) {
  return {errors.wrong_share, errors.largest_relative_error, errors.mean_relative_error, errors.missed_faces,
          errors.hidden_faces_shown};
}

nlohmann::json to_json(const LineErrors& errors) { return {errors.length, errors.missing_share, errors.hidden_share}; }

AreaErrors areas_of(const nlohmann::json& json) { return {json[0], json[1], json[2], json[3], json[4]}; }
LineErrors lines_of(const nlohmann::json& json) { return {json[0], json[1], json[2]}; }

// From process to process.
std::string message_of(const CompareRun& run) {
  nlohmann::json counts = nlohmann::json::array();
  for (const peers::Count& count : run.counts) counts.push_back({count.what, count.number});
  const auto binary = [](const std::string& bytes) {
    return nlohmann::json::binary(std::vector<std::uint8_t>(bytes.begin(), bytes.end()));
  };
  const nlohmann::json json = {{"end", static_cast<int>(run.end)},
                               {"why", run.why},
                               {"seconds", run.seconds},
                               {"peak", run.peak_bytes},
                               {"counts", counts},
                               {"areas", run.areas ? to_json(*run.areas) : nlohmann::json()},
                               {"lines", run.lines ? to_json(*run.lines) : nlohmann::json()},
                               {"seen", binary(run.pictures.seen)},
                               {"wrong", binary(run.pictures.wrong)}};
  const std::vector<std::uint8_t> bytes = nlohmann::json::to_cbor(json);
  return {bytes.begin(), bytes.end()};
}

void read_message(const std::string& bytes, CompareRun& run) {
  const nlohmann::json json = nlohmann::json::from_cbor(bytes);
  const auto text = [](const nlohmann::json& binary) {
    return std::string(binary.get_binary().begin(), binary.get_binary().end());
  };
  run.end = static_cast<CompareEnd>(json["end"].get<int>());
  run.why = json["why"];
  run.seconds = json["seconds"];
  run.peak_bytes = json["peak"];
  for (const nlohmann::json& count : json["counts"]) run.counts.push_back({count[0], count[1]});
  if (!json["areas"].is_null()) run.areas = areas_of(json["areas"]);
  if (!json["lines"].is_null()) run.lines = lines_of(json["lines"]);
  run.pictures = {text(json["seen"]), text(json["wrong"])};
}

}  // namespace

const char* to_string(CompareEnd end) {
  switch (end) {
    case CompareEnd::done:
      return "done";
    case CompareEnd::out_of_time:
      return "out of time";
    case CompareEnd::refused:
      return "refused";
    case CompareEnd::failed:
      break;
  }
  return "failed";
}

CompareRun run_peer(const peers::Peer& peer, const peers::FlatScene& scene, const peers::ExactParts& exact,
                    std::optional<int> resolution, double limit_seconds) {
  CompareRun run;
  run.peer = peer;
  run.resolution = resolution;
  const SeparateWork separate = [&](const LimitedPartDone& tell) {
    CompareRun there = run;
    work_or_say_why(scene, exact, tell, there);
    return message_of(there);
  };
  const SeparateOutcome outcome = run_in_separate_process(separate, limit_seconds);
  if (outcome.end == SeparateOutcome::End::done) read_message(outcome.bytes, run);
  if (outcome.end == SeparateOutcome::End::out_of_time) run.end = CompareEnd::out_of_time;
  if (outcome.end == SeparateOutcome::End::failed) run.why = "it ended without a result";
  return run;
}

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
