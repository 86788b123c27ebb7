// A flat polygon against the plane of another one: on which side it is, and its two parts where it is on both.
//
// In:  a flat convex polygon and a depth plane.
// Out: the side, as the eye sees it; the parts, which keep the polygon's face, facet, facing and plane.
// Holds: both parts are convex and counter-clockwise; corners that a part keeps are the polygon's own, bit for bit; the
//      two corners where the plane cuts are the same in both parts, so that no pixel's centre falls between them. Each
//      part is on one side of the plane: it is not cut there again.
// Tolerance: a corner is on the plane where its depth differs by no more than `touching` times the sizes of both
//      planes' coefficients. Polygons that share an edge differ there by what rounding the image's points (half of
//      2^-40) and the planes' coefficients makes of it; without the tolerance every mesh would be cut along its own
//      edges. What it costs: where two polygons are nearer to each other in depth than that, either may come out in
//      front. For planes that meet at an angle this is within some 2^-38 of their common line in the image; for
//      parallel ones, everywhere.
// Complexity: O(k) for k corners. Errors: none; split needs a polygon that is across the plane.
// Source: slides 001 (depth sort, tests 3 and 4, and its last step; makeBSP's "split all polygons according to F").
#pragma once

#include <cstdint>

#include "peers/scene/flat_scene.h"

namespace sightline::peers {

constexpr double touching = 0x1p-39;

// `within` says that no corner is off the plane.
enum class Side : std::uint8_t { nearer, farther, within, across };

[[nodiscard]] Side side_of(const FlatPolygon& polygon, const DepthPlane& plane);

struct Halves {
  FlatPolygon nearer;
  FlatPolygon farther;
};

[[nodiscard]] Halves split(const FlatPolygon& polygon, const DepthPlane& plane);

}  // namespace sightline::peers
