#include "tests/oracle/facet_crossing.h"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>

namespace sightline::oracle {
namespace {

using boost::multiprecision::cpp_rational;
using RationalPoint = std::array<cpp_rational, 3>;
using Polygon = std::vector<RationalPoint>;

Polygon polygon_of(const Mesh& mesh, FacetId facet) {
  Polygon result;
  for (const VertexId v : mesh.corners(facet)) {
    const Point3& p = mesh.position(v);
    result.push_back({cpp_rational(p.x), cpp_rational(p.y), cpp_rational(p.z)});
  }
  return result;
}

RationalPoint minus(const RationalPoint& p, const RationalPoint& q) { return {p[0] - q[0], p[1] - q[1], p[2] - q[2]}; }

// Newell's normal: no three corners need be picked.
RationalPoint normal(const Polygon& polygon) {
  RationalPoint n{0, 0, 0};
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const RationalPoint u = minus(polygon[i], polygon[0]);
    const RationalPoint v = minus(polygon[(i + 1) % polygon.size()], polygon[0]);
    n[0] += u[1] * v[2] - u[2] * v[1];
    n[1] += u[2] * v[0] - u[0] * v[2];
    n[2] += u[0] * v[1] - u[1] * v[0];
  }
  return n;
}

std::vector<cpp_rational> heights_over(const Polygon& polygon, const Polygon& plane) {
  const RationalPoint n = normal(plane);
  std::vector<cpp_rational> result;
  for (const RationalPoint& p : polygon) {
    const RationalPoint u = minus(p, plane[0]);
    result.push_back(n[0] * u[0] + n[1] * u[1] + n[2] * u[2]);
  }
  return result;
}

bool reaches_to_both_sides(const std::vector<cpp_rational>& heights) {
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  return *low < 0 && *high > 0;
}

// Where the polygon's border meets the plane.
std::vector<RationalPoint> trace(const Polygon& polygon, const std::vector<cpp_rational>& heights) {
  std::vector<RationalPoint> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t j = (i + 1) % polygon.size();
    if (heights[i] == 0) result.push_back(polygon[i]);
    if (heights[i].sign() * heights[j].sign() >= 0) continue;
    const cpp_rational t = heights[i] / (heights[i] - heights[j]);
    const RationalPoint along = minus(polygon[j], polygon[i]);
    result.push_back({polygon[i][0] + t * along[0], polygon[i][1] + t * along[1], polygon[i][2] + t * along[2]});
  }
  return result;
}

// Both lie on one line; whether they share more than a point of it: points of a line are in lexicographic order along
// it.
bool overlap(const std::vector<RationalPoint>& a, const std::vector<RationalPoint>& b) {
  const auto [a_low, a_high] = std::minmax_element(a.begin(), a.end());
  const auto [b_low, b_high] = std::minmax_element(b.begin(), b.end());
  return std::max(*a_low, *b_low) < std::min(*a_high, *b_high);
}

}  // namespace

bool facets_cross(const Mesh& mesh, FacetId a, FacetId b) {
  const Polygon p = polygon_of(mesh, a);
  const Polygon q = polygon_of(mesh, b);
  const auto p_heights = heights_over(p, q);
  const auto q_heights = heights_over(q, p);
  if (!reaches_to_both_sides(p_heights) || !reaches_to_both_sides(q_heights)) return false;
  return overlap(trace(p, p_heights), trace(q, q_heights));
}

}  // namespace sightline::oracle
