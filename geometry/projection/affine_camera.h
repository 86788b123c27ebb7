// A camera of parallel rays from an affine P, whose last row is (0, 0, 0, w): weak perspective, and scaled orthography.
//
// A point v is at the pixel ((a . v + a4) / w, (b . v + b4) / w), where (a, a4) and (b, b4) are the first two rows. The rays'
// direction is the null vector of (a; b), and the origin the point that is seen at the window's centre and lies nearest
// to the input's origin: both computed exactly, then rounded once. Which of the two senses is meant the image says: it is
// not mirrored.
#pragma once

#include "geometry/projection/camera.h"

namespace sightline::inline geometry {

[[nodiscard]] bool is_affine(const Matrix34& p);

// Precondition of both: is_affine(p), and all is finite. Regular: w is not 0, and the first two rows are not parallel.
[[nodiscard]] bool is_regular_affine(const Matrix34& p);
[[nodiscard]] Camera affine_camera(std::string name, const Matrix34& p, const PixelImage& image);

}  // namespace sightline::inline geometry
