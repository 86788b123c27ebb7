// Visible polygons: the visible segments of each face, linked to rings.
//
// In:  the sweep's visible segments.
// Out: polygons with one outer ring (counter-clockwise in the image, y up) and its holes (clockwise). Holds
//      (validate(polygons, ...) checks it):
//   - a ring visits no point twice; its area is not zero and its sign is that of its role;
//   - every segment is in exactly one ring;
//   - the polygons of one face do not overlap; those of a face whose corners are not in one plane stay within one
//     facet each. A polygon with 2 * area / perimeter below one grid spacing is below resolution: it is listed, but
//     its face is not called visible for it (docs/design.md, section 3); without rounding, not if that is a thousandth or more
//     of the same of all that is in view of its surface.
// Complexity: O(m log m) for m segments.
// Errors: InternalError; in float and double (scene.arithmetic) ArithmeticError instead.
// Source: Fang 1993, section 5.3.1, "Polygon Reconstruction".
// Departures: where several segments leave a point the sharpest turn that keeps the face on the left is taken, and a
// ring that comes back to a point is cut there.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "geometry/mesh/cut_mesh.h"
#include "geometry/numbers/export.h"
#include "geometry/projection/projected_scene.h"
#include "sweep/segments/visible_segments.h"

namespace sightline::inline reconstruct {

using Rational = boost::multiprecision::cpp_rational;

struct VisiblePolygon {
  FaceId face;
  FacetId facet;                 // a facet of the polygon's plane
  std::uint32_t first_ring = 0;  // the outer ring; its holes follow
  std::uint32_t ring_count = 0;
  double area = 0;       // in the image, window units squared (the window's area is 4)
  double perimeter = 0;  // holes included, window units
  bool below_resolution = false;
};

struct VisiblePolygons {
  std::vector<VisiblePolygon> polygons;      // by face, then facet, then by the first point of the outer ring
  std::vector<std::uint32_t> ring_begin{0};  // per ring and one more, into ring_segments
  std::vector<SegmentId> ring_segments;      // in ring order; the ring's points are their start points
  [[nodiscard]] std::size_t ring_count() const { return ring_begin.size() - 1; }
  [[nodiscard]] std::span<const SegmentId> ring(std::size_t r) const {
    return std::span(ring_segments).subspan(ring_begin[r], ring_begin[r + 1] - ring_begin[r]);
  }
};

[[nodiscard]] SIGHTLINE_EXPORT VisiblePolygons reconstruct_polygons(const ProjectedScene& scene,
                                                                    const VisibleSegments& segments);

// Returns the exact area of a polygon (outer ring minus holes), in grid units squared, be its points on the grid or not.
[[nodiscard]] SIGHTLINE_EXPORT Rational exact_area(const ProjectedScene& scene, const VisibleSegments& segments,
                                                   const VisiblePolygons& polygons, std::size_t polygon);

// Returns what of the above does not hold, one line each, with the ids; nothing for a valid value.
[[nodiscard]] SIGHTLINE_EXPORT std::vector<std::string> validate(const VisiblePolygons& polygons,
                                                                 const ProjectedScene& scene,
                                                                 const VisibleSegments& segments);

}  // namespace sightline::inline reconstruct
