// Which sightline a program runs with: that of a shared library may be newer than the headers.
#pragma once

#include "geometry/numbers/export.h"

namespace sightline {

// "MAJOR.MINOR.PATCH".
[[nodiscard]] SIGHTLINE_EXPORT const char* version();

}  // namespace sightline
