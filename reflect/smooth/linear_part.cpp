#include "reflect/smooth/linear_part.h"

#include <algorithm>
#include <cmath>

namespace sightline::inline reflect {
namespace {

Barycentric between(const Barycentric& p, const Barycentric& q, double share) {
  return {p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1]), p[2] + share * (q[2] - p[2])};
}

// From the window to the triangle's coordinates, and back.
class TriangleMap {
 public:
  explicit TriangleMap(const ImageTriangle& triangle)
      : origin_(triangle[0]),
        second_(difference(triangle[1], triangle[0])),
        third_(difference(triangle[2], triangle[0])),
        determinant_(second_.x * third_.y - second_.y * third_.x) {}

  [[nodiscard]] Barycentric barycentric(const Point2& p) const {
    const Point2 d{p.x - static_cast<double>(origin_.x), p.y - static_cast<double>(origin_.y)};
    const double b = (d.x * third_.y - d.y * third_.x) / determinant_;
    const double c = (second_.x * d.y - second_.y * d.x) / determinant_;
    return {1 - b - c, b, c};
  }

  [[nodiscard]] ImagePoint rounded(const Barycentric& p) const {
    return {origin_.x + std::llround(p[1] * second_.x + p[2] * third_.x),
            origin_.y + std::llround(p[1] * second_.y + p[2] * third_.y)};
  }

 private:
  static Point2 difference(const ImagePoint& p, const ImagePoint& q) {
    return {static_cast<double>(p.x - q.x), static_cast<double>(p.y - q.y)};
  }

  ImagePoint origin_;
  Point2 second_;
  Point2 third_;
  double determinant_;
};

// Returns a rectangle three times as wide and as high as the triangle around it, as far as the window goes.
std::array<ImagePoint, 4> surroundings(const ImageTriangle& triangle, int grid_bits) {
  const std::int64_t border = std::int64_t{1} << grid_bits;
  const auto& [a, b, c] = triangle;
  const auto range = [&](std::int64_t p, std::int64_t q, std::int64_t r) {
    const auto [low, high] = std::minmax({p, q, r});
    return std::array{std::max(2 * low - high, -border), std::min(2 * high - low, border)};
  };
  const auto [left, right] = range(a.x, b.x, c.x);
  const auto [bottom, top] = range(a.y, b.y, c.y);
  return {{{left, bottom}, {right, bottom}, {right, top}, {left, top}}};
}

ImagePolygon rounded(const TriangleMap& map, const BarycentricPolygon& polygon, int grid_bits) {
  const std::int64_t border = std::int64_t{1} << grid_bits;
  ImagePolygon result;
  for (const Barycentric& p : polygon) {
    ImagePoint on_grid = map.rounded(p);
    on_grid = {std::clamp(on_grid.x, -border, border), std::clamp(on_grid.y, -border, border)};
    if (result.empty() || result.back() != on_grid) result.push_back(on_grid);
  }
  while (result.size() > 1 && result.front() == result.back()) result.pop_back();
  return result.size() < 3 ? ImagePolygon{} : result;
}

bool is_finite(double value) { return std::isfinite(value); }
bool is_negative(double value) { return value < 0; }

}  // namespace

LinearPart linear_part(const ImageTriangle& triangle, const std::vector<CornerValues>& functions, int grid_bits) {
  const TriangleMap map(triangle);
  BarycentricPolygon polygon;
  for (const ImagePoint& p : surroundings(triangle, grid_bits))
    polygon.push_back(map.barycentric({static_cast<double>(p.x), static_cast<double>(p.y)}));
  bool is_whole = true;
  for (const CornerValues& values : functions) {
    if (!std::ranges::all_of(values, is_finite) || std::ranges::all_of(values, is_negative)) return {};
    if (std::ranges::none_of(values, is_negative)) continue;
    is_whole = false;
    polygon = part_above(polygon, values, 0);
  }
  return {rounded(map, polygon, grid_bits), is_whole};
}

Barycentric barycentric(const ImageTriangle& triangle, const Point2& place) {
  return TriangleMap(triangle).barycentric(place);
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
