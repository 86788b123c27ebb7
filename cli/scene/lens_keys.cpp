#include "cli/scene/lens_keys.h"

#include <fmt/format.h>

#include <algorithm>

namespace sightline::cli {

namespace {

Lens read_brown(const TomlReader& table) {
  const std::vector<double> coefficients = table.numbers("distortion");
  if (const auto lens = brown_lens(coefficients)) return *lens;
  if (coefficients.size() == 12 || coefficients.size() == 14)
    table.fail(
        "distortion",
        fmt::format("'distortion' has {} numbers; thin prisms and tilted sensors are not modelled; calibrate without "
                    "them, to 8 numbers",
                    coefficients.size()));
  table.fail("distortion",
             fmt::format("'distortion' has {} numbers; give k1, k2, p1, p2, or these and k3, or these and k4, k5, k6",
                         coefficients.size()));
}

Lens read_fisheye(const TomlReader& table) {
  const std::vector<double> coefficients = table.numbers("fisheye");
  if (coefficients.size() != 4) {
    table.fail("fisheye", fmt::format("'fisheye' has {} numbers; give k1, k2, k3, k4, with 0 for what is missing",
                                      coefficients.size()));
  }
  Lens lens;
  lens.model = LensModel::fisheye;
  std::ranges::copy(coefficients, lens.radial.begin());
  return lens;
}

}  // namespace

LensKeys read_lens(const TomlReader& table) {
  LensKeys keys;
  if (table.has("distortion") && table.has("fisheye"))
    table.fail("fisheye", "the camera has both 'distortion' and 'fisheye'; give one of them");
  if (table.has("distortion")) keys.lens = read_brown(table);
  if (table.has("fisheye")) keys.lens = read_fisheye(table);
  if (!table.has("frame_tolerance")) return keys;
  if (!bends(keys.lens))
    table.fail("frame_tolerance",
               "'frame_tolerance' is for cameras with a lens; give 'distortion' or 'fisheye', or leave it out");
  keys.frame_tolerance = table.number("frame_tolerance");
  return keys;
}

std::optional<Lens> brown_lens(const std::vector<double>& coefficients) {
  if (coefficients.size() != 4 && coefficients.size() != 5 && coefficients.size() != 8) return std::nullopt;
  std::vector<double> all = coefficients;
  all.resize(8);
  Lens lens;
  lens.radial = {all[0], all[1], all[4], all[5], all[6], all[7]};
  lens.tangential = {all[2], all[3]};
  return lens;
}

}  // namespace sightline::cli
