// One [[panel]] and the [reflection] of a scene file.
//
// A panel has a name that is a word, corners, and optionally what it emits; a reflection has a mode and what belongs to it.
// Errors: InputError with file and line, also for corners that are no planar polygon.
#pragma once

#include "cli/scene/toml_reader.h"
#include "reflect/world/panel.h"
#include "reflect/world/reflection_options.h"

namespace sightline::cli {

[[nodiscard]] Panel read_panel(const TomlReader& table);
[[nodiscard]] ReflectionOptions read_reflection(const TomlReader& table);

}  // namespace sightline::cli
