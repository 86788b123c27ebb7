#include "formats/pictures/plot_axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace sightline::inline formats {

namespace {

constexpr double row_height = 30;  // for 0, and for what has no result
constexpr double margin = 12;      // between the frame and the first and last value
constexpr int most_ticks = 9;

std::string power_of_ten(int exponent) {
  constexpr std::array digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  if (exponent == 0) return "1";
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char c : std::to_string(std::abs(exponent))) text += digits.at(static_cast<std::size_t>(c - '0'));
  return text;
}

// Returns every how many decades there is a tick.
int tick_step(int decades) {
  for (const int step : {1, 2, 3, 5, 10, 20, 50, 100}) {
    if (decades / step <= most_ticks) return step;
  }
  return 200;
}

}  // namespace

PlotAxes::PlotAxes(const LinePlot& plot) : plot_(plot) {
  for (const PlotSeries& series : plot.series) {
    for (const PlotPoint& point : series.points) {
      some_without_result_ = some_without_result_ || !point.y;
      if (!point.y || *point.y <= 0) continue;
      lowest_decade_ = std::min(lowest_decade_, static_cast<int>(std::floor(std::log10(*point.y))));
      highest_decade_ = std::max(highest_decade_, static_cast<int>(std::ceil(std::log10(*point.y))));
    }
  }
}

double PlotAxes::decade_x(double exponent) const {
  const double first = std::log10(plot_.x_first);
  const double part = (exponent - first) / (std::log10(plot_.x_last) - first);
  return left + margin + part * (right - left - 2 * margin);
}

double PlotAxes::x(double value) const { return decade_x(std::log10(value)); }

double PlotAxes::decade_y(double exponent) const {
  const double highest = top + (some_without_result_ ? row_height : 0) + 8;
  const double lowest = bottom - row_height - 8;
  return lowest + (exponent - lowest_decade_) / (highest_decade_ - lowest_decade_) * (highest - lowest);
}

double PlotAxes::y(double value) const { return value > 0 ? decade_y(std::log10(value)) : bottom - row_height / 2; }

double PlotAxes::no_result_y(std::size_t row) { return top + row_height / 2 + 8 * (static_cast<double>(row % 3) - 1); }

std::string PlotAxes::x_ticks() const {
  const auto [low, high] = std::minmax({std::log10(plot_.x_first), std::log10(plot_.x_last)});
  const int step = tick_step(static_cast<int>(high - low));
  std::string text;
  for (int k = static_cast<int>(std::ceil(low - 1e-9)); k <= high + 1e-9; ++k) {
    if (k % step != 0) continue;
    const double at = decade_x(k);
    text += fmt::format(
        "<path d=\"M{0:.2f} {1}v5\" stroke=\"#222\"/><text x=\"{0:.2f}\" y=\"{2}\" "
        "text-anchor=\"middle\">{3}</text>\n",
        at, bottom, bottom + 20, power_of_ten(k));
  }
  return text;
}

std::string PlotAxes::y_ticks() const {
  const int step = tick_step(highest_decade_ - lowest_decade_);
  std::string text;
  for (int k = lowest_decade_; k <= highest_decade_; ++k) {
    if (k % step != 0) continue;
    text += fmt::format(
        "<path d=\"M{0} {1:.2f}h{2}\" stroke=\"#e4e4e4\"/><path d=\"M{0} {1:.2f}h-5\" stroke=\"#222\"/>"
        "<text x=\"{3}\" y=\"{4:.2f}\" text-anchor=\"end\">{5}</text>\n",
        left, decade_y(k), right - left, left - 9, decade_y(k) + 4, power_of_ten(k));
  }
  return text;
}

std::string PlotAxes::labels() const {
  const double middle = (left + right) / 2;
  std::string text = fmt::format(
      "<text x=\"{}\" y=\"24\" font-size=\"15\" font-weight=\"bold\">{}</text>\n"
      "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n"
      "<text transform=\"translate(20 {}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n"
      "<text x=\"{}\" y=\"{}\" text-anchor=\"end\">0</text>\n",
      left, plot_.title, middle, bottom + 44, plot_.x_label, (top + bottom) / 2, plot_.y_label, left - 9, y(0) + 4);
  if (some_without_result_) {
    text += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>\n", left - 9, top + row_height / 2 + 4,
                        "none");
  }
  return text;
}

std::string PlotAxes::drawn() const {
  std::string text = fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"#f4f4f4\"/>\n", left,
                                 bottom - row_height, right - left, row_height);
  if (some_without_result_) {
    text += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"#f4f4f4\"/>\n", left, top,
                        right - left, row_height);
  }
  text += y_ticks() + x_ticks();
  text += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#222\"/>\n", left, top,
                      right - left, bottom - top);
  return text + labels();
}

}  // namespace sightline::inline formats
