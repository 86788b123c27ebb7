#include "formats/pictures/line_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "formats/pictures/plot_axes.h"

namespace sightline::inline formats {

namespace {

constexpr double marker_size = 4;

std::string shape(Marker marker, double x, double y) {
  const double s = marker_size;
  switch (marker) {
    case Marker::triangle:
      return fmt::format("<path d=\"M{:.2f} {:.2f}l{:.2f} {:.2f}h{:.2f}z\"/>", x, y - 1.2 * s, 1.1 * s, 2 * s,
                         -2.2 * s);
    case Marker::square:
      return fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{}\" height=\"{}\"/>", x - 0.8 * s, y - 0.8 * s,
                         1.6 * s, 1.6 * s);
    case Marker::circle:
      return fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{}\" fill=\"none\" stroke-width=\"1.8\"/>", x, y,
                         1.5 * s);
    case Marker::none:
      break;
  }
  return "";
}

std::string cross(double x, double y) {
  return fmt::format("<path d=\"M{:.2f} {:.2f}l8 8m0 -8l-8 8\" stroke-width=\"2\"/>", x - 4, y - 4);
}

std::string ring(double x, double y) {
  return fmt::format(
      "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"9\" fill=\"none\" stroke-width=\"1.2\" class=\"doubtful\"/>", x, y);
}

// The line is broken where a point has no result.
std::string line(const PlotSeries& series, const PlotAxes& axes) {
  std::string path;
  char command = 'M';
  for (const PlotPoint& point : series.points) {
    if (!point.y) {
      command = 'M';
      continue;
    }
    path += fmt::format("{}{:.2f} {:.2f}", command, axes.x(point.x), axes.y(*point.y));
    command = 'L';
  }
  const char* dash = series.marker == Marker::none ? " stroke-dasharray=\"6 4\"" : "";
  return fmt::format("<path class=\"curve\" d=\"{}\" fill=\"none\" stroke-width=\"1.6\"{}/>\n", path, dash);
}

std::string markers(const PlotSeries& series, std::size_t row, const PlotAxes& axes) {
  std::string text;
  for (const PlotPoint& point : series.points) {
    const double x = axes.x(point.x);
    if (!point.y) {
      text += cross(x, axes.no_result_y(row));
    } else if (series.marker != Marker::none) {
      text += shape(series.marker, x, axes.y(*point.y));
      if (point.doubtful) text += ring(x, axes.y(*point.y));
    }
  }
  return text;
}

std::string drawn(const PlotSeries& series, std::size_t row, const PlotAxes& axes) {
  return fmt::format("<g data-series=\"{0}\" stroke=\"{1}\" fill=\"{1}\">\n{2}{3}\n</g>\n", series.name, series.colour,
                     line(series, axes), markers(series, row, axes));
}

std::string legend_entry(const PlotSeries& series, double x, double y) {
  const char* dash = series.marker == Marker::none ? " stroke-dasharray=\"6 4\"" : "";
  return fmt::format(
      "<g stroke=\"{0}\" fill=\"{0}\"><path d=\"M{1} {2}h28\" stroke-width=\"1.6\"{3}/>{4}</g>"
      "<text x=\"{5}\" y=\"{6}\">{7}</text>\n",
      series.colour, x, y, dash, shape(series.marker, x + 14, y), x + 36, y + 4, series.name);
}

std::string legend(const LinePlot& plot) {
  const double x = PlotAxes::right + 16;
  double y = PlotAxes::top + 10;
  std::string text;
  for (const PlotSeries& series : plot.series) {
    text += legend_entry(series, x, y);
    y += 22;
  }
  const auto add_sign = [&](const std::string& sign, const std::string& meaning) {
    if (meaning.empty()) return;
    text += fmt::format("<g stroke=\"#333\">{}</g><text x=\"{}\" y=\"{}\">{}</text>\n", sign, x + 36, y + 4, meaning);
    y += 22;
  };
  add_sign(cross(x + 14, y), plot.no_result);
  add_sign(ring(x + 14, y), plot.doubtful);
  return text;
}

}  // namespace

std::string plot_svg(const LinePlot& plot) {
  const PlotAxes axes(plot);
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "font-family=\"Helvetica, Arial, sans-serif\" font-size=\"12\" fill=\"#222\" stroke-linejoin=\"round\">\n"
      "<title>{2}</title>\n<rect width=\"{0}\" height=\"{1}\" fill=\"white\"/>\n",
      PlotAxes::width, PlotAxes::height, plot.title);
  text += axes.drawn();
  for (std::size_t i = 0; i < plot.series.size(); ++i) text += drawn(plot.series[i], i, axes);
  return text + legend(plot) + "</svg>\n";
}

}  // namespace sightline::inline formats
