// The truth: what a camera sees of each face, computed without the engine, exactly, on the unrounded input.
//
// In:  a mesh, a camera, which sides count; for compare() also what somebody says is visible.
// Out: exact areas in window units squared; the window is [-1, 1]^2 and its area 4.
// Holds:
//   - a place of the window belongs to the nearest face over it, by exact depth along the camera's ray there, also
//     where faces pass through each other; of coplanar faces one that looks at the eye is in front of one
//     that is turned away, and of two alike the lower index;
//   - where `planes` says so, per facet, a face has its depths in the plane of another facet; it is not seen where rays to it do not
//     meet that before the eye;
//   - faces that are planar are taken whole, others by facet; edge-on ones are not seen; with Sides::front back-facing
//     ones are neither seen nor in the way;
//   - the visible areas and the uncovered area add up to 4.
// Any finite doubles will do, and so will a mesh without faces. Meant for small scenes, up to some twenty faces: per
// face, the decomposition of its image by all that can hide it (see covered_area.h).
// Shares no code with the engine but the types of its input. Errors: none.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <vector>

#include "geometry/mesh/mesh.h"
#include "geometry/projection/camera.h"
#include "geometry/projection/projected_scene.h"

namespace sightline::oracle {

using Rational = boost::multiprecision::cpp_rational;

struct RationalPoint {
  Rational x;
  Rational y;
};

struct Truth {
  std::vector<Rational> visible_area;  // per face
  Rational uncovered;
};

[[nodiscard]] Truth true_visibility(const PolygonMesh& mesh, const Camera& camera, Sides sides,
                                    const std::vector<FacetId>& planes = {});

// A claim says that a face is visible where the rings' winding number is positive: outer rings run counter-clockwise,
// holes clockwise. All rings of a face count together, whether they come in one claim or in several.
struct Claim {
  FaceId face;
  std::vector<std::vector<RationalPoint>> rings;
};

// mislabelled_area is that of the part of the window where the claims are not right: not exactly those for the one face
// that is visible there, or, where nothing is, not none.
struct Comparison {
  Truth truth;
  Rational mislabelled_area;
};

// Precondition: claims name faces of the mesh.
[[nodiscard]] Comparison compare(const PolygonMesh& mesh, const Camera& camera, Sides sides,
                                 const std::vector<Claim>& claims);

}  // namespace sightline::oracle
