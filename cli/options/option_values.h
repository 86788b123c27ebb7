// Values of options: numbers are parsed here and not by CLI11, which goes through the locale.
//
// Errors: CommandLineError, one line with the option and the text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/options/requests.h"
#include "geometry/numbers/arithmetic.h"
#include "geometry/numbers/vector3.h"

namespace sightline::cli {

[[nodiscard]] double parsed_number(std::string_view text, std::string_view option);

// A whole number in [least, most].
[[nodiscard]] int parsed_whole_number(std::string_view text, std::string_view option, int least, int most);

// X,Y,Z
[[nodiscard]] Vector3 parsed_vector(std::string_view text, std::string_view option);

// The dial, from --arithmetic and --grid-bits; empty texts stand for the default: unrounded, or exact on a grid that is named.
[[nodiscard]] Precision parsed_precision(const std::string& arithmetic, const std::string& grid_bits);

[[nodiscard]] std::vector<std::string_view> split(std::string_view text, char separator);

}  // namespace sightline::cli
