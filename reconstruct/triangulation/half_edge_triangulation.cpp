#include "reconstruct/triangulation/half_edge_triangulation.h"

namespace sightline::inline reconstruct {

namespace {

void flood(const HalfEdgeTriangulation& triangulation, TriangleId seed, RegionId region,
           std::vector<RegionId>& of_triangle) {
  std::vector<TriangleId> front{seed};
  of_triangle[seed.index()] = region;
  while (!front.empty()) {
    const TriangleId t = front.back();
    front.pop_back();
    for (std::size_t side = 0; side < 3; ++side) {
      const TriangleId other = triangulation.neighbour(t, side);
      if (!other.valid() || triangulation.is_constrained(half_edge(t, side))) continue;
      if (of_triangle[other.index()].valid()) continue;
      of_triangle[other.index()] = region;
      front.push_back(other);
    }
  }
}

}  // namespace

Regions flood_regions(const HalfEdgeTriangulation& triangulation) {
  Regions regions{std::vector<RegionId>(triangulation.triangle_count()), 0};
  for (std::size_t t = 0; t < triangulation.triangle_count(); ++t) {
    if (regions.of_triangle[t].valid()) continue;
    flood(triangulation, TriangleId(t), RegionId(regions.count++), regions.of_triangle);
  }
  return regions;
}

}  // namespace sightline::inline reconstruct
