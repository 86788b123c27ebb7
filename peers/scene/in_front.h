// Which of two flat polygons is in front of the other where their images overlap.
//
// In:  two polygons of the scene that do not pass through each other, and the overlap of their images.
// Out: whether the first one is nearer to the eye there.
// Holds: is_in_front(a, b) != is_in_front(b, a). The order is read where their depths differ most over the overlap: the
//      depths of planes are affine, so that is at a corner of it. Polygons in one plane (decided exactly, on the
//      input's coordinates) have the order that sightline gives them: one that looks at the eye is in front, of two
//      alike the lower face, and of one face the lower facet.
// Complexity: O(corners of the overlap).
// Errors: none. Depths are double, so that planes less apart than a rounding error may be told in the wrong order.
#pragma once

#include "peers/scene/convex_ring.h"
#include "peers/scene/flat_scene.h"

namespace sightline::peers {

[[nodiscard]] bool is_in_front(const FlatPolygon& a, const FlatPolygon& b, const ConvexRing& overlap,
                               const CutMesh& mesh);

}  // namespace sightline::peers
