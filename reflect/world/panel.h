// Flat light panels.
//
// A panel is a polygon in a plane, convex or not. Its front is where its corners are seen counter-clockwise. It is no part
// of the surface: the camera does not see it, but in a mirror; there it is in the way of other panels with both sides.
//
// What corners are written as is rounded, so a tilted panel is hardly ever in one plane exactly. A panel is what its corners
// mean: a plane is fitted to them, and those that are off it by no more than `planarity` are taken on it.
// Source: Koucky 2014, 3.9 (flat panel).
#pragma once

#include <array>
#include <string>
#include <vector>

#include "geometry/mesh/cut_mesh.h"
#include "geometry/numbers/errors.h"
#include "geometry/numbers/export.h"

namespace sightline::inline reflect {

enum class Emits : std::uint8_t { front, both };

constexpr double default_planarity = 1e-6;

struct Panel {
  std::string name;
  std::vector<Point3> corners;
  Emits emits = Emits::both;
  double planarity = default_planarity;  // how far corners may be off their plane, as a share of the panel's size
};

struct FittedPanel {
  std::vector<Point3> corners;  // as given where they are in one plane, exactly; else on the plane, rounded
  double deviation = 0;         // the largest distance of a corner, as given, from that plane, in units of the scene
};

// The plane runs through the mean of the corners, across the polygon's area vector (Newell's normal). A panel's size is the largest
// distance between two corners. Throws PanelError where a corner is too far off; it names the worst one, and where it would be on
// the plane. Complexity: O(k^2) for k corners. Preconditions: coordinates are finite; planarity >= 0.
[[nodiscard]] SIGHTLINE_EXPORT FittedPanel fitted_panel(const Panel& panel);

// Returns the fitted panel as the only face of a mesh: of one plane where its corners are, else of triangles, which differ from it
// by what rounding moved corners. Throws PanelError for a panel that is no planar polygon: fewer than three corners, no area, a
// corner that bounds nothing, corners beside its plane, a border that crosses itself. Precondition: as above.
[[nodiscard]] SIGHTLINE_EXPORT Mesh panel_mesh(const Panel& panel);

// Three points of the plane of such a mesh; in front of it they are seen counter-clockwise. Where it is of triangles they are
// corners that are far apart, since of three that are nearly on one line rounding turns the plane.
[[nodiscard]] std::array<Point3, 3> panel_plane(const CutMesh& panel);

}  // namespace sightline::inline reflect
