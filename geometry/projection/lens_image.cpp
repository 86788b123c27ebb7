#include "geometry/projection/lens_image.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

#include "geometry/numbers/errors.h"

namespace sightline::inline geometry {
namespace {

Point2 transformed(const Eigen::Matrix3d& m, const Point2& p) {
  const Eigen::Vector3d q = m * Eigen::Vector3d(p.x, p.y, 1);
  return {q.x() / q.z(), q.y() / q.z()};
}

std::string text_of(double number) {
  std::ostringstream text;
  text.precision(4);
  text << number;
  return text.str();
}

// Finds the frame in ideal pixels, side by side of the bent image.
class FrameFinder {
 public:
  FrameFinder(const std::string& camera, const LensImage& image)
      : camera_(camera), image_(image), to_plane_(image.k.inverse()) {
    double farthest = 0;
    for (const Point2& corner : corners()) {
      const Point2 p = transformed(to_plane_, corner);
      farthest = std::max(farthest, std::hypot(p.x, p.y));
    }
    disc_ = proven_disc(image.lens, farthest);
  }

  // Counter-clockwise where y points up.
  std::vector<Point2> run() {
    const auto bent = corners();
    std::array<Point2, 4> ideal;
    for (std::size_t i = 0; i < 4; ++i) ideal[i] = ideal_pixel(bent[i]);
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t next = (i + 1) % 4;
      add_side({bent[i], ideal[i]}, {bent[next], ideal[next]}, 0);
    }
    return std::move(frame_);
  }

 private:
  struct BorderPlace {
    Point2 bent;
    Point2 ideal;
  };

  // From the lower left corner.
  [[nodiscard]] std::array<Point2, 4> corners() const {
    const double low = image_.first;
    const double right = image_.first + image_.width;
    const double bottom = image_.first + image_.height;
    return {Point2{low, bottom}, Point2{right, bottom}, Point2{right, low}, Point2{low, low}};
  }

  [[nodiscard]] Point2 ideal_pixel(const Point2& bent) const {
    const auto ideal = ideal_place(image_.lens, disc_, transformed(to_plane_, bent));
    if (!ideal) refuse(bent);
    return transformed(image_.k, *ideal);
  }

  [[noreturn]] void refuse(const Point2& bent) const {
    const std::string place = "pixel (" + text_of(bent.x) + ", " + text_of(bent.y) + ")";
    const std::string radius = text_of(disc_.radius);
    const double degrees = std::atan(disc_.radius) * 180 / std::numbers::pi;
    if (disc_.end == LensDisc::End::too_wide) {
      throw CameraError("camera \"" + camera_ + "\": the lens shows at " + place +
                        " what is 89 degrees or more off the axis, which no pinhole sees; crop the image");
    }
    throw CameraError(
        "camera \"" + camera_ + "\": the lens model folds at r = " + radius + ", " + text_of(degrees) +
        " degrees off the axis, so that nothing is known of " + place +
        "; check the order and the signs of the coefficients, or crop the image to where they were fitted");
  }

  void add_side(const BorderPlace& from, const BorderPlace& to, int depth) {
    constexpr int least_depth = 2;
    constexpr int most_depth = 13;
    if (depth >= least_depth && 2 * deviation(from, to) <= image_.frame_tolerance) {
      frame_.push_back(from.ideal);
      return;
    }
    if (depth == most_depth) {
      throw CameraError("camera \"" + camera_ +
                        "\": the frame has more than 8192 sides along one of the image; give a larger frame_tolerance");
    }
    const Point2 middle{(from.bent.x + to.bent.x) / 2, (from.bent.y + to.bent.y) / 2};
    const BorderPlace between{middle, ideal_pixel(middle)};
    add_side(from, between, depth + 1);
    add_side(between, to, depth + 1);
  }

  // Returns how far the straight line, bent, is off the side: that is upright or level.
  [[nodiscard]] double deviation(const BorderPlace& from, const BorderPlace& to) const {
    double largest = 0;
    for (const double t : {0.25, 0.5, 0.75}) {
      const Point2 p{from.ideal.x + t * (to.ideal.x - from.ideal.x), from.ideal.y + t * (to.ideal.y - from.ideal.y)};
      const Point2 q = transformed(image_.k, bent_place(image_.lens, transformed(to_plane_, p)));
      largest =
          std::max(largest, from.bent.x == to.bent.x ? std::fabs(q.x - from.bent.x) : std::fabs(q.y - from.bent.y));
    }
    return largest;
  }

  const std::string& camera_;
  const LensImage& image_;
  const Eigen::Matrix3d to_plane_;
  LensDisc disc_;
  std::vector<Point2> frame_;
};

// A window of whole pixels that leaves a margin around the frame, so that the frame never runs along its border.
void set_window(LensImage& image, const std::vector<Point2>& frame) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Point2 low{infinity, infinity};
  Point2 high{-infinity, -infinity};
  for (const Point2& p : frame) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  image.left = std::floor(low.x) - 1;
  image.top = std::floor(low.y) - 1;
  image.window_width = std::ceil(high.x) + 1 - image.left;
  image.window_height = std::ceil(high.y) + 1 - image.top;
}

Point2 frame_corner(const LensImage& image, const Point2& ideal) {
  const auto on_grid = [](double c) { return std::ldexp(std::nearbyint(std::ldexp(c, 48)), -48) + 0.0; };
  return {on_grid(2 * (ideal.x - image.left) / image.window_width - 1),
          on_grid(1 - 2 * (ideal.y - image.top) / image.window_height)};
}

void require_lens(bool holds, const std::string& camera, const char* what) {
  if (!holds) throw CameraError("camera \"" + camera + "\": " + what);
}

void add_between(const LensImage& image, const Point2& from, const Point2& to, double tolerance, int depth,
                 std::vector<Point2>& places) {
  const Point2 middle{(from.x + to.x) / 2, (from.y + to.y) / 2};
  const Point2 a = bent_pixel(image, from);
  const Point2 b = bent_pixel(image, to);
  const Point2 m = bent_pixel(image, middle);
  const double off = std::hypot(m.x - (a.x + b.x) / 2, m.y - (a.y + b.y) / 2);
  if (depth == 12 || !(off > tolerance)) return;
  add_between(image, from, middle, tolerance, depth + 1, places);
  places.push_back(middle);
  add_between(image, middle, to, tolerance, depth + 1, places);
}

}  // namespace

LensImage make_lens_image(const std::string& camera, const Eigen::Matrix3d& k, const Lens& lens, double first,
                          double width, double height, double frame_tolerance) {
  const auto is_finite = [](double c) { return std::isfinite(c); };
  require_lens(std::ranges::all_of(lens.radial, is_finite) && std::ranges::all_of(lens.tangential, is_finite) &&
                   std::ranges::all_of(lens.prism, is_finite),
               camera, "a coefficient of the lens is not finite; give the numbers of the calibration");
  require_lens(lens.model != LensModel::field_of_view || (lens.radial[0] > 0 && lens.radial[0] < std::numbers::pi),
               camera, "the lens's field of view is not between 0 and pi; give the number of the calibration");
  require_lens(
      k(2, 0) == 0 && k(2, 1) == 0 && k(2, 2) == 1 && k(1, 0) == 0 && k(0, 0) > 0 && k(1, 1) > 0, camera,
      "a camera with a lens needs another K; write [[fx, s, cx], [0, fy, cy], [0, 0, 1]] with positive fx and fy");
  require_lens(
      frame_tolerance > 0 && frame_tolerance <= std::min(width, height) / 8, camera,
      "the frame's tolerance is not above 0 and at most an eighth of the image; choose another, 0.01 pixels is usual");
  LensImage image;
  image.lens = lens;
  image.k = k;
  image.first = first;
  image.width = width;
  image.height = height;
  image.frame_tolerance = frame_tolerance;
  const std::vector<Point2> frame = FrameFinder(camera, image).run();
  set_window(image, frame);
  for (const Point2& p : frame) image.frame.push_back(frame_corner(image, p));
  image.frame.erase(std::unique(image.frame.begin(), image.frame.end()), image.frame.end());
  return image;
}

Point2 bent_pixel(const LensImage& image, const Point2& window) {
  const double u = image.left + (window.x + 1) / 2 * image.window_width;
  const double v = image.top + (1 - window.y) / 2 * image.window_height;
  const double y = (v - image.k(1, 2)) / image.k(1, 1);
  const double x = ((u - image.k(0, 2)) - image.k(0, 1) * y) / image.k(0, 0);
  const Point2 bent = bent_place(image.lens, {x, y});
  return {image.k(0, 0) * bent.x + image.k(0, 1) * bent.y + image.k(0, 2), image.k(1, 1) * bent.y + image.k(1, 2)};
}

std::vector<Point2> bent_line(const LensImage& image, const Point2& from, const Point2& to, double tolerance) {
  std::vector<Point2> places{from};
  add_between(image, from, to, tolerance, 0, places);
  places.push_back(to);
  return places;
}

double frame_area(const LensImage& image) {
  double twice = 0;
  for (std::size_t i = 0; i < image.frame.size(); ++i) {
    const Point2& p = image.frame[i];
    const Point2& q = image.frame[(i + 1) % image.frame.size()];
    twice += p.x * q.y - q.x * p.y;
  }
  return twice / 2;
}

}  // namespace sightline::inline geometry
