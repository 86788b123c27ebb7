#include "geometry/mesh/mesh_topology.h"

#include <algorithm>
#include <numeric>

#include "geometry/faces/face_shape.h"

namespace sightline::inline geometry {

namespace {

// The indices of `keys` are grouped by key: those with key k are order[begin[k]] .. order[begin[k + 1] - 1], ascending.
struct Groups {
  std::vector<std::uint32_t> begin;
  std::vector<std::uint32_t> order;

  [[nodiscard]] std::span<std::uint32_t> operator[](std::size_t key) {
    return std::span(order).subspan(begin[key], begin[key + 1] - begin[key]);
  }
};

Groups group_by(std::span<const std::uint32_t> keys, std::size_t key_count) {
  Groups groups{std::vector<std::uint32_t>(key_count + 1), std::vector<std::uint32_t>(keys.size())};
  for (const std::uint32_t key : keys) ++groups.begin[key + 1];
  std::partial_sum(groups.begin.begin(), groups.begin.end(), groups.begin.begin());
  std::vector<std::uint32_t> end(groups.begin.begin(), groups.begin.end() - 1);
  for (std::uint32_t i = 0; i < keys.size(); ++i) groups.order[end[keys[i]]++] = i;
  return groups;
}

using Cycle = std::vector<std::uint32_t>;

Cycle rotated(std::span<const std::uint32_t> cycle, std::size_t start) {
  Cycle result(cycle.begin(), cycle.end());
  std::rotate(result.begin(), result.begin() + static_cast<std::ptrdiff_t>(start), result.end());
  return result;
}

// Returns the lexicographically smallest reading of a cycle, from any start.
Cycle canonical(std::span<const std::uint32_t> cycle) {
  Cycle best(cycle.begin(), cycle.end());
  const std::uint32_t smallest = std::ranges::min(cycle);
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    if (cycle[i] == smallest) best = std::min(best, rotated(cycle, i));
  }
  return best;
}

// Returns the canonical cycles of all polygons, one after the other: that of polygon i starts where the polygon starts.
Cycle canonical_cycles(const PolygonList& polygons, const Welding& welding) {
  Cycle cycles;
  Cycle ranks;
  cycles.reserve(polygons.corners.size());
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    ranks.clear();
    for (const VertexId v : polygons[i]) ranks.push_back(welding.rank[v.index()]);
    if (ranks.size() == 3) {
      std::rotate(ranks.begin(), std::ranges::min_element(ranks), ranks.end());
    } else if (!ranks.empty()) {
      ranks = canonical(ranks);
    }
    cycles.insert(cycles.end(), ranks.begin(), ranks.end());
  }
  return cycles;
}

// Each corner has the ranks of the ends of the edge to the next corner.
struct HalfEdges {
  std::vector<std::uint32_t> low;
  std::vector<std::uint32_t> high;
};

HalfEdges half_edges(const PolygonList& facets, const Welding& welding) {
  HalfEdges result;
  result.low.reserve(facets.corners.size());
  result.high.reserve(facets.corners.size());
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const auto corners = facets[f];
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::uint32_t start = welding.rank[corners[i].index()];
      const std::uint32_t end = welding.rank[corners[i + 1 == corners.size() ? 0 : i + 1].index()];
      result.low.push_back(std::min(start, end));
      result.high.push_back(std::max(start, end));
    }
  }
  return result;
}

}  // namespace

Welding weld_vertices(std::span<const Point3> vertices) {
  struct Entry {
    Point3 position = Point3::Zero();
    VertexId vertex;
  };
  std::vector<Entry> sorted;
  sorted.reserve(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) sorted.push_back({vertices[i], VertexId(i)});
  std::ranges::sort(sorted, [](const Entry& a, const Entry& b) {
    return a.position == b.position ? a.vertex < b.vertex : lexicographically_less(a.position, b.position);
  });
  Welding welding{std::vector<VertexId>(vertices.size()), std::vector<std::uint32_t>(vertices.size()), {}};
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (i == 0 || sorted[i].position != sorted[i - 1].position) welding.by_rank.push_back(sorted[i].vertex);
    welding.weld[sorted[i].vertex.index()] = welding.by_rank.back();
    welding.rank[sorted[i].vertex.index()] = static_cast<std::uint32_t>(welding.by_rank.size() - 1);
  }
  return welding;
}

std::vector<bool> find_repeated(const PolygonList& polygons, const Welding& welding) {
  const Cycle cycles = canonical_cycles(polygons, welding);
  const auto cycle = [&](std::uint32_t i) { return std::span(cycles).subspan(polygons.begin[i], polygons[i].size()); };
  const auto nobody = static_cast<std::uint32_t>(welding.by_rank.size());
  std::vector<std::uint32_t> first(polygons.size(), nobody);
  for (std::uint32_t i = 0; i < polygons.size(); ++i) {
    if (!polygons[i].empty()) first[i] = cycle(i).front();
  }
  Groups groups = group_by(first, nobody + std::size_t{1});
  std::vector<bool> repeated(polygons.size());
  for (std::uint32_t key = 0; key < nobody; ++key) {
    const auto group = groups[key];
    std::ranges::stable_sort(group,
                             [&](auto a, auto b) { return std::ranges::lexicographical_compare(cycle(a), cycle(b)); });
    for (std::size_t i = 1; i < group.size(); ++i)
      repeated[group[i]] = std::ranges::equal(cycle(group[i]), cycle(group[i - 1]));
  }
  return repeated;
}

MeshEdges make_mesh_edges(const PolygonList& facets, const Welding& welding) {
  const HalfEdges half = half_edges(facets, welding);
  Groups groups = group_by(half.low, welding.by_rank.size());
  MeshEdges edges{{}, std::vector<MeshEdgeId>(half.low.size())};
  for (std::size_t low = 0; low < welding.by_rank.size(); ++low) {
    const auto group = groups[low];
    std::ranges::sort(group, {}, [&](std::uint32_t corner) { return half.high[corner]; });
    for (std::size_t i = 0; i < group.size(); ++i) {
      const std::uint32_t high = half.high[group[i]];
      if (i == 0 || high != half.high[group[i - 1]])
        edges.ends.push_back({welding.by_rank[low], welding.by_rank[high]});
      edges.of_corner[group[i]] = MeshEdgeId(edges.ends.size() - 1);
    }
  }
  return edges;
}

}  // namespace sightline::inline geometry
