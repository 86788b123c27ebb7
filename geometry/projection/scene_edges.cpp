#include "geometry/projection/scene_edges.h"

#include <algorithm>

#include "geometry/numbers/grouping.h"
#include "geometry/numbers/parallel.h"
#include "geometry/numbers/sort_few.h"

namespace sightline::inline geometry {
namespace {

// A side of a facet is the edge after one of its corners.
struct PlacedSide {
  PointId bottom;
  std::uint32_t corner = 0;
  FacetId facet;
};

constexpr auto by_bottom = [](const PlacedSide& a, const PlacedSide& b) {
  return a.bottom != b.bottom ? a.bottom < b.bottom : a.corner < b.corner;
};

// Calls visit(top, side).
template <class Visit>
void for_each_side(const ProjectedScene& scene, const Visit& visit) {
  parallel_for_each(scene.status.size(), [&](std::size_t f) {
    const std::uint32_t first = scene.polygon_begin[f];
    const auto polygon = scene.polygon(FacetId(f));
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const PointId from = polygon[i].point;
      const PointId to = polygon[i + 1 == polygon.size() ? 0 : i + 1].point;
      if (from == to) continue;
      visit(std::min(from, to).index(),
            PlacedSide{std::max(from, to), static_cast<std::uint32_t>(first + i), FacetId(f)});
    }
  });
}

// Adds the sides of one top; `first` is the number of the first of these. The boundary of a facet that is
// counter-clockwise in the image runs down its left border: there the winding grows from left to right.
void add_sides(PointId top, std::span<const PlacedSide> placed, std::size_t first, std::vector<SceneEdge>& edges,
               ProjectedScene& scene) {
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const PlacedSide& side = placed[i];
    if (i == 0 || placed[i - 1].bottom != side.bottom)
      edges.push_back({top, side.bottom, static_cast<std::uint32_t>(first + i)});
    const ClippedCorner& corner = scene.polygon_corners[side.corner];
    scene.sides[first + i] = {side.facet, corner.point == top ? 1 : -1, corner.edge_after};
  }
}

// One more edge, after all of them, only ends the sides.
void put_together(std::vector<std::vector<SceneEdge>>& parts, ProjectedScene& scene) {
  std::size_t count = 1;
  for (const auto& part : parts) count += part.size();
  scene.edges.reserve(count);
  for (auto& part : parts) {
    scene.edges.insert(scene.edges.end(), part.begin(), part.end());
    part = {};
  }
  scene.edges.push_back({PointId{}, PointId{}, static_cast<std::uint32_t>(scene.sides.size())});
}

}  // namespace

void collect_edges(ProjectedScene& scene) {
  Grouping<PlacedSide> placed(scene.points.size(), [&](const auto& visit) { for_each_side(scene, visit); });
  scene.sides.resize(placed.item_count());
  std::vector<std::vector<SceneEdge>> edges(range_count(scene.points.size()));
  parallel_for_ranges(scene.points.size(), [&](std::size_t range, std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      sort_few(placed.of(p), by_bottom);
      add_sides(PointId(p), placed.of(p), placed.items_before(p), edges[range], scene);
    }
  });
  put_together(edges, scene);
}

}  // namespace sightline::inline geometry
