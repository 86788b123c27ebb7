#include "cli/stability/stability_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "formats/pictures/line_plot.h"
#include "formats/writing/csv_text.h"
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

}  // namespace sightline::cli
