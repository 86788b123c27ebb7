#include "geometry/projection/vertex_projection.h"

#include <array>
#include <limits>

#include "geometry/numbers/rounding.h"
#include "geometry/projection/clipping.h"

namespace sightline::inline geometry {
namespace {

// A double and a bound on its distance from the exact value. The bounds are inflated by their own roundings: every step
// below rounds a bound up by at least 4 u, and no bound goes through more than four operations.
struct Bounded {
  double value = 0;
  double error = 0;
};

// row . (v - origin): each term rounds at most four times (difference, product, two sums): (1 + u)^4 - 1 < 5 u. An
// underflow costs less than 2^-1000, which is added.
Bounded linear_form_value(const Vector3& row, const Point3& v, const Point3& origin) {
  const Vector3 d = v - origin;
  const double x = row.x() * d.x();
  const double y = row.y() * d.y();
  const double z = row.z() * d.z();
  return {(x + y) + z, 6 * unit_roundoff * ((std::fabs(x) + std::fabs(y)) + std::fabs(z)) + 0x1p-1000};
}

Bounded sum(const Bounded& a, double sign, const Bounded& b) {
  const double value = a.value + sign * b.value;
  return {value, (a.error + b.error + unit_roundoff * std::fabs(value)) * (1 + 8 * unit_roundoff)};
}

std::optional<Sign> sign(const Bounded& b) {
  if (!(b.error < std::numeric_limits<double>::infinity())) return std::nullopt;
  if (b.value > b.error) return 1;
  if (b.value < -b.error) return -1;
  return std::nullopt;
}

// The window edge coordinates of Fang's table 5.1; bounds that the camera does not have are satisfied.
std::array<Bounded, 6> window_edge_coordinates(const Camera& camera, const Bounded& x, const Bounded& y,
                                               const Bounded& w, const Bounded& depth) {
  const Bounded satisfied{1, 0};
  return {sum(w, 1, x),
          sum(w, -1, x),
          sum(w, 1, y),
          sum(w, -1, y),
          camera.near_distance ? sum(depth, -1, Bounded{*camera.near_distance, 0}) : satisfied,
          camera.far_distance ? sum(Bounded{*camera.far_distance, 0}, -1, depth) : satisfied};
}

void set_outcode(ProjectedVertex& vertex, std::size_t bound, Sign wec) {
  const auto bit = static_cast<std::uint8_t>(1U << bound);
  if (wec < 0) vertex.strictly_outside |= bit;
  if (wec <= 0) vertex.on_or_outside |= bit;
}

// round(numerator / denominator * 2^bits) where the error bound leaves one answer. In the window the scaled quotient is
// below 2^41, where adding 1/2 rounds by at most 2^-12; 2^-10 covers that and the error of the error.
std::optional<std::int64_t> rounded(const Bounded& numerator, const Bounded& denominator, int bits) {
  if (!(denominator.value > 2 * denominator.error)) return std::nullopt;
  const double quotient = std::fabs(numerator.value / denominator.value);
  const double error = (numerator.error + quotient * denominator.error) / (denominator.value - denominator.error) +
                       2 * unit_roundoff * quotient;
  const double scaled_error = std::ldexp(error, bits) + 0x1p-10;
  if (!(scaled_error < 0.5)) return std::nullopt;
  const double scaled_quotient = std::ldexp(quotient, bits);
  const double low = std::floor(scaled_quotient - scaled_error + 0.5);
  const double high = std::floor(scaled_quotient + scaled_error + 0.5);
  if (low != high) return std::nullopt;
  const auto magnitude = static_cast<std::int64_t>(low);
  return numerator.value < 0 ? -magnitude : magnitude;
}

ProjectedVertex projected(const ExactCorner& corner, const Camera& camera, int grid_bits) {
  ProjectedVertex result;
  const std::vector<BigInteger> wecs = window_edge_coordinates(camera, corner);
  for (std::size_t bound = 0; bound < wecs.size(); ++bound) set_outcode(result, bound, sign_of(wecs[bound]));
  if (result.strictly_outside != 0 || corner.w == 0) return result;
  result.image = round_to_grid(corner, grid_bits);
  result.w = corner.weight();
  return result;
}

}  // namespace

namespace projection_tiers {

std::optional<ProjectedVertex> filtered(const Point3& v, const Camera& camera, int grid_bits) {
  const Bounded x = linear_form_value(camera.right, v, camera.origin);
  const Bounded y = linear_form_value(camera.up, v, camera.origin);
  const Bounded depth = linear_form_value(camera.forward, v, camera.origin);
  const Bounded w = camera.projection == Projection::perspective ? depth : Bounded{1, 0};
  ProjectedVertex result;
  const auto wecs = window_edge_coordinates(camera, x, y, w, depth);
  for (std::size_t bound = 0; bound < wecs.size(); ++bound) {
    const auto decided = sign(wecs[bound]);
    if (!decided) return std::nullopt;
    set_outcode(result, bound, *decided);
  }
  if (result.strictly_outside != 0) return result;
  const auto image_x = rounded(x, w, grid_bits);
  const auto image_y = rounded(y, w, grid_bits);
  if (!image_x || !image_y) return std::nullopt;
  result.image = {*image_x, *image_y};
  result.w = w.value;
  return result;
}

ProjectedVertex exact(const Point3& v, const Camera& camera, int grid_bits) {
  return projected(exact_corner(v, camera), camera, grid_bits);
}

}  // namespace projection_tiers

ProjectedVertex project_vertex(const Point3& vertex, const Camera& camera, int grid_bits) {
  const auto fast = projection_tiers::filtered(vertex, camera, grid_bits);
  return fast ? *fast : projection_tiers::exact(vertex, camera, grid_bits);
}

ProjectedVertex project_vertex(const Mesh& mesh, VertexId vertex, const Camera& camera, int grid_bits) {
  if (vertex.index() < mesh.input_vertex_count()) return project_vertex(mesh.position(vertex), camera, grid_bits);
  return projected(exact_corner(mesh, vertex, camera), camera, grid_bits);
}

}  // namespace sightline::inline geometry
