// The polynomials of bent mirrors against rays, and Bernstein's bounds against values.
#include "reflect/smooth/bent_mirror.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

namespace sightline::tests::bent_mirror_test {
namespace {

constexpr std::uint64_t seed = 1986;

class Numbers {
 public:
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  Vector3 vector(double reach) { return {between(-reach, reach), between(-reach, reach), between(-reach, reach)}; }
  std::array<double, 3> share() {
    std::array<double, 3> b{between(0, 1), between(0, 1), between(0, 1)};
    const double sum = b[0] + b[1] + b[2];
    for (double& value : b) value /= sum;
    return b;
  }

 private:
  std::mt19937_64 random_{seed};
};

Quartic random_quartic(Numbers& numbers) {
  BarycentricForm<4, double> form;
  for (double& c : form.coefficients) c = numbers.between(-1, 1);
  return Quartic(form);
}

struct Ray {
  Point3 start;
  Vector3 direction;
};

// The law of reflection at a place of the window, step by step.
Ray mirrored_ray(const Camera& camera, const BentTriangle& t, const Point2& place) {
  const bool has_eye = camera.projection == Projection::perspective;
  const Vector3 beside =
      place.x / camera.right.squaredNorm() * camera.right + place.y / camera.up.squaredNorm() * camera.up;
  const Point3 from = has_eye ? camera.origin : Point3(camera.origin + beside);
  const Vector3 direction = has_eye ? Vector3(camera.forward + beside) : camera.forward;
  const double distance = t.towards_eye.dot(t.corners[0] - from) / t.towards_eye.dot(direction);
  const Point3 start = from + distance * direction;
  Vector3 normal = Vector3::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3 p = t.corners[(i + 1) % 3] - start;
    const Vector3 q = t.corners[(i + 2) % 3] - start;
    normal += p.cross(q).dot(t.towards_eye) * t.normals[i];
  }
  normal.normalize();
  return {start, direction - 2 * direction.dot(normal) * normal};
}

struct Scene {
  Camera camera;
  BentTriangle triangle;
  BentMirror::WindowTriangle window;
};

// The corners' images are the window triangle's, nearly.
Scene random_scene(Numbers& numbers) {
  Scene scene;
  ViewPoint view;
  view.eye = Point3(0, 0, 5) + numbers.vector(1);
  view.target = numbers.vector(0.3);
  scene.camera = numbers.between(0, 1) < 0.5 ? perspective_camera("p", view, 40) : orthographic_camera("o", view, 4);
  for (Point3& corner : scene.triangle.corners) corner = numbers.vector(1);
  Vector3 normal = (scene.triangle.corners[1] - scene.triangle.corners[0])
                       .cross(scene.triangle.corners[2] - scene.triangle.corners[0])
                       .normalized();
  if (normal.dot(view.eye - scene.triangle.corners[0]) < 0) normal = -normal;
  scene.triangle.towards_eye = normal;
  for (Vector3& n : scene.triangle.normals) n = (normal + numbers.vector(0.3)).normalized();
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3 from = scene.triangle.corners[i] - scene.camera.origin;
    const double weight = scene.camera.projection == Projection::perspective ? scene.camera.forward.dot(from) : 1;
    scene.window[i] = {scene.camera.right.dot(from) / weight, scene.camera.up.dot(from) / weight};
  }
  return scene;
}

Point2 place_at(const BentMirror::WindowTriangle& t, const std::array<double, 3>& b) {
  return {b[0] * t[0].x + b[1] * t[1].x + b[2] * t[2].x, b[0] * t[0].y + b[1] * t[1].y + b[2] * t[2].y};
}

// Signs are compared where neither is near zero.
void check_sign(const Condition& condition, const std::array<double, 3>& b, double expected, int& compared) {
  const double found = condition.value.at(b);
  if (std::fabs(expected) < 1e-9 || std::fabs(found) <= condition.noise) return;
  ++compared;
  CHECK((found > 0) == (expected > 0));
}

}  // namespace

TEST_CASE(
    "quartics stay within their coefficients, and as near to linear as they say; halves are the same polynomial") {
  INFO("seed ", seed);
  Numbers numbers;
  for (int i = 0; i < 300; ++i) {
    const Quartic quartic = random_quartic(numbers);
    const std::array<Quartic, 2> halves = quartic.halves();
    const auto [a, b, c] = quartic.corners();
    for (int k = 0; k < 30; ++k) {
      const std::array<double, 3> at = numbers.share();
      const double value = quartic.at(at);
      CHECK(value >= quartic.least() - 1e-15);
      CHECK(value <= quartic.greatest() + 1e-15);
      const double linear = a * at[0] + b * at[1] + c * at[2];
      CHECK(value - linear <= quartic.departure().above + 1e-15);
      CHECK(linear - value <= quartic.departure().below + 1e-15);
      // The halves are (c, a, m) and (b, c, m).
      CHECK(halves[0].at(at) == doctest::Approx(quartic.at({at[1] + at[2] / 2, at[2] / 2, at[0]})).epsilon(1e-12));
      CHECK(halves[1].at(at) == doctest::Approx(quartic.at({at[2] / 2, at[0] + at[2] / 2, at[1]})).epsilon(1e-12));
    }
  }
}

TEST_CASE("conditions hold where rays say so, of cameras of both kinds; beams hold all rays") {
  INFO("seed ", seed);
  Numbers numbers;
  int compared = 0;
  int met_before = 0;
  for (int i = 0; i < 1000; ++i) {
    CAPTURE(i);
    const Scene scene = random_scene(numbers);
    const BentMirror mirror(scene.camera, 1, scene.triangle, scene.window);
    const std::array<Point3, 3> facet{numbers.vector(3), numbers.vector(3), numbers.vector(3)};
    const BentMirror::Plane first{(facet[1] - facet[0]).cross(facet[2] - facet[0]).normalized(), facet[0]};
    const BentMirror::Plane second{numbers.vector(1).normalized(), numbers.vector(3)};
    const RayBeam beam = mirror.beam();
    for (int k = 0; k < 20; ++k) {
      const std::array<double, 3> at = numbers.share();
      const Ray ray = mirrored_ray(scene.camera, scene.triangle, place_at(scene.window, at));
      check_sign(mirror.rises(), at, scene.triangle.towards_eye.dot(ray.direction), compared);
      check_sign(mirror.starts_before(first), at, first.normal.dot(ray.start - first.point), compared);
      const Vector3 across = (facet[0] - ray.start).cross(facet[1] - ray.start);
      check_sign(mirror.passes_left_of(facet[0], facet[1]), at, -ray.direction.dot(across), compared);
      const double height = first.normal.dot(ray.start - first.point);
      const double sinking = -first.normal.dot(ray.direction);
      if (height > 0 && sinking > 0) {
        ++met_before;
        const Point3 met = ray.start + height / sinking * ray.direction;
        check_sign(mirror.meets_before(first, second), at, second.normal.dot(met - second.point), compared);
      }
      const Point3 further = ray.start + numbers.between(0, 5) * ray.direction;
      if (scene.triangle.towards_eye.dot(ray.direction) > 0) CHECK(beam.may_reach({further, further}));
    }
  }
  CHECK(compared > 50000);
  CHECK(met_before > 1000);
}

}  // namespace sightline::tests::bent_mirror_test
