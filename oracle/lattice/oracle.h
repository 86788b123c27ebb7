// The oracle: what is visible of each face, by brute force in exact arithmetic. It shares no code with the sweep.
//
// In:  oracle faces: the image of a face in the view volume, its plane over the image, its number.
// Out: the exact visible image area per face and the area that nothing covers, in oracle units squared.
// The nearest face is visible; of coplanar faces one that looks at the eye before one that is turned away, and of
// two alike the one with the lower number. Several oracle faces may have one
// number. Complexity: that of the decomposition, times the faces over one place.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>

#include "geometry/mesh/mesh.h"
#include "geometry/projection/projected_scene.h"
#include "oracle/lattice/trapezoids.h"

namespace sightline::lattice {

using Rational = boost::multiprecision::cpp_rational;

struct OracleFace {
  std::size_t number = 0;
  Ring ring;
  Plane plane;
  bool is_front = true;  // the eye sees its front
};

// Returns > 0 where a is nearer than b at the place.
[[nodiscard]] int nearer(const Plane& a, const Plane& b, const Place& place);

struct Visibility {
  std::vector<Rational> area;  // per face number
  Rational uncovered;
};
[[nodiscard]] Visibility visibility(const std::vector<OracleFace>& faces, std::size_t numbers);

// Returns the same in grid units squared for a scene of `grid_bits`.
[[nodiscard]] Rational in_grid_units(const Rational& area, int grid_bits);

// Returns the oracle's faces of a mesh: planar faces whole, others by facet; faces that do not count (skipped, edge-on,
// outside, culled) are left out.
[[nodiscard]] std::vector<OracleFace> oracle_faces(const PolygonMesh& mesh, const Camera& camera, Sides sides);

// These count the points of the image where a corner lies or edges cross, and how many of them are more than one event
// at once: corners that are apart in space, a corner on an edge, more than two edges that cross in one point. Equal
// edges count once.
struct Degeneracy {
  std::size_t points = 0;
  std::size_t degenerate = 0;
};
[[nodiscard]] Degeneracy degeneracy(const std::vector<OracleFace>& faces);

}  // namespace sightline::lattice
