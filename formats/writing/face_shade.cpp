#include "formats/writing/face_shade.h"

#include <algorithm>

namespace sightline::inline formats {

namespace {

struct Ramp {
  std::array<double, 3> dark;
  std::array<double, 3> light;
};

constexpr Ramp front_ramp{{34, 51, 84}, {226, 236, 247}};
constexpr Ramp back_ramp{{92, 62, 38}, {250, 232, 205}};

// The lamp is in this direction, in the camera's frame (right, up, towards the viewer).
const Vector3 lamp{-0.42, 0.56, 0.71};
constexpr double stroke_share = 0.72;

Vector3 normalised(const Vector3& v) {
  const double length = norm(v);
  return length > 0 ? Vector3{v.x() / length, v.y() / length, v.z() / length} : v;
}

// This is Newell's normal: corners may lie on one line with their neighbours.
Vector3 facet_normal(const CutMesh& mesh, FacetId facet) {
  const auto corners = mesh.corners(facet);
  const Point3& first = mesh.position(corners[0]);
  Vector3 normal = Vector3::Zero();
  for (std::size_t i = 2; i < corners.size(); ++i) {
    normal = normal + (mesh.position(corners[i - 1]) - first).cross(mesh.position(corners[i]) - first);
  }
  return normalised(normal);
}

// The shading is half-Lambert: what is turned away from the lamp keeps its shape.
double brightness(const Vector3& normal, const Camera& camera) {
  const Vector3 seen{normal.dot(normalised(camera.right)), normal.dot(normalised(camera.up)),
                     -normal.dot(camera.forward)};
  // In this order a normal that overflowed to NaN gives 0.
  const double wrapped = std::min(1.0, std::max(0.0, 0.5 + 0.5 * seen.dot(lamp)));
  return wrapped * wrapped;
}

Colour mixed(const Ramp& ramp, double share, double factor) {
  Colour colour{};
  for (std::size_t i = 0; i < 3; ++i) {
    colour[i] = static_cast<std::uint8_t>(factor * (ramp.dark[i] + share * (ramp.light[i] - ramp.dark[i])));
  }
  return colour;
}

}  // namespace

FaceShade face_shade(const CutMesh& mesh, const Camera& camera, FacetId facet, FacetFacing facing) {
  const Vector3 normal = facet_normal(mesh, facet);
  const double share = brightness(facing == FacetFacing::back ? -1.0 * normal : normal, camera);
  const Ramp& ramp = facing == FacetFacing::back ? back_ramp : front_ramp;
  return {mixed(ramp, share, 1), mixed(ramp, share, stroke_share)};
}

}  // namespace sightline::inline formats
