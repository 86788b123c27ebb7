// One [[panel]] of a scene file.
//
// A panel has a name that is a word, and exactly one of these forms (units of the mesh):
//   polygon     corners
//   rectangle   center, normal or target, size, and optionally up
//   disc        center, normal or target, radius
// and optionally what it emits, and its planarity. A rectangle's width lies across up, and its front is where the normal points, or
// where the target is. A disc is a polygon of disc_corners equal sides and of the circle's own area; its border is nowhere further
// from the circle than disc_error, as a share of the radius.
// Errors: InputError with file and line, also for corners that are no planar polygon.
#pragma once

#include "cli/scene/toml_reader.h"
#include "reflect/world/panel.h"

namespace sightline::cli {

constexpr int disc_corners = 64;
constexpr double disc_error = 1e-3;

[[nodiscard]] Panel read_panel(const TomlReader& table);

}  // namespace sightline::cli
