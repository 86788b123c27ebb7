#include "cli/compare/compare_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "cli/compare/compare_table.h"
#include "formats/pictures/line_plot.h"
#include "formats/writing/escaped_text.h"

namespace sightline::cli {

namespace {

constexpr std::string_view grid_prefix = "sweep-grid-";
constexpr double shortest_seconds = 1e-6;  // what is faster is drawn there: the clock cannot tell

// Colours that the colour-blind tell apart (Okabe and Ito 2008); with the markers a curve has a look of its own.
constexpr std::array colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#222222"};
constexpr std::array markers{Marker::circle, Marker::square, Marker::triangle};

bool is_of_grids(const CompareRun& run) { return run.peer.name.starts_with(grid_prefix); }

std::string series_name(const CompareRun& run) { return is_of_grids(run) ? "sweep, coarser grids" : run.peer.name; }

PlotSeries& series_of(const CompareRun& run, std::vector<PlotSeries>& all) {
  const std::string name = series_name(run);
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const PlotSeries& series) { return series.name == name; });
  if (found != all.end()) return *found;
  const std::size_t number = all.size();
  all.push_back({name, colours.at(number % colours.size()), markers.at(number / colours.size() % markers.size()), {}});
  return all.back();
}

constexpr int shown_resolution = 256;  // the picture on the page is the first that has so many pixels, or the last

constexpr const char* head = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>sightline: comparison</title>
<style>
body { font: 16px/1.5 Georgia, serif; max-width: 62em; margin: 2em auto; padding: 0 1em; color: #222; }
h1, h2 { font-family: Helvetica, Arial, sans-serif; line-height: 1.2; }
h2 { margin-top: 2em; border-top: 1px solid #ccc; padding-top: 0.8em; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font: 13px/1.4 Helvetica, Arial, sans-serif; }
th, td { padding: 3px 10px; text-align: right; border-bottom: 1px solid #ddd; white-space: nowrap; }
th { border-bottom: 1px solid #222; vertical-align: bottom; }
td.text, th.text { text-align: left; }
td.why { white-space: normal; min-width: 14em; }
tr.none td { background: #fdf1e7; }
p.source { color: #555; font-size: 14px; margin-top: -0.6em; }
figure { display: inline-block; margin: 0.5em 1em 0.5em 0; vertical-align: top; }
figure img { width: 300px; max-width: 44vw; border: 1px solid #bbb; image-rendering: pixelated; display: block; }
figcaption { font: 13px/1.4 Helvetica, Arial, sans-serif; color: #444; }
svg { max-width: 100%; height: auto; }
</style>
</head>
<body>
<h1>The same scene, seen by every algorithm</h1>
)";

constexpr const char* explanation = R"(<p>Each algorithm got the same convex polygons of the image, with their depths,
and worked alone in a process of its own, in one thread. <b>Wrong</b> is the part of the window that gets the wrong face:
item buffers are held against the exact visible polygons by integrating these over each pixel, so a pixel on an edge is
partly wrong whatever it shows. <b>Missed</b> are visible faces that are not shown at all, <b>hidden shown</b> faces that
are shown though nothing of them is visible. Time and memory are the only numbers here that differ from run to run.</p>
)";

std::string seconds_text(double seconds) {
  if (seconds < 1e-3) return fmt::format("{:.0f} µs", 1e6 * seconds);
  if (seconds < 1) return fmt::format("{:.3g} ms", 1e3 * seconds);
  return fmt::format("{:.3g} s", seconds);
}

std::string bytes_text(std::uint64_t bytes) { return fmt::format("{:.3g} MB", static_cast<double>(bytes) / 1e6); }

std::string error_cells(const CompareRun& run) {
  if (run.lines) {
    return fmt::format("<td class=\"text\" colspan=\"5\">of the visible lines {:.2g} are missing; {:.2g} too much</td>",
                       run.lines->missing_share, run.lines->hidden_share);
  }
  const peers::AreaErrors& errors = run.areas.value();
  return fmt::format("<td>{:.2g}</td><td>{:.2g}</td><td>{:.2g}</td><td>{}</td><td>{}</td>", errors.wrong_share,
                     errors.mean_relative_error, errors.largest_relative_error, errors.missed_faces,
                     errors.hidden_faces_shown);
}

std::string outcome_cells(const CompareRun& run, double limit_seconds) {
  if (run.end == CompareEnd::done) {
    return fmt::format("<td>{}</td><td>{}</td>{}", seconds_text(run.seconds), bytes_text(run.peak_bytes),
                       error_cells(run));
  }
  const std::string why =
      run.end == CompareEnd::out_of_time ? fmt::format("no result within {} s", limit_seconds) : run.why;
  return fmt::format("<td class=\"text why\" colspan=\"7\">{}: {}</td>", to_string(run.end), html_text(why));
}

std::string row(const CompareRun& run, double limit_seconds) {
  return fmt::format("<tr{}><td class=\"text\"><a href=\"#{}\">{}</a></td><td>{}</td>{}</tr>\n",
                     run.end == CompareEnd::done ? "" : " class=\"none\"", run.peer.name, run.peer.title,
                     run.resolution ? std::to_string(*run.resolution) : "", outcome_cells(run, limit_seconds));
}

std::string table(const Comparison& comparison) {
  std::string text =
      "<div class=\"scroll\"><table>\n<tr><th class=\"text\">algorithm</th><th>pixels<br>a side</th><th>time</th>"
      "<th>memory</th><th>wrong</th><th>face area,<br>mean error</th><th>largest<br>error</th><th>missed<br>faces</th>"
      "<th>hidden<br>shown</th></tr>\n";
  for (const CompareRun& run : comparison.runs) text += row(run, comparison.limit_seconds);
  return text + "</table></div>\n";
}

// Null where no run has a picture.
const CompareRun* shown_run(const std::vector<const CompareRun*>& runs) {
  const CompareRun* shown = nullptr;
  for (const CompareRun* run : runs) {
    if (run->pictures.seen.empty()) continue;
    if (shown == nullptr || shown->resolution.value_or(shown_resolution) < shown_resolution) shown = run;
  }
  return shown;
}

std::string figure(const std::string& file, const std::string& caption) {
  return fmt::format("<figure><img src=\"{0}\" alt=\"{1}\"><figcaption>{1}</figcaption></figure>\n", file, caption);
}

std::string pictures(const CompareRun& run) {
  const std::string pixels = run.resolution ? fmt::format(" ({0} x {0} pixels)", *run.resolution) : "";
  std::string text = figure(picture_name(run) + ".png", "what it sees" + pixels);
  if (!run.pictures.wrong.empty()) text += figure(picture_name(run) + "-wrong.png", "where it is wrong, in red");
  return text;
}

std::string work(const std::vector<const CompareRun*>& runs) {
  std::string text;
  for (const CompareRun* run : runs) {
    if (run->counts.empty()) continue;
    const std::string at = run->resolution ? fmt::format("{} pixels: ", *run->resolution) : "";
    text += "<br>" + at + html_text(counts_text(*run)) + "\n";
  }
  return text.empty() ? "" : "<p>Its work: " + text + "</p>\n";
}

constexpr double rounding = 1e-9;  // what is wrong in less of the window is not the algorithm's doing

std::string share_text(double share) {
  return share < rounding ? fmt::format("{:.1g}", share) : fmt::format("{:.2g} %", 100 * share);
}

// At the most pixels, where there are some.
std::string faces_text(const peers::AreaErrors& errors) {
  if (errors.missed_faces == 0 && errors.hidden_faces_shown == 0) return "No face is missed, and no hidden one shown.";
  return fmt::format("Of the faces, {} visible ones are missed, and {} hidden ones shown.", errors.missed_faces,
                     errors.hidden_faces_shown);
}

std::string areas_here(const std::vector<const CompareRun*>& done) {
  const peers::AreaErrors& last = done.back()->areas.value();
  if (last.wrong_share == 0) return "Nothing is wrong. " + faces_text(last);
  if (last.wrong_share < rounding)
    return fmt::format("Right but for rounding: {} of the window. ", share_text(last.wrong_share)) + faces_text(last);
  std::string text;
  for (const CompareRun* run : done) {
    text += text.empty() ? "The wrong face is in " : ", ";
    text += share_text(run->areas.value().wrong_share);
    if (text.find("window") == std::string::npos) text += " of the window";
    if (run->resolution) text += fmt::format(" at {}{}", *run->resolution, run == done.front() ? " pixels a side" : "");
  }
  return text + ". " + faces_text(last);
}

// Returns what this peer sees of the scene, for a reader who asks how wrong it is here.
std::string here(const std::vector<const CompareRun*>& runs) {
  std::vector<const CompareRun*> done;
  for (const CompareRun* run : runs) {
    if (run->end == CompareEnd::done) done.push_back(run);
  }
  if (done.empty()) return "No result; the table says why.";
  if (done.back()->areas) return areas_here(done);
  const peers::LineErrors& lines = done.back()->lines.value();
  return fmt::format("Of the visible lines {} are missing, and {} are drawn though they are hidden.",
                     share_text(lines.missing_share), share_text(lines.hidden_share));
}

std::string section(const std::vector<const CompareRun*>& runs) {
  const peers::Peer& peer = runs.front()->peer;
  const char* precision = peer.computed_at == peers::ComputedAt::image_precision ? "image" : "object";
  std::string text =
      fmt::format("<h2 id=\"{}\">{}</h2>\n<p class=\"source\">{}; {} precision</p>\n<p>{}</p>\n<p>{}</p>\n", peer.name,
                  html_text(peer.title), html_text(peer.source), precision, html_text(peer.does), html_text(peer.errs));
  text += fmt::format("<p><b>In this scene:</b> {}</p>\n", here(runs));
  if (const CompareRun* shown = shown_run(runs)) text += pictures(*shown);
  return text + work(runs);
}

std::string scene_line(const Comparison& comparison) {
  return fmt::format("<p>{}, camera {}: {} faces, {} polygons in view, {} faces visible.</p>\n",
                     html_text(comparison.scene), html_text(comparison.camera), comparison.faces, comparison.polygons,
                     comparison.visible_faces);
}

}  // namespace

std::string compare_plot(const Comparison& comparison) {
  LinePlot plot;
  plot.title = "Error against time";
  plot.x_label = "processor time, seconds";
  plot.y_label = "part of the window with the wrong face";
  double least = 1;
  double most = 1e-3;
  for (const CompareRun& run : comparison.runs) {
    if (run.end != CompareEnd::done || !run.areas) continue;
    const double seconds = std::max(run.seconds, shortest_seconds);
    least = std::min(least, seconds);
    most = std::max(most, seconds);
    series_of(run, plot.series).points.push_back({seconds, run.areas->wrong_share, false});
  }
  plot.x_first = std::pow(10, std::floor(std::log10(least)));
  plot.x_last = std::pow(10, std::ceil(std::log10(most)));
  return plot_svg(plot);
}

std::string compare_page(const Comparison& comparison) {
  std::string text = head + scene_line(comparison) + explanation + table(comparison) + compare_plot(comparison);
  for (const auto& runs : by_peer(comparison)) text += section(runs);
  return text + "</body>\n</html>\n";
}

}  // namespace sightline::cli
