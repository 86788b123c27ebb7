#include "cli/compare/compare_table.h"

#include "cli/results/json.h"
#include "formats/writing/escaped_text.h"
#include "formats/writing/text_buffer.h"

namespace sightline::cli {

namespace {

const char* to_string(peers::ComputedAt computed_at) {
  return computed_at == peers::ComputedAt::image_precision ? "image" : "object";
}

void write_errors(const std::optional<peers::AreaErrors>& errors, TextBuffer& out) {
  if (!errors) {
    out << ",,,,,";
    return;
  }
  out << errors->wrong_share << ',' << errors->largest_relative_error << ',' << errors->mean_relative_error << ','
      << std::uint64_t{errors->missed_faces} << ',' << std::uint64_t{errors->hidden_faces_shown} << ',';
}

void write_errors(const std::optional<peers::LineErrors>& errors, TextBuffer& out) {
  if (!errors) {
    out << ",,,";
    return;
  }
  out << errors->length << ',' << errors->missing_share << ',' << errors->hidden_share << ',';
}

void write_row(const CompareRun& run, TextBuffer& out) {
  const bool is_done = run.end == CompareEnd::done;
  out << run.peer.name << ',' << to_string(run.peer.computed_at) << ',';
  if (run.resolution) out << static_cast<std::uint32_t>(*run.resolution);
  out << ',' << to_string(run.end) << ',' << csv_text(run.why) << ',';
  if (is_done) out << run.seconds;
  out << ',';
  if (is_done) out << run.peak_bytes;
  out << ',';
  write_errors(run.areas, out);
  write_errors(run.lines, out);
  out << csv_text(counts_text(run)) << '\n';
}

Json errors_json(const std::optional<peers::AreaErrors>& errors) {
  if (!errors) return nullptr;
  return {{"wrong_share", errors->wrong_share},
          {"largest_relative_error", errors->largest_relative_error},
          {"mean_relative_error", errors->mean_relative_error},
          {"missed_faces", errors->missed_faces},
          {"hidden_faces_shown", errors->hidden_faces_shown}};
}

Json errors_json(const std::optional<peers::LineErrors>& errors) {
  if (!errors) return nullptr;
  return {{"length", errors->length}, {"missing_share", errors->missing_share}, {"hidden_share", errors->hidden_share}};
}

Json run_json(const CompareRun& run) {
  const bool is_done = run.end == CompareEnd::done;
  Json counts = Json::object();
  for (const peers::Count& count : run.counts) counts[count.what] = count.number;
  return {{"peer", run.peer.name},
          {"title", run.peer.title},
          {"source", run.peer.source},
          {"precision", to_string(run.peer.computed_at)},
          {"resolution", as_json(run.resolution)},
          {"outcome", to_string(run.end)},
          {"why", run.why.empty() ? Json() : Json(run.why)},
          {"seconds", is_done ? Json(run.seconds) : Json()},
          {"peak_bytes", is_done ? Json(run.peak_bytes) : Json()},
          {"errors", errors_json(run.areas)},
          {"line_errors", errors_json(run.lines)},
          {"counts", std::move(counts)}};
}

}  // namespace

std::string counts_text(const CompareRun& run) {
  std::string text;
  for (const peers::Count& count : run.counts) {
    text += (text.empty() ? "" : ", ") + count.what + " " + std::to_string(count.number);
  }
  return text;
}

std::string compare_table(const Comparison& comparison) {
  TextBuffer out;
  out << "peer,precision,resolution,outcome,why,seconds,peak_bytes,wrong_share,largest_relative_error,"
         "mean_relative_error,missed_faces,hidden_faces_shown,length,missing_share,hidden_share,counts\n";
  for (const CompareRun& run : comparison.runs) write_row(run, out);
  return out.take();
}

std::string compare_json(const Comparison& comparison) {
  const Json json = {{"scene", comparison.scene},
                     {"camera", comparison.camera},
                     {"faces", comparison.faces},
                     {"polygons_in_view", comparison.polygons},
                     {"visible_faces", comparison.visible_faces},
                     {"time_limit_s", comparison.limit_seconds},
                     {"runs", list_json(comparison.runs, run_json)}};
  return json_text(json);
}

}  // namespace sightline::cli
