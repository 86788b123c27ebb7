#include "reflect/smooth/barycentric_polygon.h"

namespace sightline::inline reflect {

Barycentric barycentric(const ImageTriangle& triangle, const Point2& place) {
  const auto from_first = [&](double x, double y) {
    return Point2{x - static_cast<double>(triangle[0].x), y - static_cast<double>(triangle[0].y)};
  };
  const auto corner = [&](std::size_t i) {
    return from_first(static_cast<double>(triangle[i].x), static_cast<double>(triangle[i].y));
  };
  const Point2 second = corner(1);
  const Point2 third = corner(2);
  const Point2 d = from_first(place.x, place.y);
  const double determinant = second.x * third.y - second.y * third.x;
  const double b = (d.x * third.y - d.y * third.x) / determinant;
  const double c = (second.x * d.y - second.y * d.x) / determinant;
  return {1 - b - c, b, c};
}

BarycentricPolygon whole_triangle() { return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}; }

// This is one side of Sutherland and Hodgman's clipping.
BarycentricPolygon part_above(const BarycentricPolygon& polygon, const CornerValues& values, double least) {
  BarycentricPolygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Barycentric& p = polygon[i];
    const Barycentric& q = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    const double at_p = value_at(values, p) - least;
    const double at_q = value_at(values, q) - least;
    if (at_p >= 0) result.push_back(p);
    if ((at_p >= 0) != (at_q >= 0)) result.push_back(between(p, q, at_p / (at_p - at_q)));
  }
  return result;
}

// Twice the area in the plane of the last two coordinates, in which the triangle has 1.
double share_of(const BarycentricPolygon& polygon) {
  double share = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const auto along = [&](std::size_t to, std::size_t coordinate) {
      return polygon[to][coordinate] - polygon[0][coordinate];
    };
    share += along(i - 1, 1) * along(i, 2) - along(i - 1, 2) * along(i, 1);
  }
  return share;
}

}  // namespace sightline::inline reflect
