// The [coincidence] of a scene file: what counts as lying on each other, and what is done about it.
//
// distance is a share of the surface's size, from 0 (only what lies in one plane, exactly) to below 1. The policy "exact" takes every
// corner for what it says; "snap" has panels that lie on a face, or on each other, count as in one plane.
// Errors: InputError with file and line.
#pragma once

#include "cli/scene/toml_reader.h"
#include "reflect/world/reflection_options.h"

namespace sightline::cli {

void read_coincidence(const TomlReader& table, ReflectionOptions& options);

}  // namespace sightline::cli
