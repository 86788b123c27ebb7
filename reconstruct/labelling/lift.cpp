#include "reconstruct/labelling/lift.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace sightline::inline reconstruct {
namespace {

double signed_quotient(const Wide512& numerator, const Wide512& denominator) {
  return denominator < 0 ? rounded_quotient(Wide512(-numerator), Wide512(-denominator))
                         : rounded_quotient(numerator, denominator);
}

// Returns twice the area of a, b, p, times p's denominator.
Wide512 scaled_area(const ImagePoint& a, const ImagePoint& b, const ExactPoint& p) {
  const Wide512 constant = Wide512(static_cast<Int128>(a.x) * b.y - static_cast<Int128>(a.y) * b.x);
  return p.x * Wide512(a.y - b.y) + p.y * Wide512(b.x - a.x) + p.denominator * constant;
}

// Returns weights W in units of about the smallest of them: ratios are all that counts, and of denormal numbers
// products would vanish and quotients overflow. A weight that was rounded to 0 is taken as the smallest double; one
// that is 2^1000 times another is cut off there.
template <std::size_t N>
std::array<double, N> relative_weights(std::array<double, N> weights) {
  const double least = *std::min_element(weights.begin(), weights.end());
  const double unit = std::max(least, std::numeric_limits<double>::denorm_min());
  for (double& w : weights) w = std::min(std::scalbn(std::max(w, unit), -std::ilogb(unit)), 0x1p1000);
  return weights;
}

// This is a corner in space.
struct LiftedCorner {
  Point3 position = Point3::Zero();
  double weight = 1;  // perspective weight, W
};

LiftedCorner lifted(const ProjectedScene& scene, const ClippedCorner& corner) {
  return {position_of(scene, corner), weight_of(scene, corner)};
}

// Returns the point at image fraction s between a and b: perspective weights turn it into the fraction on the edge.
Point3 between(const LiftedCorner& a, const LiftedCorner& b, double s) {
  const auto [w_a, w_b] = relative_weights(std::array{a.weight, b.weight});
  const double t = s * w_a / ((1 - s) * w_b + s * w_a);
  return a.position + t * (b.position - a.position);
}

// What is barycentric in the image is, divided by W, barycentric on the facet up to a factor.
Point3 in_triangle(const LiftedCorner& a, const LiftedCorner& b, const LiftedCorner& c,
                   const std::array<Wide512, 3>& areas) {
  const auto [w_a, w_b, w_c] = relative_weights(std::array{a.weight, b.weight, c.weight});
  const double weight0 = static_cast<double>(areas[0]) / w_a;
  const double weight1 = static_cast<double>(areas[1]) / w_b;
  const double weight2 = static_cast<double>(areas[2]) / w_c;
  const double sum = (weight0 + weight1) + weight2;
  const Point3& origin = a.position;
  return origin + ((weight1 / sum) * (b.position - origin) + (weight2 / sum) * (c.position - origin));
}

}  // namespace

Point3 lift_on_edge(const ProjectedScene& scene, const ImagePoints& points, const ClippedCorner& a,
                    const ClippedCorner& b, PointId p) {
  const ImagePoint& image_a = scene.point(a.point);
  const ImagePoint& image_b = scene.point(b.point);
  const ExactPoint exact = exact_point(scene, points.segments(), p);
  const std::int64_t dx = image_b.x - image_a.x;
  const std::int64_t dy = image_b.y - image_a.y;
  const double s =
      std::abs(dx) > std::abs(dy)
          ? signed_quotient(exact.x - Wide512(image_a.x) * exact.denominator, Wide512(dx) * exact.denominator)
          : signed_quotient(exact.y - Wide512(image_a.y) * exact.denominator, Wide512(dy) * exact.denominator);
  return between(lifted(scene, a), lifted(scene, b), s);
}

// The polygon is taken as a fan of triangles around its first corner.
std::optional<Point3> lift_on_facet(const ProjectedScene& scene, const ImagePoints& points, FacetId facet, PointId p) {
  const auto polygon = scene.polygon(facet);
  const ExactPoint exact = exact_point(scene, points.segments(), p);
  const auto image = [&](std::size_t i) { return scene.point(polygon[i].point); };
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Sign turn = orientation(image(0), image(i), image(i + 1));
    if (turn == 0) continue;
    const std::array<Wide512, 3> areas{Wide512(turn * scaled_area(image(i), image(i + 1), exact)),
                                       Wide512(turn * scaled_area(image(i + 1), image(0), exact)),
                                       Wide512(turn * scaled_area(image(0), image(i), exact))};
    if (areas[0] < 0 || areas[1] < 0 || areas[2] < 0) continue;
    return in_triangle(lifted(scene, polygon[0]), lifted(scene, polygon[i]), lifted(scene, polygon[i + 1]), areas);
  }
  return std::nullopt;
}

}  // namespace sightline::inline reconstruct
