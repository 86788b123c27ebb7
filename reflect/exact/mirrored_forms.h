// A mirror's plane, and the camera's forms on what is seen in it, certified: the filter before mirror_view.h.
//
// In:  a camera; three points of a plane that has the camera's eye in front.
// Out: forms of a point of space: `mirror`, its height over the mirror, up to a positive factor; x, y and w, what the camera
//      gives its mirror image. On which side of a plane the mirror camera is, and the image of a convex polygon, where
//      the radii suffice to tell.
// Holds: every coefficient holds the true one; a side or an image is what MirrorView says, number for number.
// Complexity: O(1), and O(k) for k corners.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "geometry/numbers/image_point.h"
#include "geometry/projection/camera.h"
#include "reflect/exact/bounded_form.h"
#include "reflect/regions/sheets.h"

namespace sightline::inline reflect {

// Returns the plane through three points, positive where they are seen counter-clockwise.
[[nodiscard]] BoundedForm bounded_form(const std::array<Point3, 3>& points);

struct MirroredForms {
  std::array<Point3, 3> plane;  // counter-clockwise seen from the eye
  BoundedForm mirror;
  Bounded twice;                   // 2 / (n . n), with the mirror's normal n
  std::array<Bounded, 3> factors;  // how often `mirror` is in the next three, with a minus
  BoundedForm x, y, w;
};

[[nodiscard]] MirroredForms mirrored_forms(const Camera& camera, const std::array<Point3, 3>& plane);

// The side is empty where it is not certain, on the plane for one.
[[nodiscard]] std::optional<Sign> certain_side_of_centre(const MirroredForms& forms, const Camera& camera,
                                                         const BoundedForm& plane);

// The image is empty where it is not certain on which side of the mirror or of the window's bounds a corner is, or
// which grid point is its image. Corners of the mirror's own, `plane`, are known to be in its plane.
[[nodiscard]] std::optional<ImagePolygon> certain_image(const MirroredForms& forms, const Camera& camera,
                                                        std::span<const Point3> corners, int grid_bits);

}  // namespace sightline::inline reflect
