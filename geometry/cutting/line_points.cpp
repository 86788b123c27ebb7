#include "geometry/cutting/line_points.h"

#include <algorithm>

namespace sightline::inline geometry {
namespace {

// Returns the numbers as integers without a common factor, of which the first that is not zero is positive.
template <std::size_t N>
std::array<BigInteger, N> in_lowest_terms(std::array<BigInteger, N> numbers) {
  BigInteger divisor = 0;
  for (const BigInteger& number : numbers) divisor = gcd(divisor, number);
  const auto first = std::ranges::find_if(numbers, [](const BigInteger& number) { return number != 0; });
  if (first != numbers.end() && *first < 0) divisor = -divisor;
  for (BigInteger& number : numbers) number /= divisor;
  return numbers;
}

}  // namespace

// A line is named by its direction and its moment.
LinePoints::Plucker LinePoints::line_through(VertexId from, VertexId to) const {
  const ExactPosition p = exact_position(mesh_, from);
  const ExactPosition q = exact_position(mesh_, to);
  const ExactVector direction = p.w * q.xyz - q.w * p.xyz;
  const ExactVector moment = cross(p.xyz, q.xyz);
  return in_lowest_terms(Plucker{direction.x(), direction.y(), direction.z(), moment.x(), moment.y(), moment.z()});
}

void LinePoints::add(MeshEdgeId edge, VertexId from, VertexId to) {
  auto& points = edge.valid() ? on_mesh_edge_[edge] : on_common_line_[line_through(from, to)];
  points.insert(points.end(), {from, to});
}

void LinePoints::sort(std::span<const std::uint32_t> rank) {
  const auto sort_line = [&](std::vector<VertexId>& points) {
    std::ranges::sort(points, [&](VertexId a, VertexId b) {
      return rank[a.index()] != rank[b.index()] ? rank[a.index()] < rank[b.index()] : a < b;
    });
    const auto same = [&](VertexId a, VertexId b) { return rank[a.index()] == rank[b.index()]; };
    points.erase(std::unique(points.begin(), points.end(), same), points.end());
  };
  for (auto& [edge, points] : on_mesh_edge_) sort_line(points);
  for (auto& [line, points] : on_common_line_) sort_line(points);
}

const std::vector<VertexId>* LinePoints::find(MeshEdgeId edge, VertexId from, VertexId to) const {
  if (!edge.valid()) return &on_common_line_.at(line_through(from, to));
  const auto found = on_mesh_edge_.find(edge);
  return found == on_mesh_edge_.end() ? nullptr : &found->second;
}

std::vector<VertexId> LinePoints::between(MeshEdgeId edge, VertexId from, VertexId to,
                                          std::span<const std::uint32_t> rank) const {
  const std::vector<VertexId>* points = find(edge, from, to);
  if (points == nullptr) return {};
  const auto rank_of = [&](VertexId v) { return rank[v.index()]; };
  const std::uint32_t low = std::min(rank_of(from), rank_of(to));
  const std::uint32_t high = std::max(rank_of(from), rank_of(to));
  std::vector<VertexId> inside(std::ranges::upper_bound(*points, low, {}, rank_of),
                               std::ranges::lower_bound(*points, high, {}, rank_of));
  if (rank_of(from) == high) std::ranges::reverse(inside);
  return inside;
}

}  // namespace sightline::inline geometry
