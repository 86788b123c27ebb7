// A log-log line plot as SVG, drawn as in a textbook: axes with ticks, labels, a legend; curves differ in colour and in
// marker, so that they can be told apart without colours too.
//
// In:  series of points with x > 0 in any order of the axis (it runs from the first value of `x_values` to the last)
//      and y >= 0.
// Out: a self-contained SVG element of fixed size. y = 0 has a row of its own at the bottom, below the lowest decade; a
//      point without a value has one at the top.
// Errors: none.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace sightline::inline formats {

enum class Marker { triangle, square, circle, none };  // none: a dashed line

struct PlotPoint {
  double x = 0;
  std::optional<double> y;  // none: there is no result
  bool doubtful = false;    // drawn with a ring around it
};

struct PlotSeries {
  std::string name;
  std::string colour;
  Marker marker = Marker::none;
  std::vector<PlotPoint> points;
};

struct LinePlot {
  std::string title;
  std::string x_label;
  std::string y_label;
  std::string no_result;  // what the top row says; empty: every point has a result
  std::string doubtful;   // what a ring means; empty: there is none
  double x_first = 1;
  double x_last = 10;
  std::vector<PlotSeries> series;  // later ones on top
};

[[nodiscard]] std::string plot_svg(const LinePlot& plot);

}  // namespace sightline::inline formats
