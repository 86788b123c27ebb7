// Cameras: pinhole and orthographic, as exact linear forms on the input's coordinates.
//
// A camera is three rows of doubles and an origin; these doubles are the camera, exactly. For a point v of the input:
//   X = right . (v - origin)     Y = up . (v - origin)     W = forward . (v - origin), or 1 where orthographic
// and the point's place in the window [-1, 1]^2 is (X / W, Y / W), x to the right and y up. A pinhole sees only W > 0.
// |forward| = 1 up to rounding, so that forward . (v - origin) is the distance in the input's units along the view
// direction; near and far bound it.
//
// The makers below round once, when they compute the rows. Where the eye is not given but derived (projection_matrix,
// calibrated) it is the matrix' null vector, rounded to double: it is the centre of projection and the eye of every
// depth decision. Of an affine P the direction towards the viewer is.
//
// A camera with a lens is the ideal pinhole with a window around all that the lens shows, and the frame of that
// (lens_image.h): what lies outside the frame is out of view (frame_cut.h).
//
// Sources: Fang 1993, section 5.2.2 and appendix A (view transformation); Koucky 2014, 2.3.1 (K [R | t]).
// Errors: CameraError from every maker: a direction of length zero, up along the view direction, an angle not in (0,
// 180), aspect or height not positive, a matrix that is singular, an R that is no rotation, near >= far, a lens that folds,
// anything not finite.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "geometry/numbers/export.h"
#include "geometry/numbers/predicates.h"
#include "geometry/numbers/vector3.h"
#include "geometry/projection/lens_image.h"

namespace sightline::inline geometry {

enum class Projection { perspective, orthographic };

struct Camera {
  std::string name;
  Projection projection = Projection::perspective;
  Vector3 right = Vector3::Zero();
  Vector3 up = Vector3::Zero();
  Vector3 forward = Vector3::Zero();
  Point3 origin = Point3::Zero();  // the eye of a pinhole; a point that is seen at the window's centre otherwise
  HomogeneousPoint eye;            // origin, or for an orthographic camera the direction towards the viewer with w = 0
  std::optional<double> near_distance = std::nullopt;
  std::optional<double> far_distance = std::nullopt;
  double aspect = 1;  // the window's width over its height, for display only
  // Of a camera that was made of a matrix P: 1 where P says what is in front, -1 where -P does (ImageY).
  std::optional<int> matrix_sign = std::nullopt;
  std::optional<LensImage> lens_image = std::nullopt;
};

struct ViewPoint {
  Point3 eye = Point3::Zero();
  Point3 target = Point3::Zero();
  Vector3 up{0, 1, 0};
  double aspect = 1;
  std::optional<double> near_distance = std::nullopt;
  std::optional<double> far_distance = std::nullopt;
  std::optional<Vector3> direction = std::nullopt;  // of the view, in place of target
};

// fov_y is the full vertical angle in degrees, in (0, 180).
[[nodiscard]] SIGHTLINE_EXPORT Camera perspective_camera(std::string name, const ViewPoint& view, double fov_y_degrees);

// half_height is half the window's height at distance 1: the tangent of half the vertical angle.
[[nodiscard]] SIGHTLINE_EXPORT Camera pinhole_camera(std::string name, const ViewPoint& view, double half_height);

// Returns tan(degrees / 2) of an angle in (0, 180); 90 degrees give exactly 1, and angles near 180 lose nothing.
[[nodiscard]] SIGHTLINE_EXPORT double tangent_of_half(double degrees);

// height is the window's height in input units.
[[nodiscard]] SIGHTLINE_EXPORT Camera orthographic_camera(std::string name, const ViewPoint& view, double height);

// The same camera with its window moved in its plane by so many widths to the right and heights up: with {0.5, 0} what was
// at its centre is at its left border. The view direction, and the plane, stay.
[[nodiscard]] SIGHTLINE_EXPORT Camera shifted(Camera camera, const std::array<double, 2>& shift);

// Unaligned, as Matrix3 is: what holds one needs no storage of its own kind.
using Matrix3 = Eigen::Matrix3d;
using Matrix34 = Eigen::Matrix<double, 3, 4, Eigen::DontAlign>;

// This says where pixel coordinates begin: at `corner` the first pixel's centre is (0.5, 0.5), at `center` it is (0,
// 0).
enum class PixelOrigin { corner, center };

// Where the image's y points to: from the first row of pixels to the last, or, as OpenGL and VTK have it, from the last
// to the first.
enum class ImageY { down, up };

struct PixelImage {
  double width = 0;
  double height = 0;
  PixelOrigin origin = PixelOrigin::corner;
  std::optional<double> near_distance = std::nullopt;
  std::optional<double> far_distance = std::nullopt;
  ImageY y = ImageY::down;
};

// R is a rotation where no entry of R R^T - 1 is larger: what digits that were written leave, not a shear or a scale.
constexpr double rotation_tolerance = 1e-6;

// Throws a CameraError with the size of the defect where r is no rotation.
SIGHTLINE_EXPORT void require_rotation(const std::string& name, const Matrix3& r);

// Pixels have x to the right, and y as the image says; the camera looks along z. P maps (v, 1) to homogeneous pixels. P
// and -P have the same image, and see opposite halves of space: meant is the one whose image is not mirrored, that is,
// with det(P[:, :3]) > 0 where y points down, and < 0 where it points up. K has a positive diagonal (its second entry
// negative where y points up), and R is a rotation. A P whose last row is (0, 0, 0, w) is affine: parallel rays, with no
// near and far.
[[nodiscard]] SIGHTLINE_EXPORT Camera projection_matrix_camera(std::string name, const Matrix34& p,
                                                               const PixelImage& image);
[[nodiscard]] SIGHTLINE_EXPORT Camera calibrated_camera(std::string name, const Matrix3& k, const Matrix3& r,
                                                        const Vector3& t, const PixelImage& image);
// The same behind a lens; a lens that does nothing is none. The image is the bent one, frame_tolerance is in its pixels.
[[nodiscard]] SIGHTLINE_EXPORT Camera calibrated_camera(std::string name, const Matrix3& k, const Matrix3& r,
                                                        const Vector3& t, const PixelImage& image, const Lens& lens,
                                                        double frame_tolerance = default_frame_tolerance);

// Where a camera is and how it is turned: the rows of `rotation` are the directions of x, to the right, of y, down, and
// of the view.
struct CameraPose {
  Matrix3 rotation = Matrix3::Identity();
  Point3 eye = Point3::Zero();
};

// Axes of a camera's frame: x to the right; y down and z along the view (opencv), or y up and z against it (opengl).
enum class CameraAxes { opencv, opengl };

// camera_to_world takes a place in the camera's frame to the input's: its last column is the eye.
[[nodiscard]] SIGHTLINE_EXPORT CameraPose camera_pose(const Matrix34& camera_to_world, CameraAxes axes);

// The same as calibrated_camera with t = -R eye, but that the eye is what is given.
[[nodiscard]] SIGHTLINE_EXPORT Camera posed_camera(std::string name, const Matrix3& k, const CameraPose& pose,
                                                   const PixelImage& image);
[[nodiscard]] SIGHTLINE_EXPORT Camera posed_camera(std::string name, const Matrix3& k, const CameraPose& pose,
                                                   const PixelImage& image, const Lens& lens,
                                                   double frame_tolerance = default_frame_tolerance);

}  // namespace sightline::inline geometry
