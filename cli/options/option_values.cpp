#include "cli/options/option_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace sightline::cli {

double parsed_number(std::string_view text, std::string_view option) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
    throw CommandLineError(fmt::format("{}: '{}' is not a number; write one, like 40 or 0.5", option, text));
  }
  return value;
}

int parsed_whole_number(std::string_view text, std::string_view option, int least, int most) {
  const double value = parsed_number(text, option);
  if (value != std::floor(value) || value < least || value > most) {
    throw CommandLineError(
        fmt::format("{}: '{}' is not a whole number from {} to {}; write one", option, text, least, most));
  }
  return static_cast<int>(value);
}

Vector3 parsed_vector(std::string_view text, std::string_view option) {
  const auto parts = split(text, ',');
  if (parts.size() != 3)
    throw CommandLineError(fmt::format("{}: '{}' is not of the form X,Y,Z; write three numbers", option, text));
  return {parsed_number(parts[0], option), parsed_number(parts[1], option), parsed_number(parts[2], option)};
}

Precision parsed_precision(const std::string& arithmetic, const std::string& grid_bits) {
  Precision precision{grid_bits.empty() ? Arithmetic::unrounded : Arithmetic::exact, default_grid_bits};
  if (!arithmetic.empty()) {
    const auto named = arithmetic_named(arithmetic);
    if (!named)
      throw CommandLineError(
          fmt::format("--arithmetic: '{}' is not float, double, exact or unrounded; choose one of them", arithmetic));
    precision.arithmetic = *named;
  }
  if (!grid_bits.empty() && precision.arithmetic == Arithmetic::unrounded)
    throw CommandLineError("--grid-bits: there is no grid with --arithmetic unrounded; leave one of them away");
  if (!grid_bits.empty())
    precision.grid_bits = parsed_whole_number(grid_bits, "--grid-bits", smallest_grid_bits, default_grid_bits);
  return precision;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

}  // namespace sightline::cli
