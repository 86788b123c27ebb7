// The [reflection] of a scene file: a mode and what belongs to it.
// Errors: InputError with file and line.
#pragma once

#include "cli/scene/toml_reader.h"
#include "reflect/world/reflection_options.h"

namespace sightline::cli {

[[nodiscard]] ReflectionOptions read_reflection(const TomlReader& table);

}  // namespace sightline::cli
