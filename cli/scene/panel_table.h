// One [[panel]] of a scene file.
//
// Errors: InputError with file and line, also where the corners are no planar polygon.
#pragma once

#include "cli/scene/toml_reader.h"
#include "reflect/world/panel.h"

namespace sightline::cli {

[[nodiscard]] Panel read_panel(const TomlReader& table);

}  // namespace sightline::cli
