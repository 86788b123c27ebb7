// A surface cut along the frame of a camera with a lens.
//
// In:  a mesh of which nothing was cut, and a camera with a lens (lens_image.h).
// Out: the mesh, cut so that each facet lies inside the frame or outside of it, and which of them lie outside.
// Holds: exact: the cuts are in the planes through the eye and the sides of the frame. Faces and the input's vertices keep
//      their numbers. Neighbours are cut at the same points. Facets behind the eye, or beside the window, may count as outside
//      or not: they are out of view.
// Method: a facet that a side of the frame enters is cut all along that side's plane (facet_cutter.h), so that pieces are
//      convex, though the frame need not be. On which side of the frame a piece lies is said by one place inside it.
// Complexity: O(n m) comparisons of doubles for the n facets near the border of a frame of m sides; integers of any size for
//      those that the border crosses.
// Rejected: clipping at the frame, as at the window. A frame that bulges inwards leaves parts that are not convex, of edges
//      several stretches; too much stands on facets' being convex. An overlay of what was found with the frame: hidden
//      facets have to be parted there, too.
#pragma once

#include <memory>

#include "geometry/mesh/cut_mesh.h"
#include "geometry/projection/camera.h"

namespace sightline::inline geometry {

// Precondition: the mesh is not cut, and the camera has a lens.
[[nodiscard]] CutMesh cut_along_frame(const CutMesh& mesh, const Camera& camera);

// Returns the name that a surface (surface_of in facet_plane.h) of such a mesh had before it was cut; of any other mesh the
// same.
[[nodiscard]] FacetId surface_before_frame(const CutMesh& mesh, FacetId surface);

}  // namespace sightline::inline geometry
