#include "geometry/projection/camera.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <numbers>
#include <sstream>

#include "geometry/numbers/errors.h"
#include "geometry/projection/affine_camera.h"

namespace sightline::inline geometry {

namespace {

void require(bool holds, const std::string& name, const char* what) {
  if (!holds) throw CameraError("camera \"" + name + "\": " + what);
}

template <class Entries>
bool finite(const Eigen::MatrixBase<Entries>& m) {
  return m.unaryExpr([](double entry) { return std::isfinite(entry); }).all();
}

double length_of_moderate(const Vector3& v) { return std::sqrt(v.dot(v)); }

// Adding 0.0 turns -0.0 into 0.0, so that reports do not depend on how a zero came about.
Vector3 divided(const Vector3& v, double divisor) { return (v / divisor).array() + 0.0; }

// Returns a * b - c * d to 1.5 units in the last place: it is zero only where the exact value is (Kahan; Jeannerod,
// Louvet and Muller 2013).
double difference_of_products(double a, double b, double c, double d) {
  const double cd = c * d;
  return std::fma(a, b, -cd) + std::fma(-c, d, cd);
}

// Every component is right to 1.5 units in the last place, however close to parallel a and b are.
Vector3 accurate_cross(const Vector3& a, const Vector3& b) {
  return {difference_of_products(a.y(), b.z(), a.z(), b.y()), difference_of_products(a.z(), b.x(), a.x(), b.z()),
          difference_of_products(a.x(), b.y(), a.y(), b.x())};
}

// Returns the direction from a to b; halves first where the difference would overflow.
Vector3 direction(const Point3& a, const Point3& b) {
  const Vector3 difference = b - a;
  return with_moderate_exponent(finite(difference) ? difference : 0.5 * b - 0.5 * a);
}

void check_view_point(const std::string& name, const ViewPoint& view) {
  require(finite(view.eye), name, "eye is not finite; give finite numbers");
  require(finite(view.target), name, "target is not finite; give finite numbers");
  require(finite(view.direction.value_or(view.target)), name, "the view direction is not finite; give finite numbers");
  require(finite(view.up), name, "up is not finite; give finite numbers");
  if (view.direction) {
    require(largest_coordinate(*view.direction) > 0, name, "the view direction has length zero; give another");
  } else {
    require(!(view.eye == view.target), name,
            "eye and target are the same point, which gives no view direction; move one of them");
  }
  require(largest_coordinate(view.up) > 0, name, "up has length zero; give another");
  require(std::isfinite(view.aspect) && view.aspect > 0, name, "aspect is not a positive number; give one");
}

void check_distances(const Camera& camera) {
  const auto& near_distance = camera.near_distance;
  const auto& far_distance = camera.far_distance;
  require(std::isfinite(near_distance.value_or(0)), camera.name, "near is not finite; leave it out");
  require(std::isfinite(far_distance.value_or(0)), camera.name, "far is not finite; leave it out");
  require(!near_distance || !far_distance || *near_distance < *far_distance, camera.name,
          "near is not less than far; move one of them");
}

// The rows are checked, too: parameters in range can still be so extreme that a row overflows or vanishes.
Camera checked(Camera camera) {
  check_distances(camera);
  require(finite(camera.right) && finite(camera.up) && finite(camera.origin), camera.name,
          "its numbers are too large or too small for double arithmetic; give others");
  require(largest_coordinate(camera.right) > 0 && largest_coordinate(camera.up) > 0, camera.name,
          "its numbers are too large or too small for double arithmetic; give others");
  return camera;
}

Vector3 view_direction(const ViewPoint& view) {
  return view.direction ? with_moderate_exponent(*view.direction) : direction(view.eye, view.target);
}

// half_height is half the window's height, at distance 1 for a pinhole.
Camera looking_camera(std::string name, const ViewPoint& view, double half_height) {
  const Vector3 along = view_direction(view);
  const Vector3 across = accurate_cross(along, with_moderate_exponent(view.up));
  require(largest_coordinate(across) > 0, name, "up is along the view direction; choose another up");
  Camera camera;
  camera.name = std::move(name);
  camera.forward = unit(along);
  camera.right = divided(divided(unit(across), half_height), view.aspect);
  camera.up = divided(unit(accurate_cross(across, along)), half_height);
  camera.origin = view.eye;
  camera.near_distance = view.near_distance;
  camera.far_distance = view.far_distance;
  camera.aspect = view.aspect;
  return camera;
}

using Columns = std::array<std::array<BigInteger, 3>, 4>;

BigInteger determinant(const Columns& columns, std::size_t a, std::size_t b, std::size_t c) {
  const auto minor = [&](std::size_t i, std::size_t j) -> BigInteger {
    return columns[b][i] * columns[c][j] - columns[b][j] * columns[c][i];
  };
  return columns[a][0] * minor(1, 2) + columns[a][1] * minor(2, 0) + columns[a][2] * minor(0, 1);
}

// Returns the integers that P is, over one power of two.
Columns integer_columns(const Matrix34& p) {
  std::array<double, 12> entries;
  for (std::size_t i = 0; i < 12; ++i) entries[i] = p.data()[i];  // column by column
  const int lowest = exponent_range(entries).lowest;
  Columns columns;
  for (std::size_t i = 0; i < 12; ++i) columns[i / 3][i % 3] = scaled<BigInteger>(entries[i], lowest);
  return columns;
}

double rounded(const BigInteger& numerator, const BigInteger& denominator) {
  return boost::multiprecision::cpp_rational(numerator, denominator).convert_to<double>() + 0.0;
}

// Returns the null vector (c, 1) of P by Cramer's rule, exactly, then rounded to double. Precondition: det(P[:, :3]) >
// 0.
Point3 centre_of_projection(const Matrix34& p) {
  const Columns columns = integer_columns(p);
  const BigInteger denominator = determinant(columns, 0, 1, 2);
  return {rounded(determinant(columns, 3, 2, 1), denominator), rounded(determinant(columns, 3, 0, 2), denominator),
          rounded(determinant(columns, 1, 0, 3), denominator)};
}

Vector3 row(const Matrix34& p, int i) { return p.row(i).head<3>(); }

// Returns the sign of det(P[:, :3]), exactly.
Sign handedness(const Matrix34& p) { return orient3d(Point3::Zero(), row(p, 0), row(p, 1), row(p, 2)); }

// Returns the same camera with the largest entry in [1, 2), by a power of two, and a positive determinant.
Matrix34 normalised(const Matrix34& p) {
  double size = 0;
  for (int i = 0; i < 3; ++i) size = std::max(size, largest_coordinate(row(p, i)));
  const int exponent = -std::ilogb(size);
  const int sign = handedness(p);
  return p.unaryExpr([sign, exponent](double entry) { return sign * std::scalbn(entry, exponent); });
}

// Returns a * v + b * w, rounded once per component if a * v is exact.
Vector3 combined(double a, const Vector3& v, double b, const Vector3& w) {
  return {std::fma(b, w.x(), a * v.x()), std::fma(b, w.y(), a * v.y()), std::fma(b, w.z(), a * v.z())};
}

void check_image(const std::string& name, const PixelImage& image) {
  require(std::isfinite(image.width) && image.width > 0, name,
          "the image's width is not a positive number; give it in pixels");
  require(std::isfinite(image.height) && image.height > 0, name,
          "the image's height is not a positive number; give it in pixels");
}

// The sign of det(P[:, :3]) where the image is not mirrored.
Sign sign_of_y(const PixelImage& image) { return image.y == ImageY::down ? 1 : -1; }

// Pixels become the window by x = 2 (u + shift) / width - 1 and y = 1 - 2 (v + shift) / height, or minus that, where shift
// is half a pixel where the first pixel's centre is (0, 0).
Camera pixel_camera(std::string name, const Matrix34& p, const Point3& origin, const PixelImage& image) {
  const int down = sign_of_y(image);
  const Matrix34 m = down * normalised(p);
  const double twice_shift = image.origin == PixelOrigin::center ? 1 : 0;
  const Vector3 depth = with_moderate_exponent(row(m, 2));
  const double length = std::scalbn(length_of_moderate(depth), std::ilogb(largest_coordinate(row(m, 2))));
  Camera camera;
  camera.name = std::move(name);
  camera.forward = unit(depth);
  camera.right = divided(divided(combined(2, row(m, 0), twice_shift - image.width, row(m, 2)), image.width), length);
  camera.up = divided(
      divided(combined(-2 * down, row(m, 1), down * (image.height - twice_shift), row(m, 2)), image.height), length);
  camera.origin = origin;
  camera.eye = {origin, 1};
  camera.near_distance = image.near_distance;
  camera.far_distance = image.far_distance;
  camera.aspect = image.width / image.height;
  return checked(std::move(camera));
}

// Returns K [R | t].
Matrix34 projection_of(const std::string& name, const Matrix3& k, const Matrix34& pose, const PixelImage& image) {
  check_image(name, image);
  require(finite(k) && finite(pose), name, "K, R or t has an entry that is not finite; give finite numbers");
  require_rotation(name, pose.leftCols<3>());
  const Matrix34 p = k * pose;
  require(finite(p), name, "K [R | t] is not finite; give smaller numbers");
  require(handedness(p) * sign_of_y(image) > 0, name,
          image.y == ImageY::down
              ? "K has no positive determinant; give it a positive diagonal, or, where the image's y points up, "
                "write image_y = \"up\""
              : "K has no negative determinant, which an image whose y points up needs; choose signs so that only the "
                "second entry of K's diagonal is negative");
  return p;
}

}  // namespace

double tangent_of_half(double degrees) {
  if (degrees > 90) return 1 / tangent_of_half(180 - degrees);
  const double angle = degrees * (std::numbers::pi / 180);
  return std::sin(angle) / (1 + std::cos(angle));
}

Camera perspective_camera(std::string name, const ViewPoint& view, double fov_y_degrees) {
  check_view_point(name, view);
  require(fov_y_degrees > 0 && fov_y_degrees < 180, name,
          "the vertical field of view is not between 0 and 180 degrees; give an angle that is");
  return pinhole_camera(std::move(name), view, tangent_of_half(fov_y_degrees));
}

Camera pinhole_camera(std::string name, const ViewPoint& view, double half_height) {
  check_view_point(name, view);
  require(std::isfinite(half_height) && half_height > 0, name,
          "the window's height is not a positive number; give one");
  Camera camera = looking_camera(std::move(name), view, half_height);
  camera.eye = {view.eye, 1};
  return checked(std::move(camera));
}

Camera orthographic_camera(std::string name, const ViewPoint& view, double height) {
  check_view_point(name, view);
  require(std::isfinite(height) && height > 0, name, "the orthographic height is not a positive number; give one");
  Camera camera = looking_camera(std::move(name), view, height / 2);
  camera.projection = Projection::orthographic;
  // This is not the unit vector: that is rounded, and a face along the given direction would no longer be seen edge-on.
  camera.eye = {view.direction ? Vector3(-view_direction(view)) : direction(view.target, view.eye), 0};
  return checked(std::move(camera));
}

Camera shifted(Camera camera, const std::array<double, 2>& shift) {
  require(std::isfinite(shift[0]) && std::isfinite(shift[1]), camera.name, "shift is not finite; give finite numbers");
  if (camera.projection == Projection::perspective) {
    camera.right = combined(-2 * shift[0], camera.forward, 1, camera.right).array() + 0.0;
    camera.up = combined(-2 * shift[1], camera.forward, 1, camera.up).array() + 0.0;
  } else {
    camera.origin += 2 * shift[0] * camera.right / camera.right.squaredNorm();
    camera.origin += 2 * shift[1] * camera.up / camera.up.squaredNorm();
  }
  return checked(std::move(camera));
}

void require_rotation(const std::string& name, const Matrix3& r) {
  require(finite(r), name, "R has an entry that is not finite; give finite numbers");
  const double defect = (r * r.transpose() - Matrix3::Identity()).cwiseAbs().maxCoeff();
  if (!(defect <= rotation_tolerance)) {
    std::ostringstream size;
    size << std::setprecision(2) << defect;
    throw CameraError("camera \"" + name + "\": R is not a rotation: an entry of R R^T - 1 is " + size.str() +
                      ", and at most 1e-06 is let pass; give R with more digits, or divide it by its scale");
  }
  require(orient3d(Point3::Zero(), r.row(0), r.row(1), r.row(2)) > 0, name,
          "R mirrors: its determinant is -1; turn the sign of one axis");
}

Camera projection_matrix_camera(std::string name, const Matrix34& p, const PixelImage& image) {
  check_image(name, image);
  require(finite(p), name, "P has an entry that is not finite; give finite numbers");
  if (is_affine(p)) {
    require(!image.near_distance && !image.far_distance, name,
            "P is affine, so that no place on its parallel rays is the eye; leave out near and far");
    require(
        is_regular_affine(p), name,
        "P is singular: its first two rows are parallel, or its last entry is 0, so the camera has no direction; give "
        "a P of rank 3");
    return checked(affine_camera(std::move(name), p, image));
  }
  const Sign handed = handedness(p);
  require(handed != 0, name,
          "the left 3x3 part of P is singular, so the camera has no finite centre; give a P of rank 3, or an affine "
          "one, whose last row is (0, 0, 0, 1)");
  Camera camera = pixel_camera(std::move(name), p, centre_of_projection(normalised(p)), image);
  camera.matrix_sign = handed * sign_of_y(image);
  return camera;
}

Camera calibrated_camera(std::string name, const Matrix3& k, const Matrix3& r, const Vector3& t,
                         const PixelImage& image) {
  require(finite(t), name, "K, R or t has an entry that is not finite; give finite numbers");
  Matrix34 pose;
  pose << r, t;
  const Matrix34 p = projection_of(name, k, pose, image);
  // K cancels in the null vector of K [R | t].
  return pixel_camera(std::move(name), p, centre_of_projection(pose), image);
}

CameraPose camera_pose(const Matrix34& camera_to_world, CameraAxes axes) {
  const double sign = axes == CameraAxes::opencv ? 1 : -1;
  CameraPose pose;
  for (int i = 0; i < 3; ++i) pose.rotation.row(i) = ((i == 0 ? 1 : sign) * camera_to_world.col(i)).array() + 0.0;
  pose.eye = camera_to_world.col(3);
  return pose;
}

Camera posed_camera(std::string name, const Matrix3& k, const CameraPose& pose, const PixelImage& image) {
  require(finite(pose.eye), name, "the eye is not finite; give finite numbers");
  Matrix34 turned;
  turned << pose.rotation, Vector3::Zero();
  const Matrix34 p = projection_of(name, k, turned, image);
  return pixel_camera(std::move(name), p, pose.eye, image);
}

namespace {

// Returns K of the same pixels with y down: lenses are computed there.
Matrix3 with_y_down(const Matrix3& k, const PixelImage& image) {
  if (image.y == ImageY::down) return k;
  const double rows = image.origin == PixelOrigin::center ? image.height - 1 : image.height;
  Matrix3 turned = k;
  turned.row(1) = rows * k.row(2) - k.row(1);
  return turned;
}

// `make` returns the pinhole of a K and an image; what it gets is the window around all that the lens shows.
template <class Make>
Camera behind_lens(const std::string& name, const Matrix3& k, const PixelImage& image, const Lens& lens,
                   double frame_tolerance, Make make) {
  check_image(name, image);
  require(finite(k), name, "K has an entry that is not finite; give finite numbers");
  const double first = image.origin == PixelOrigin::center ? -0.5 : 0;
  Matrix3 in_window = with_y_down(k, image);
  LensImage bent = make_lens_image(name, in_window, lens, first, image.width, image.height, frame_tolerance);
  in_window(0, 2) -= bent.left;
  in_window(1, 2) -= bent.top;
  Camera camera = make(in_window, PixelImage{bent.window_width, bent.window_height, PixelOrigin::corner,
                                             image.near_distance, image.far_distance});
  camera.lens_image = std::move(bent);
  return camera;
}

}  // namespace

Camera calibrated_camera(std::string name, const Matrix3& k, const Matrix3& r, const Vector3& t,
                         const PixelImage& image, const Lens& lens, double frame_tolerance) {
  if (!bends(lens)) return calibrated_camera(std::move(name), k, r, t, image);
  return behind_lens(name, k, image, lens, frame_tolerance, [&](const Matrix3& in_window, const PixelImage& window) {
    return calibrated_camera(name, in_window, r, t, window);
  });
}

Camera posed_camera(std::string name, const Matrix3& k, const CameraPose& pose, const PixelImage& image,
                    const Lens& lens, double frame_tolerance) {
  if (!bends(lens)) return posed_camera(std::move(name), k, pose, image);
  return behind_lens(name, k, image, lens, frame_tolerance, [&](const Matrix3& in_window, const PixelImage& window) {
    return posed_camera(name, in_window, pose, window);
  });
}

}  // namespace sightline::inline geometry
