// The keys of a calibrated camera's table that say its lens.
//
// In:  `distortion` = [k1, k2, p1, p2, k3, k4, k5, k6], of which 4, 5 or 8 are given, or `fisheye` = [k1, k2, k3, k4], both in
//      OpenCV's order; and `frame_tolerance`, in pixels.
// Out: the lens; without these keys one that does nothing.
// Errors: InputError with file, line and key.
#pragma once

#include "cli/scene/toml_reader.h"
#include "geometry/projection/camera.h"

namespace sightline::cli {

struct LensKeys {
  Lens lens;
  double frame_tolerance = default_frame_tolerance;
};

[[nodiscard]] LensKeys read_lens(const TomlReader& table);

// Returns the lens of OpenCV's coefficients; nothing where these are not 4, 5 or 8.
[[nodiscard]] std::optional<Lens> brown_lens(const std::vector<double>& coefficients);

}  // namespace sightline::cli
