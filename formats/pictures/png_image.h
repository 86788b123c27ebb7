// A picture as PNG bytes.
//
// In:  colours row by row from the top, width x height of them. Out: the file's bytes, equal in every run.
// Errors: std::runtime_error where libpng fails.
#pragma once

#include <span>
#include <string>

#include "formats/writing/face_shade.h"

namespace sightline::inline formats {

[[nodiscard]] std::string png_image(int width, int height, std::span<const Colour> colours);

}  // namespace sightline::inline formats
