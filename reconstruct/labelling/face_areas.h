// Do the triangles of a face cover it, the right way round?
//
// In:  a labelled mesh with every id in range, sorted by face; the mesh it refines, and the same without the lines
//      along which it was cut; the projected scene.
// Out: messages with ids: faces whose triangles have another area, and triangles that are turned over though in the
//      image they are not narrower than what rounding can turn over.
// Rounding: corners of triangles are points of the face, rounded, and areas are evaluated in double. With u = 2^-53, M
// the largest coordinate of the face and P the perimeter of the triangle:
//   - lift.h computes p = a + t * (b - a), or the same with two directions; a and b may be rounded, too. That takes
//     each coordinate off the edge or plane by at most 8 u M (what is wrong in t moves p along the edge, and area from
//     one triangle to the next), so p by sqrt(3) * 8 u M. Moving a corner by that changes the area by at most half of
//     it times the opposite side: sqrt(3) * 4 u M P for all three. Where numbers are denormal, with d the spacing
//     between these, products and quotients take each coordinate off by another 2 d, which comes to sqrt(3) d P.
//   - Each component of the cross product of two sides r and s is off by at most 4 u |r| |s|, its length by sqrt(3)
//     times that, and by 5 u |r| |s| more for std::hypot (three quotients, squared and summed, a root, a product). Half
//     of it, |r| being at most P / 2 and |s| at most the diameter 2 sqrt(3) M, is (6 + 5 sqrt(3) / 2) u M P.
//   - The sum of n areas is off by (n u)^3 times all of them (see Sum), which are below sqrt(3) / 2 M P each.
// Method: a triangle that is turned over, which is allowed where it is narrow, counts against the face. One whose
// orientation is within the bound of none may count either way.
#pragma once

#include <string>
#include <vector>

#include "reconstruct/labelling/labelled_mesh.h"

namespace sightline::inline reconstruct {

void check_face_areas(const LabelledMesh& labelled, const PolygonMesh& uncut, const ProjectedScene& scene,
                      std::vector<std::string>& messages);

}  // namespace sightline::inline reconstruct
