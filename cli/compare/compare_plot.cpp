#include "cli/compare/compare_plot.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "formats/pictures/line_plot.h"

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

}  // namespace sightline::cli
