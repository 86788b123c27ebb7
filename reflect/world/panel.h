// Flat light panels.
//
// A panel is a planar polygon, convex or not. Its front is where its corners are seen counter-clockwise. It is no part
// of the surface: the camera does not see it, but in a mirror; there it is in the way of other panels with both sides.
// Source: Koucky 2014, 3.9 (flat panel).
#pragma once

#include <string>
#include <vector>

#include "geometry/mesh/cut_mesh.h"
#include "geometry/numbers/errors.h"
#include "geometry/numbers/export.h"

namespace sightline::inline reflect {

enum class Emits : std::uint8_t { front, both };

struct Panel {
  std::string name;
  std::vector<Point3> corners;
  Emits emits = Emits::both;
};

// Returns the panel as the only face of a mesh. Throws PanelError for a panel that is no planar polygon: fewer than
// three corners, no area, a corner that bounds nothing, corners beside its plane, a border that crosses itself.
// Precondition: coordinates are finite.
[[nodiscard]] SIGHTLINE_EXPORT Mesh panel_mesh(const Panel& panel);

}  // namespace sightline::inline reflect
