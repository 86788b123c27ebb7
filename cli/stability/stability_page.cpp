#include <fmt/format.h>

#include <array>

#include "cli/stability/stability_report.h"
#include "formats/writing/html_text.h"

namespace sightline::cli {

namespace {

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

std::string stability_page(const std::vector<FamilyRuns>& all) {
  std::string text = head;
  for (const FamilyRuns& runs : all) text += section(runs);
  return text + "</body>\n</html>\n";
}

}  // namespace sightline::cli
