#include "reflect/exact/linear_part.h"

#include <algorithm>
#include <cmath>

namespace sightline::inline reflect {
namespace {

using Polygon = std::vector<Point2>;

// Returns the triangle's surroundings, in the window.
Polygon surroundings(const RightTriangle& triangle, int grid_bits) {
  const double border = std::ldexp(1.0, grid_bits);
  const auto& [corner, along_x, along_y] = triangle;
  const auto range = [&](std::int64_t p, std::int64_t q) {
    const auto low = static_cast<double>(std::min(p, q));
    const auto high = static_cast<double>(std::max(p, q));
    return std::array{std::max(low - (high - low), -border), std::min(high + (high - low), border)};
  };
  const auto [left, right] = range(corner.x, along_x.x);
  const auto [bottom, top] = range(corner.y, along_y.y);
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

class LinearFunction {
 public:
  LinearFunction(const RightTriangle& triangle, const CornerValues& values)
      : corner_(triangle[0]),
        value_(values[0]),
        per_x_((values[1] - values[0]) / static_cast<double>(triangle[1].x - triangle[0].x)),
        per_y_((values[2] - values[0]) / static_cast<double>(triangle[2].y - triangle[0].y)) {}

  [[nodiscard]] double at(const Point2& p) const {
    return value_ + (per_x_ * (p.x - static_cast<double>(corner_.x)) + per_y_ * (p.y - static_cast<double>(corner_.y)));
  }

 private:
  ImagePoint corner_;
  double value_;
  double per_x_;
  double per_y_;
};

// This is one side of Sutherland and Hodgman's clipping.
Polygon clipped(const Polygon& polygon, const LinearFunction& function) {
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2& p = polygon[i];
    const Point2& q = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    const double at_p = function.at(p);
    const double at_q = function.at(q);
    if (at_p >= 0) result.push_back(p);
    if ((at_p >= 0) == (at_q >= 0)) continue;
    const double share = at_p / (at_p - at_q);
    result.push_back({p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)});
  }
  return result;
}

ImagePolygon rounded(const Polygon& polygon) {
  ImagePolygon result;
  for (const Point2& p : polygon) {
    const ImagePoint on_grid{std::llround(p.x), std::llround(p.y)};
    if (result.empty() || result.back() != on_grid) result.push_back(on_grid);
  }
  while (result.size() > 1 && result.front() == result.back()) result.pop_back();
  return result.size() < 3 ? ImagePolygon{} : result;
}

// Returns whether a polygon has more than a border in common with the triangle and its domain.
bool enters(const RightTriangle& triangle, const std::vector<CornerValues>& domain, Polygon polygon) {
  for (const CornerValues& inside : {CornerValues{1, 0, 0}, CornerValues{0, 1, 0}, CornerValues{0, 0, 1}})
    polygon = clipped(polygon, LinearFunction(triangle, inside));
  for (const auto& [corner, along_x, along_y] : domain)
    polygon = clipped(polygon, LinearFunction(triangle, {corner - 1, along_x - 1, along_y - 1}));
  return polygon.size() > 2;
}

bool is_finite(double value) { return std::isfinite(value); }
bool is_negative(double value) { return value < 0; }

}  // namespace

LinearPart linear_part(const RightTriangle& triangle, const std::vector<CornerValues>& functions,
                       const std::vector<CornerValues>& domain, int grid_bits) {
  LinearPart part{{}, true};
  Polygon polygon = surroundings(triangle, grid_bits);
  for (const CornerValues& values : functions) {
    if (!std::ranges::all_of(values, is_finite) || std::ranges::all_of(values, is_negative)) return {};
    if (std::ranges::none_of(values, is_negative)) continue;
    part.is_whole = false;
    polygon = clipped(polygon, LinearFunction(triangle, values));
  }
  if (enters(triangle, domain, polygon)) part.polygon = rounded(polygon);
  return part;
}

}  // namespace sightline::inline reflect
