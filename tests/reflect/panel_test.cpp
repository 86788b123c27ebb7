// Panels as people write them: in decimals, which are rounded.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "reflect/world/mirror_world.h"
#include "tests/reflect/mirror_outcome.h"
#include "tests/tools/polygon_mesh.h"

namespace sightline::tests::panel_test {
namespace {

// Turns about an axis that lies along no other one.
Eigen::Matrix3d turn(double angle) {
  return Eigen::AngleAxisd(angle, Vector3(0.3, 0.5, 0.8).normalized()).toRotationMatrix();
}

Corners turned(const Corners& corners, double angle) {
  Corners result;
  for (const Point3& p : corners) result.emplace_back(turn(angle) * p);
  return result;
}

Corners with_digits(const Corners& corners, int digits) {
  const double unit = std::pow(10.0, digits);
  Corners result;
  for (const Point3& p : corners)
    result.emplace_back(std::round(p.x() * unit) / unit, std::round(p.y() * unit) / unit,
                        std::round(p.z() * unit) / unit);
  return result;
}

const Corners tilted{{0, 3, 1}, {1.1, 3.3, 1.2}, {0.8, 3.4, 2.3}, {-0.3, 3.1, 2.1}};

}  // namespace

TEST_CASE("a tilted rectangle whose corners are decimals is a panel") {
  const FittedPanel fitted = fitted_panel({"screen", tilted});
  CHECK(fitted.deviation > 0);
  CHECK(fitted.deviation < 1e-15);
  for (std::size_t i = 0; i < 4; ++i) CHECK(norm(fitted.corners[i] - tilted[i]) < 1e-15);
  CHECK(panel_mesh({"screen", tilted}).facet_count() == 2);
}

TEST_CASE(
    "rectangles that are turned and written with 6 to 12 digits are panels, and off their plane by what was rounded") {
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> angle(0, 2 * std::numbers::pi);
  int planar = 0;
  for (int i = 0; i < 60; ++i) {
    const int digits = 6 + i % 7;
    const Corners corners = with_digits(turned({{1, 2, 3}, {3, 2, 3}, {3, 5, 3}, {1, 5, 3}}, angle(random)), digits);
    CAPTURE(i);
    const FittedPanel fitted = fitted_panel({"screen", corners});
    CHECK(fitted.deviation <= std::pow(10.0, -digits));
    planar += fitted.deviation == 0 ? 1 : 0;
    const auto plane = panel_plane(uncrossed(panel_mesh({"screen", corners})));
    const Vector3 normal = unit((plane[1] - plane[0]).cross(plane[2] - plane[0]));
    CHECK(norm(normal - unit((corners[1] - corners[0]).cross(corners[2] - corners[0]))) < 10 * std::pow(10.0, -digits));
  }
  CHECK(planar < 10);
}

TEST_CASE("corners in one plane, exactly, stay what they are to the last bit") {
  for (const Corners& corners : {Corners{{0.1, 0.2, 7}, {0.7, 0.3, 7}, {0.9, 1.1, 7}, {0.2, 0.8, 7}},
                                 Corners{{0.1, 0.2, 0.3}, {0.7, 0.3, 0.9}, {0.9, 1.1, 2.7}}}) {
    const FittedPanel fitted = fitted_panel({"screen", corners});
    CHECK(fitted.deviation == 0);
    CHECK(fitted.corners == corners);
  }
}

TEST_CASE("a panel whose corner is too far off its plane is refused, and what the message says to write is accepted") {
  Corners bent = tilted;
  bent[2].y() += 0.01;
  try {
    static_cast<void>(fitted_panel({"screen", bent}));
    FAIL("accepted");
  } catch (const PanelError& error) {
    const std::string message = error.what();
    CAPTURE(message);
    CHECK(message.find(" of 4 is ") != std::string::npos);
    CHECK(message.find("larger planarity than 1e-06") != std::string::npos);
    const std::size_t corner = static_cast<std::size_t>(message[message.find(" of 4 is ") - 1] - '1');
    const std::size_t open = message.find("write [") + 7;
    std::size_t read = 0;
    std::string rest = message.substr(open);
    for (const int axis : {0, 1, 2}) {
      bent[corner][axis] = std::stod(rest, &read);
      rest = rest.substr(read + 1);
    }
  }
  CHECK(fitted_panel({"screen", bent}).deviation < 1e-15);
}

TEST_CASE("planarity says how far corners may be off") {
  Corners bent = tilted;
  bent[2].y() += 1e-4;
  CHECK_THROWS_AS((void)fitted_panel({"screen", bent}), PanelError);
  CHECK_THROWS_AS((void)fitted_panel({"screen", bent, Emits::both, 1e-6}), PanelError);
  const FittedPanel fitted = fitted_panel({"screen", bent, Emits::both, 1e-3});
  CHECK(fitted.deviation > 1e-5);
  CHECK(fitted.deviation < 1e-4);
}

TEST_CASE("at the extremes of numbers panels are fitted as elsewhere") {
  for (const double scale : {0x1p-1000, 0x1p-500, 0x1p500, 0x1p1000}) {
    Corners corners;
    for (const Point3& p : tilted) corners.push_back(scale * p);
    const FittedPanel fitted = fitted_panel({"screen", corners});
    CHECK(fitted.deviation == scale * fitted_panel({"screen", tilted}).deviation);
    CHECK(panel_plane(uncrossed(panel_mesh({"screen", corners})))[0] ==
          Point3(scale * fitted_panel({"screen", tilted}).corners[0]));
  }
}

TEST_CASE("a panel of many corners, some nearly on one line, has the plane of all of them") {
  Corners corners;
  for (int i = 0; i < 64; ++i) {
    const double angle = 2 * std::numbers::pi * i / 64;
    corners.emplace_back(std::cos(angle), std::sin(angle), 4);
  }
  corners.insert(corners.begin() + 1, 0.5 * (corners[0] + corners[1]));
  const Corners written = with_digits(turned(corners, 1), 9);
  const auto plane = panel_plane(uncrossed(panel_mesh({"disc", written})));
  const Vector3 normal = unit((plane[1] - plane[0]).cross(plane[2] - plane[0]));
  CHECK(norm(normal - turn(1) * Vector3(0, 0, 1)) < 1e-8);
}

// The view of a mirror and a panel, both turned; the camera, too.
TEST_CASE("a mirrored panel has its area whichever way the scene is turned and rounded") {
  const Corners mirror{{-8, -8, 0}, {8, -8, 0}, {8, 8, 0}, {-8, 8, 0}};
  const Corners panel{{2, -1, 4}, {4, -1, 4}, {4, 1, 4}, {2, 1, 4}};
  for (const ReflectionMode mode : {ReflectionMode::exact, ReflectionMode::smooth}) {
    for (const double angle : {0.0, 0.4, 1.1, 2.5}) {
      CAPTURE(angle);
      ViewPoint from;
      from.eye = turn(angle) * Point3(-2, 0, 4);
      from.target = turn(angle) * Point3(0, 0, 0);
      from.up = turn(angle) * Vector3(0, 1, 0);
      const Corners written = angle == 0 ? panel : with_digits(turned(panel, angle), 9);
      const MirrorOutcome outcome = reflected(AnyMesh(mesh_of({turned(mirror, angle)})), {{"panel", written}},
                                              perspective_camera("c", from, 120), {mode, MirrorNormals::vertex, 1e-4});
      CHECK(outcome.areas[0] == doctest::Approx(1).epsilon(1e-4));
    }
  }
}

// The panel is the lower half of a screen, and lies in its plane.
TEST_CASE("a panel flush with its screen has all of its light where the scene snaps, in every pose") {
  const Corners mirror{{-8, -8, 0}, {8, -8, 0}, {8, 8, 0}, {-8, 8, 0}};
  const Corners screen{{3, -2, 1}, {3, -2, 5}, {3, 2, 5}, {3, 2, 1}};
  const Corners panel{{3, -1, 2}, {3, -1, 4}, {3, 1, 4}, {3, 1, 2}};
  const auto area = [&](double angle, ReflectionMode mode, bool snaps) {
    ViewPoint from;
    from.eye = turn(angle) * Point3(-2, 0, 4);
    from.target = turn(angle) * Point3(0, 0, 0);
    from.up = turn(angle) * Vector3(0, 1, 0);
    ReflectionOptions options{mode, MirrorNormals::vertex, 1e-3};
    options.snaps = snaps;
    const Mesh mesh = mesh_of({turned(mirror, angle), turned(screen, angle)});
    return reflected(AnyMesh(mesh), {{"panel", turned(panel, angle)}}, perspective_camera("c", from, 120), options)
        .areas[0];
  };
  for (const ReflectionMode mode : {ReflectionMode::exact, ReflectionMode::smooth}) {
    const double upright = area(0, mode, false);
    CHECK(upright > 0.9);
    int wrong = 0;
    for (int i = 1; i <= 10; ++i) {
      CAPTURE(i);
      CHECK(area(0.6 * i, mode, true) == doctest::Approx(upright).epsilon(2e-3));
      wrong += std::fabs(area(0.6 * i, mode, false) - upright) > 0.1 * upright ? 1 : 0;
    }
    if (mode == ReflectionMode::exact) CHECK(wrong > 0);
  }
}

TEST_CASE("panels that lie on each other but for rounding: the first one is in front where the scene snaps") {
  const Corners mirror{{-8, -8, 0}, {8, -8, 0}, {8, 8, 0}, {-8, 8, 0}};
  const Corners first{{2, -1, 4}, {4, -1, 4}, {4, 1, 4}, {2, 1, 4}};
  const Corners second{{2, -1, 4 + 1e-12}, {4, -1, 4 - 1e-12}, {4, 3, 4}, {2, 3, 4 + 1e-12}};
  ReflectionOptions options;
  options.snaps = true;
  const MirrorOutcome outcome =
      reflected(AnyMesh(mesh_of({mirror})), {{"first", first}, {"second", second}}, looking_down(mirror_eye), options);
  CHECK(outcome.areas[0] == doctest::Approx(1));
  CHECK(outcome.areas[1] == doctest::Approx(1));
}

TEST_CASE("of two panels with the same corners, be they turned, the first one is in front in every pose") {
  const Corners mirror{{-8, -8, 0}, {8, -8, 0}, {8, 8, 0}, {-8, 8, 0}};
  const Corners panel{{2, -1, 4}, {4, -1, 4}, {4, 1, 4}, {2, 1, 4}};
  int triangles = 0;
  for (int i = 0; i < 12; ++i) {
    CAPTURE(i);
    const double angle = 0.4 * i;
    ViewPoint from;
    from.eye = turn(angle) * Point3(-2, 0, 4);
    from.target = turn(angle) * Point3(0, 0, 0);
    from.up = turn(angle) * Vector3(0, 1, 0);
    const Corners first = with_digits(turned(panel, angle), 9);
    Corners second = first;
    if (i % 2 == 1) std::ranges::reverse(second);
    triangles += panel_mesh({"first", first}).facet_count() > 1 ? 1 : 0;
    const MirrorOutcome outcome = reflected(AnyMesh(mesh_of({turned(mirror, angle)})),
                                            {{"first", first}, {"second", second}}, perspective_camera("c", from, 120));
    CHECK(outcome.areas[0] == doctest::Approx(1).epsilon(1e-6));
    CHECK(outcome.areas[1] == 0);
  }
  CHECK(triangles > 6);
}

TEST_CASE("a panel that lies on the mirror hides no other one where the scene snaps") {
  const Corners mirror{{-8, -8, 0}, {8, -8, 0}, {8, 8, 0}, {-8, 8, 0}};
  const Panel far{"far", {{2, -1, 4}, {4, -1, 4}, {4, 1, 4}, {2, 1, 4}}};
  for (const ReflectionMode mode : {ReflectionMode::exact, ReflectionMode::smooth}) {
    for (const double height : {-1e-12, 0.0, 1e-12}) {
      CAPTURE(height);
      ReflectionOptions options{mode};
      options.snaps = true;
      const Panel flush{"flush", {{-1, -1, height}, {1, -1, height}, {1, 1, height}, {-1, 1, height}}};
      const MirrorOutcome outcome =
          reflected(AnyMesh(mesh_of({mirror})), {flush, far}, looking_down(mirror_eye), options);
      CHECK(outcome.areas[1] == doctest::Approx(1).epsilon(1e-9));
      CHECK(outcome.areas[0] == 0);
    }
  }
}

}  // namespace sightline::tests::panel_test
