// A log-log plot has a frame: it says where values go, and has ticks at powers of ten, and rows for 0 and for what has
// no result.
#pragma once

#include <string>

#include "formats/pictures/line_plot.h"

namespace sightline::inline formats {

class PlotAxes {
 public:
  static constexpr int width = 780;
  static constexpr int height = 430;
  static constexpr double left = 84;
  static constexpr double right = 560;
  static constexpr double top = 44;
  static constexpr double bottom = 366;

  explicit PlotAxes(const LinePlot& plot);

  [[nodiscard]] double x(double value) const;
  [[nodiscard]] double y(double value) const;
  // Returns the y for points without a result of the series that is drawn as number `row`.
  [[nodiscard]] static double no_result_y(std::size_t row);

  // Returns everything but the curves and the legend.
  [[nodiscard]] std::string drawn() const;

 private:
  [[nodiscard]] double decade_x(double exponent) const;
  [[nodiscard]] double decade_y(double exponent) const;
  [[nodiscard]] std::string x_ticks() const;
  [[nodiscard]] std::string y_ticks() const;
  [[nodiscard]] std::string labels() const;

  const LinePlot& plot_;
  bool some_without_result_ = false;
  int lowest_decade_ = -1;
  int highest_decade_ = 0;
};

}  // namespace sightline::inline formats
