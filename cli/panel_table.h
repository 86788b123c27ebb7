// One [[panel]] of a scene file.
//
// Errors: InputError with file and line, also where the corners are no planar polygon.
#pragma once

#include "cli/toml_reader.h"
#include "reflect/panel.h"

namespace sightline {

[[nodiscard]] Panel read_panel(const TomlReader& table);

}  // namespace sightline
