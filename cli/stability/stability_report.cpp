#include "cli/stability/stability_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "formats/pictures/line_plot.h"
#include "formats/writing/escaped_text.h"
#include "formats/writing/text_buffer.h"

namespace sightline::cli {

namespace {

void write_row(const ExtremeFamily& family, const StabilityRun& run, TextBuffer& out) {
  out << family.name << ',' << run.value << ',' << to_string(run.arithmetic) << ','
      << static_cast<std::uint32_t>(run.grid_bits) << ',' << std::uint64_t{run.faces} << ','
      << (run.finished ? "yes" : "no") << ',' << (run.broken.empty() ? "yes" : "no") << ',' << csv_text(run.broken)
      << ',';
  if (run.finished) out << run.area_error;
  out << ',';
  if (run.finished) out << run.mislabelled_area;
  out << ',' << run.grid_bound << ',';
  if (run.finished) out << run.seconds;
  out << '\n';
}

std::vector<StabilityRun> of_arithmetic(const FamilyRuns& runs, Arithmetic arithmetic) {
  std::vector<StabilityRun> chosen;
  std::copy_if(runs.runs.begin(), runs.runs.end(), std::back_inserter(chosen),
               [&](const StabilityRun& run) { return run.arithmetic == arithmetic; });
  return chosen;
}

// Colours that the colour-blind tell apart (Okabe and Ito 2008).
PlotSeries curve(const FamilyRuns& runs, Arithmetic arithmetic) {
  constexpr std::array colours{"#d55e00", "#0072b2", "#009e73"};
  constexpr std::array markers{Marker::triangle, Marker::square, Marker::circle};
  const auto index = static_cast<std::size_t>(arithmetic);
  PlotSeries series{to_string(arithmetic), colours.at(index), markers.at(index), {}};
  for (const StabilityRun& run : of_arithmetic(runs, arithmetic)) {
    PlotPoint point{run.value, std::nullopt, run.finished && !run.broken.empty()};
    if (run.finished) point.y = run.mislabelled_area;
    series.points.push_back(point);
  }
  return series;
}

PlotSeries bound(const FamilyRuns& runs) {
  PlotSeries series{"what the grid explains", "#777", Marker::none, {}};
  for (const StabilityRun& run : of_arithmetic(runs, Arithmetic::exact)) {
    series.points.push_back({run.value, run.grid_bound, false});
  }
  return series;
}

constexpr const char* head = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<title>sightline: stability</title>
<style>
body { font: 15px/1.5 Georgia, serif; max-width: 62em; margin: 2em auto; padding: 0 1em; color: #222; }
h1, h2 { font-family: Helvetica, Arial, sans-serif; }
table { border-collapse: collapse; font: 12px/1.4 Helvetica, Arial, sans-serif; }
th, td { padding: 2px 10px; text-align: right; border-bottom: 1px solid #ddd; }
th { border-bottom: 1px solid #222; }
td:nth-child(2), td.text { text-align: left; }
tr.broken td { background: #fdf1e7; }
svg { max-width: 100%; height: auto; }
</style>
</head>
<body>
<h1>Stability</h1>
<p>Families of small scenes, each with one parameter that goes to its extreme, in float, in double and in exact
arithmetic. Every result is held against an oracle that computes in rationals and shares no code with the engine. The
plots show which part of the window carries a wrong label; the row 0 at the bottom is no error at all. A cross at the top is a
run that did not finish, a ring marks a result of which an invariant does not hold. Below the dashed line lies what the
grid explains: the image's points are rounded to it once, in every arithmetic. Times are the only numbers here that
differ from run to run.</p>
)";

std::string table_row(const StabilityRun& run) {
  const auto area = [&](double value) { return run.finished ? fmt::format("{:.3g}", value) : std::string(); };
  return fmt::format(
      "<tr{}><td>{:.4g}</td><td>{}</td><td>{}</td><td>{}</td><td>{:.3g}</td><td>{}</td><td "
      "class=\"text\">{}</td></tr>\n",
      run.broken.empty() ? "" : " class=\"broken\"", run.value, to_string(run.arithmetic), area(run.area_error),
      area(run.mislabelled_area), run.grid_bound, run.finished ? fmt::format("{:.3f}", 1000 * run.seconds) : "",
      run.broken.empty() ? "valid" : html_text((run.finished ? "" : "did not finish: ") + run.broken));
}

std::string table(const FamilyRuns& runs) {
  std::string text =
      "<details><summary>All runs</summary>\n<table>\n<tr><th>parameter</th><th>arithmetic</th><th>area error</th>"
      "<th>mislabelled</th><th>the grid explains</th><th>time, ms</th><th>outcome</th></tr>\n";
  for (const StabilityRun& run : runs.runs) text += table_row(run);
  return text + "</table>\n</details>\n";
}

std::string section(const FamilyRuns& runs) {
  std::string text = fmt::format("<h2>{}</h2>\n<p>{}", runs.family->title, runs.family->scene);
  for (const Arithmetic arithmetic : {Arithmetic::single_precision, Arithmetic::double_precision, Arithmetic::exact}) {
    const std::string sentence = finding(runs, arithmetic);
    text += fmt::format("\n<br><b>{}</b>{}", to_string(arithmetic), sentence.substr(sentence.find(':')));
  }
  return text + "</p>\n" + stability_plot(runs) + table(runs);
}

}  // namespace

std::string stability_table(const std::vector<FamilyRuns>& all) {
  TextBuffer out;
  out << "family,parameter,arithmetic,grid_bits,faces,finished,valid,broken,area_error,mislabelled_area,grid_bound,"
         "seconds\n";
  for (const FamilyRuns& runs : all) {
    for (const StabilityRun& run : runs.runs) write_row(*runs.family, run, out);
  }
  return out.take();
}

std::string stability_plot(const FamilyRuns& runs) {
  LinePlot plot;
  plot.title = runs.family->title;
  plot.x_label = runs.family->parameter;
  plot.y_label = "mislabelled part of the window";
  plot.no_result = "did not finish";
  plot.doubtful = "an invariant does not hold";
  plot.x_first = runs.family->values.front();
  plot.x_last = runs.family->values.back();
  plot.series.push_back(bound(runs));
  for (const Arithmetic arithmetic : arithmetics) plot.series.push_back(curve(runs, arithmetic));
  return plot_svg(plot);
}

std::string finding(const FamilyRuns& runs, Arithmetic arithmetic) {
  const std::vector<StabilityRun> of = of_arithmetic(runs, arithmetic);
  const auto count = [&](auto holds) { return std::count_if(of.begin(), of.end(), holds); };
  const auto above = [](const StabilityRun& run) { return run.mislabelled_area > run.grid_bound; };
  const auto first = std::find_if(of.begin(), of.end(), above);
  const auto worst = std::max_element(of.begin(), of.end(), [](const StabilityRun& a, const StabilityRun& b) {
    return a.mislabelled_area < b.mislabelled_area;
  });
  std::string text = fmt::format(
      "{}: {} of {} runs finished, {} of them valid; at worst {:.2g} of the window is mislabelled",
      to_string(arithmetic), count([](const StabilityRun& run) { return run.finished; }), of.size(),
      count([](const StabilityRun& run) { return run.finished && run.broken.empty(); }), worst->mislabelled_area);
  if (first == of.end()) return text + ", never more than the grid explains.";
  return text +
         fmt::format(", more than the grid explains in {} of them, first at {:.3g}.", count(above), first->value);
}

std::string stability_page(const std::vector<FamilyRuns>& all) {
  std::string text = head;
  for (const FamilyRuns& runs : all) text += section(runs);
  return text + "</body>\n</html>\n";
}

}  // namespace sightline::cli
