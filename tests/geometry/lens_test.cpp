// Lenses: where they bring rays, against a table that OpenCV made (opencv_lenses.py), and where they may not be used.
#include "geometry/projection/lens.h"

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "geometry/numbers/errors.h"
#include "geometry/projection/camera.h"
#include "tests/tools/says_what_to_do.h"

namespace sightline::tests::lens_test {
namespace {

Lens brown(std::array<double, 6> radial, std::array<double, 2> tangential = {0, 0}) {
  return {LensModel::brown, radial, tangential, {}};
}

Lens fisheye(double k1, double k2, double k3, double k4) {
  return {LensModel::fisheye, {k1, k2, k3, k4, 0, 0}, {0, 0}, {}};
}

Lens field_of_view(double w) { return {LensModel::field_of_view, {w}, {}, {}}; }

// A row of the table.
struct Projected {
  Lens lens;
  double width, height, fx, fy, cx, cy;
  Point3 point;
  Point2 pixel;
};

std::vector<Projected> table() {
  std::vector<Projected> rows;
  std::ifstream file(SIGHTLINE_LENS_TABLE);
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    std::string model;
    std::getline(cells, model, ',');
    std::vector<double> v;
    for (std::string cell; std::getline(cells, cell, ',');) v.push_back(std::stod(cell));
    REQUIRE(v.size() == 19);
    const Lens lens = model == "fisheye" ? fisheye(v[6], v[7], v[8], v[9])
                                         : brown({v[6], v[7], v[8], v[9], v[10], v[11]}, {v[12], v[13]});
    rows.push_back({lens, v[0], v[1], v[2], v[3], v[4], v[5], {v[14], v[15], v[16]}, {v[17], v[18]}});
  }
  return rows;
}

Matrix3 camera_matrix(double fx, double fy, double cx, double cy) {
  Matrix3 k;
  k << fx, 0, cx, 0, fy, cy, 0, 0, 1;
  return k;
}

Camera behind(const Lens& lens, const Matrix3& k, const PixelImage& image, double tolerance = 0.01) {
  return calibrated_camera("c", k, Matrix3::Identity(), Vector3::Zero(), image, lens, tolerance);
}

Camera hd_behind(const Lens& lens) { return behind(lens, camera_matrix(1000, 1000, 960, 540), {1920, 1080}); }

std::string refusal(const Lens& lens) {
  try {
    static_cast<void>(hd_behind(lens));
  } catch (const CameraError& error) {
    CHECK(says_what_to_do(error.what()));
    return error.what();
  }
  return "";
}

Point2 window_place(const Camera& camera, const Point3& p) {
  const Vector3 d = p - camera.origin;
  const double w = camera.forward.dot(d);
  return {camera.right.dot(d) / w, camera.up.dot(d) / w};
}

Lens random_lens(std::mt19937_64& random) {
  const auto number = [&](double size) { return std::uniform_real_distribution<double>(-size, size)(random); };
  if (random() % 6 == 0) return field_of_view(0.8 + number(0.6));
  if (random() % 3 == 0) {
    Lens lens = fisheye(number(0.05), number(0.05), number(0.02), number(0.01));
    if (random() % 2 == 0) return lens;
    lens.tangential = {number(0.005), number(0.005)};
    lens.prism = {number(0.01), number(0.01)};
    return lens;
  }
  return brown({number(0.3), number(0.1), number(0.05), number(0.05), number(0.02), number(0.02)},
               {number(0.005), number(0.005)});
}

}  // namespace

TEST_CASE("A lens brings points to the pixels that OpenCV says, to 1e-9") {
  const std::vector<Projected> rows = table();
  REQUIRE(rows.size() == 300);
  for (const Projected& row : rows) {
    const Point2 bent = bent_place(row.lens, {row.point.x() / row.point.z(), row.point.y() / row.point.z()});
    CHECK(std::fabs(row.fx * bent.x + row.cx - row.pixel.x) < 1e-9);
    CHECK(std::fabs(row.fy * bent.y + row.cy - row.pixel.y) < 1e-9);
  }
}

TEST_CASE("A camera behind a lens has its points at OpenCV's pixels, to 1e-9") {
  std::size_t cameras = 0;
  for (const Projected& row : table()) {
    std::optional<Camera> camera;
    try {
      camera = behind(row.lens, camera_matrix(row.fx, row.fy, row.cx, row.cy),
                      {row.width, row.height, PixelOrigin::center}, 1);
    } catch (const CameraError&) {
      continue;
    }
    ++cameras;
    const Point2 pixel = bent_pixel(*camera->lens_image, window_place(*camera, row.point));
    const double off = std::hypot(pixel.x - row.pixel.x, pixel.y - row.pixel.y);
    CHECK(off < 1e-9);
  }
  CHECK(cameras > 200);
}

// As COLMAP has them: an angle that the image shows, and a fisheye whose image lies aslant.
TEST_CASE("A field of view and a thin prism bring points where COLMAP does") {
  const double w = 1.2;
  const Lens fov = field_of_view(w);
  const double r = 1 / (2 * std::tan(w / 2));
  const Point2 at_quarter = bent_place(fov, {0.6 * r, -0.8 * r});
  CHECK(at_quarter.x == doctest::Approx(0.6 * std::numbers::pi / (4 * w)).epsilon(1e-15));
  CHECK(at_quarter.y == doctest::Approx(-0.8 * std::numbers::pi / (4 * w)).epsilon(1e-15));
  CHECK(bent_place(fov, {0, 0}) == Point2{0, 0});

  const Lens prism{LensModel::fisheye, {0.01, -0.02, 0.003, -0.004}, {0.001, -0.002}, {0.005, -0.007}};
  for (const Point2& ideal : {Point2{0.3, 0.4}, Point2{-1.5, 0.2}, Point2{0, -2}}) {
    const double tangent = std::hypot(ideal.x, ideal.y);
    const double theta = std::atan(tangent);
    const double u = theta * ideal.x / tangent;
    const double v = theta * ideal.y / tangent;
    const double r2 = u * u + v * v;
    const double radial = 0.01 * r2 - 0.02 * r2 * r2 + 0.003 * std::pow(r2, 3) - 0.004 * std::pow(r2, 4);
    const double du = u * radial + 2 * 0.001 * u * v - 0.002 * (r2 + 2 * u * u) + 0.005 * r2;
    const double dv = v * radial - 2 * 0.002 * u * v + 0.001 * (r2 + 2 * v * v) - 0.007 * r2;
    const Point2 bent = bent_place(prism, ideal);
    CHECK(std::fabs(bent.x - (u + du)) < 1e-15);
    CHECK(std::fabs(bent.y - (v + dv)) < 1e-15);
  }
}

TEST_CASE("Without its k1 of -0.11 a corner of a full-HD image is 17 pixels off") {
  const Point2 corner = bent_place(brown({-0.11, 0, 0, 0, 0, 0}), {0.42, 0.42 * 9 / 16});
  const double ideal = std::hypot(0.42, 0.42 * 9 / 16);
  CHECK(1400 * (ideal - std::hypot(corner.x, corner.y)) == doctest::Approx(17).epsilon(0.03));
}

TEST_CASE("What is bent comes back, and nothing else comes to the same place") {
  const std::uint64_t seed = 20261130;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int i = 0; i < 400; ++i) {
    const Lens lens = random_lens(random);
    const LensDisc disc = proven_disc(lens, 0.9);
    REQUIRE(disc.radius > 0.1);
    const double angle = std::uniform_real_distribution<double>(0, 2 * std::numbers::pi)(random);
    const double reach = 0.999 * disc.radius * std::sqrt(std::uniform_real_distribution<double>(0, 1)(random));
    const Point2 p{reach * std::cos(angle), reach * std::sin(angle)};
    const Point2 bent = bent_place(lens, p);
    const auto found = ideal_place(lens, disc, bent);
    REQUIRE(found);
    CHECK(std::hypot(found->x - p.x, found->y - p.y) < 1e-9);
    const Point2 again = bent_place(lens, *found);
    CHECK(std::hypot(again.x - bent.x, again.y - bent.y) < 1e-14 * (1 + std::hypot(bent.x, bent.y)));
    // Its Jacobian by differences: what turns counter-clockwise still does.
    const double h = 1e-6;
    const Point2 q = bent_place(lens, p);
    const Point2 qx = bent_place(lens, {p.x + h, p.y});
    const Point2 qy = bent_place(lens, {p.x, p.y + h});
    CHECK((qx.x - q.x) * (qy.y - q.y) - (qx.y - q.y) * (qy.x - q.x) > 0);
    if (disc.end == LensDisc::End::reaches) CHECK(disc.bent_radius >= 0.9);
  }
}

TEST_CASE("A model folds where its distance from the axis no longer grows") {
  const auto fold_of = [](const Lens& lens) {
    const LensDisc disc = proven_disc(lens, 1e15);
    CHECK(disc.end == LensDisc::End::folds);
    return disc.radius;
  };
  CHECK(fold_of(brown({-2, 0, 0, 0, 0, 0})) == doctest::Approx(std::sqrt(1.0 / 6)).epsilon(1e-9));
  CHECK(fold_of(brown({-0.11, 0, 0, 0, 0, 0})) == doctest::Approx(std::sqrt(1 / 0.33)).epsilon(1e-9));
  CHECK(fold_of(brown({0, -0.2, 0, 0, 0, 0})) == doctest::Approx(1).epsilon(1e-9));
  CHECK(fold_of(fisheye(-1, 0, 0, 0)) == doctest::Approx(std::tan(std::sqrt(1.0 / 3))).epsilon(1e-9));
  // A pole of the fraction, where the factor grows beyond all bounds.
  CHECK(fold_of(brown({0, 0, 0, -0.5, 0, 0})) == doctest::Approx(std::sqrt(2.0)).epsilon(1e-6));
  CHECK(proven_disc(brown({0.1, 0, 0, 0, 0, 0}), 10).end == LensDisc::End::reaches);
  CHECK(proven_disc(fisheye(0, 0, 0, 0), 10).end == LensDisc::End::too_wide);
  CHECK(proven_disc(field_of_view(1), 10).end == LensDisc::End::too_wide);
  CHECK(proven_disc(field_of_view(1), 1).end == LensDisc::End::reaches);
  // s1 alone folds where 1 + 2 s1 x is 0, along the axis of x.
  const Lens prism{LensModel::fisheye, {}, {}, {-0.4, 0}};
  const LensDisc unfolded = proven_disc(prism, 1e15);
  CHECK(unfolded.end == LensDisc::End::folds);
  CHECK(unfolded.radius <= std::tan(1 / 0.8));
  CHECK(unfolded.radius > std::tan(0.5 / 0.8));
}

TEST_CASE("A lens that folds within the image, or shows more than a half-space, is refused with what to do") {
  CHECK(refusal(brown({-2, 0, 0, 0, 0, 0})).find("folds at r = 0.4082") != std::string::npos);
  CHECK(refusal(brown({-2, 0, 0, 0, 0, 0})).find("check the order and the signs") != std::string::npos);
  CHECK(refusal(brown({0, 0, 0, 0, 0, 0}, {0.5, 0})).find("folds") != std::string::npos);
  CHECK(refusal(fisheye(-1, 0, 0, 0)).find("folds") != std::string::npos);
  CHECK(refusal(brown({std::numeric_limits<double>::quiet_NaN(), 0, 0, 0, 0, 0})).find("not finite") !=
        std::string::npos);
  const Matrix3 short_focus = camera_matrix(600, 600, 960, 540);
  CHECK_THROWS_WITH_AS(static_cast<void>(behind(fisheye(0, 0, 0, 0), short_focus, {1920, 1080})),
                       doctest::Contains("89 degrees or more off the axis"), CameraError);
  Matrix3 sheared = camera_matrix(1000, 1000, 960, 540);
  sheared(2, 0) = 1e-4;
  CHECK_THROWS_AS(static_cast<void>(behind(brown({-0.1, 0, 0, 0, 0, 0}), sheared, {1920, 1080})), CameraError);
  CHECK_THROWS_AS(static_cast<void>(behind(brown({-0.1, 0, 0, 0, 0, 0}), short_focus, {1920, 1080}, 0)), CameraError);
  CHECK_THROWS_WITH_AS(
      static_cast<void>(behind(brown({-0.1, 0, 0, 0, 0, 0}), camera_matrix(1000, 1000, 960, 540), {1920, 1080}, 1e-9)),
      doctest::Contains("give a larger frame_tolerance"), CameraError);
  CHECK(refusal(brown({1e300, -1e300, 1e300, 0, 0, 0})).find("folds at r = ") != std::string::npos);
  CHECK(refusal(brown({-0.3, 0, 0, 0, 0, 0})).find("folds") != std::string::npos);
  CHECK(refusal(brown({-0.11, 0, 0, 0, 0, 0})).empty());
}

TEST_CASE("A lens that does nothing is none") {
  const Camera without =
      calibrated_camera("c", camera_matrix(1000, 1000, 960, 540), Matrix3::Identity(), Vector3::Zero(), {1920, 1080});
  const Camera with = hd_behind({});
  CHECK(!with.lens_image);
  CHECK(with.right == without.right);
  CHECK(with.up == without.up);
  CHECK(with.forward == without.forward);
  CHECK(with.aspect == without.aspect);
}

TEST_CASE("The frame's corners are on the bent image's border, and its sides keep to the tolerance") {
  const std::uint64_t seed = 7;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::size_t frames = 0;
  for (int i = 0; i < 40; ++i) {
    std::optional<Camera> camera;
    const PixelOrigin origin = i % 2 == 0 ? PixelOrigin::corner : PixelOrigin::center;
    const double tolerance = i % 4 < 2 ? 0.01 : 0.5;
    try {
      camera = behind(random_lens(random), camera_matrix(1300, 1250, 940, 560), {1920, 1080, origin}, tolerance);
    } catch (const CameraError&) {
      continue;
    }
    ++frames;
    const LensImage& image = *camera->lens_image;
    const double first = origin == PixelOrigin::corner ? 0 : -0.5;
    const auto off_border = [&](const Point2& window) {
      const Point2 p = bent_pixel(image, window);
      const double dx = std::max(first - p.x, p.x - (first + 1920));
      const double dy = std::max(first - p.y, p.y - (first + 1080));
      return std::max(dx, dy) > 0 ? std::hypot(std::max(dx, 0.0), std::max(dy, 0.0)) : -std::max(dx, dy);
    };
    for (std::size_t c = 0; c < image.frame.size(); ++c) {
      const Point2& p = image.frame[c];
      const Point2& q = image.frame[(c + 1) % image.frame.size()];
      CHECK(off_border(p) < 1e-9);
      for (const double t : {0.1, 0.3, 0.6, 0.9})
        CHECK(off_border({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)}) <= tolerance);
    }
  }
  CHECK(frames > 20);
}

// Straightened by repeated substitution, as OpenCV does it: another way than Newton's.
TEST_CASE("The frame's area is that of the image's pixels, each straightened") {
  constexpr double p1 = 0.001;
  constexpr double p2 = -0.002;
  const Lens lens = brown({-0.11, 0.02, 0, 0, 0, 0}, {p1, p2});
  const Camera camera = hd_behind(lens);
  const auto straightened = [](double u, double v) {
    const Point2 target{(u - 960) / 1000, (v - 540) / 1000};
    Point2 p = target;
    for (int i = 0; i < 200; ++i) {
      const double s = p.x * p.x + p.y * p.y;
      const double f = 1 - 0.11 * s + 0.02 * s * s;
      p = {(target.x - 2 * p1 * p.x * p.y - p2 * (s + 2 * p.x * p.x)) / f,
           (target.y - p1 * (s + 2 * p.y * p.y) - 2 * p2 * p.x * p.y) / f};
    }
    return p;
  };
  double area = 0;
  constexpr double step = 20;
  for (double u = 0; u < 1920; u += step) {
    for (double v = 0; v < 1080; v += step) {
      const std::array corners{straightened(u, v), straightened(u + step, v), straightened(u + step, v + step),
                               straightened(u, v + step)};
      for (std::size_t i = 0; i < 4; ++i) {
        const Point2& a = corners[i];
        const Point2& b = corners[(i + 1) % 4];
        area += (a.x * b.y - b.x * a.y) / 2;
      }
    }
  }
  const LensImage& image = *camera.lens_image;
  const double in_window = area * 1000 * 1000 * 4 / (image.window_width * image.window_height);
  CHECK(frame_area(image) == doctest::Approx(in_window).epsilon(2e-5));
}

TEST_CASE("A bent line is as good as its tolerance, and the same from both ends") {
  const LensImage image = *hd_behind(brown({-0.11, 0, 0, 0, 0, 0})).lens_image;
  const Point2 a{-0.9, 0.8};
  const Point2 b{0.7, 0.85};
  const std::vector<Point2> there = bent_line(image, a, b, 0.05);
  std::vector<Point2> back = bent_line(image, b, a, 0.05);
  std::reverse(back.begin(), back.end());
  CHECK(there == back);
  CHECK(there.size() > 4);
  for (std::size_t i = 0; i + 1 < there.size(); ++i) {
    const Point2 p = bent_pixel(image, there[i]);
    const Point2 q = bent_pixel(image, there[i + 1]);
    const Point2 m = bent_pixel(image, {(there[i].x + there[i + 1].x) / 2, (there[i].y + there[i + 1].y) / 2});
    const double length = std::hypot(q.x - p.x, q.y - p.y);
    CHECK(std::fabs((q.x - p.x) * (m.y - p.y) - (q.y - p.y) * (m.x - p.x)) / length <= 0.05);
  }
}

// Numbers of OpenCV's own samples.
TEST_CASE("Calibrations of real lenses have a frame") {
  const Camera left =
      behind(brown({-2.6637260909660682e-01, -3.8588898922304653e-02, 2.3839153080878486e-01, 0, 0, 0},
                   {1.7831947042852964e-03, -2.8122100441115472e-04}),
             camera_matrix(535.91573396163199, 535.91573396163199, 342.28315473308373, 235.57082909788173),
             {640, 480, PixelOrigin::center});
  const Camera webcam =
      behind(brown({-4.1802327018241026e-001, 5.0715243805833121e-001, -5.7843596847939704e-001, 0, 0, 0}),
             camera_matrix(657.46697810243404, 657.46697810243404, 319.5, 239.5), {640, 480, PixelOrigin::center});
  const Camera colmap =
      behind(brown({-0.00686798, 0, 0, 0, 0, 0}), camera_matrix(3688.28, 3688.28, 2592, 1944), {5184, 3888});
  for (const Camera& camera : {left, webcam, colmap}) {
    REQUIRE(camera.lens_image);
    CHECK(frame_area(*camera.lens_image) > 2.5);
    CHECK(frame_area(*camera.lens_image) < 4);
  }
}

}  // namespace sightline::tests::lens_test
