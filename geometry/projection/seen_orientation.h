// How three points turn as a camera sees them: exactly as its own rows make the image.
//
// In:  a camera, three points.
// Out: +1 where they are seen counter-clockwise, -1 where clockwise, 0 where they are seen on one line.
// Symmetries: a turn of the arguments changes nothing, an exchange of two the sign.
// Method: of a pinhole camera it is the side of their plane on which the eye is, orient3d. The eye of an orthographic camera
//      is a direction that was rounded by itself, and nearly, not exactly, the one that its rows for x and y do not see; so
//      there the image is asked: a filter in certified numbers, then integers.
// Complexity: O(1).
#pragma once

#include "geometry/numbers/predicates.h"
#include "geometry/projection/camera.h"

namespace sightline::inline geometry {

[[nodiscard]] Sign seen_orientation(const Camera& camera, const Point3& a, const Point3& b, const Point3& c,
                                    predicates::Counts* counts = nullptr);

namespace seen_orientation_tiers {
// These are the tiers for orthographic cameras; the first is empty where it is not certain.
[[nodiscard]] std::optional<Sign> filtered(const Camera& camera, const Point3& a, const Point3& b, const Point3& c);
[[nodiscard]] Sign exact(const Camera& camera, const Point3& a, const Point3& b, const Point3& c);
}  // namespace seen_orientation_tiers

}  // namespace sightline::inline geometry
