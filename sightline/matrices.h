// Surfaces as matrices, in the convention of libigl and numpy: V has a row per vertex, F a row of vertex numbers per face.
//
// In:  V (n x 3) in input units, F (m x 3, or m x 4 where -1 in the last column makes a triangle).
// Out: a Mesh whose faces are the rows of F; and of a view the labelled surface and areas per face.
// Complexity: O(n + m).
// Errors: std::invalid_argument where F has neither 3 nor 4 columns, names a row that V does not have, or V is not finite.
#pragma once

#include <Eigen/Core>

#include "geometry/numbers/export.h"
#include "sightline/view.h"

namespace sightline {

[[nodiscard]] SIGHTLINE_EXPORT Mesh build_mesh(const Eigen::MatrixX3d& V, const Eigen::MatrixXi& F);

// The labelled surface. Its first vertices are those of the input.
struct SurfaceMatrices {
  Eigen::MatrixX3d V;      // n x 3
  Eigen::MatrixX3i F;      // m x 3
  Eigen::VectorXi parent;  // per row of F: the face of the input that the triangle is of
  Eigen::VectorXi label;   // per row of F: a Label
};

[[nodiscard]] SIGHTLINE_EXPORT SurfaceMatrices surface_matrices(const LabelledMesh& labelled);

// Per face of the input the area on the surface that the camera sees.
[[nodiscard]] SIGHTLINE_EXPORT Eigen::VectorXd visible_areas(const View& view);

}  // namespace sightline
