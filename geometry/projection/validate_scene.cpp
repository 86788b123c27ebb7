#include <algorithm>
#include <array>
#include <utility>

#include "geometry/numbers/id_names.h"
#include "geometry/projection/certain_height.h"
#include "geometry/projection/projected_scene.h"
#include "geometry/projection/unrounded_points.h"

namespace sightline::inline geometry {
namespace {

using Messages = std::vector<std::string>;

// Returns whether begin[i] .. begin[i + 1] are the ranges of `count` lists that together are `total` elements.
bool are_ranges(std::span<const std::uint32_t> begin, std::size_t count, std::size_t total) {
  return begin.size() == count + 1 && begin.front() == 0 && std::ranges::is_sorted(begin) && begin.back() == total;
}

// Sizes and ranges come first: the other checks need them in order to look at anything.
Messages check_arrays(const ProjectedScene& scene) {
  Messages messages;
  const auto require = [&](bool holds, const char* what) {
    if (!holds) messages.emplace_back(what);
  };
  const std::size_t facets = scene.status.size();
  std::vector<std::uint32_t> first_sides;
  for (const SceneEdge& e : scene.edges) first_sides.push_back(e.first_side);
  const auto is_point = [&](PointId p) { return p.index() < scene.points.size(); };
  const auto ends_are_points = [&](const SceneEdge& e) { return is_point(e.top) && is_point(e.bottom); };
  require(scene.grid_bits >= 0 && scene.grid_bits <= default_grid_bits, "grid_bits: more than the predicates can hold");
  require(!scene.is_unrounded() || (scene.unrounded.places.size() == scene.points.size() &&
                                    scene.unrounded.sources.size() == scene.points.size()),
          "unrounded: not one place and source per point");
  require(scene.facing.size() == facets, "facing: not one entry per facet");
  require(are_ranges(scene.polygon_begin, facets, scene.polygon_corners.size()),
          "polygon_begin: not the ranges of one polygon per facet");
  require(!scene.edges.empty() && are_ranges(first_sides, scene.edge_count(), scene.sides.size()),
          "edges: not the ranges of the sides, with one more entry at the end");
  require(std::ranges::all_of(scene.edges.begin(),
                              scene.edges.begin() + static_cast<std::ptrdiff_t>(scene.edge_count()), ends_are_points),
          "edges: an end is no point");
  require(std::ranges::all_of(scene.sides, [&](const EdgeSide& side) { return side.facet.index() < facets; }),
          "sides: no such facet");
  require(std::ranges::all_of(scene.polygon_corners, [&](const ClippedCorner& c) { return is_point(c.point); }),
          "polygon_corners: no such point");
  const auto is_made = [&](const ClippedCorner& c) {
    return c.made.index() < scene.made_corners.size() && &scene.polygon_corners[scene.made(c).corner] == &c;
  };
  require(std::ranges::all_of(scene.polygon_corners,
                              [&](const ClippedCorner& c) { return c.vertex.valid() ? !c.made.valid() : is_made(c); }),
          "polygon_corners: neither a vertex nor made by clipping, or both");
  require(std::ranges::all_of(scene.facing, [](FacetFacing f) { return f <= FacetFacing::edge_on; }),
          "facing: no such value");
  require(std::ranges::all_of(scene.status, [](FacetStatus s) { return s <= FacetStatus::culled; }),
          "status: no such value");
  return messages;
}

// Returns whether b is swept after a.
bool follows(const ProjectedScene& scene, PointId a, PointId b) {
  if (!scene.is_unrounded()) return sweeps_before(scene.point(a), scene.point(b));
  const auto height = [&](PointId p) { return height_of(scene.unrounded.places[p.index()]); };
  return compare_heights(height(a), height(b)) < 0 || sweep_compare(exact_place(scene, a), exact_place(scene, b)) < 0;
}

void check_points(const ProjectedScene& scene, Messages& messages) {
  const std::int64_t half_window = std::int64_t{1} << scene.grid_bits;
  const auto in_window = [&](std::int64_t x) { return -half_window <= x && x <= half_window; };
  for (std::size_t p = 0; p < scene.points.size(); ++p) {
    const ImagePoint& point = scene.points[p];
    if (!in_window(point.x) || !in_window(point.y)) messages.push_back(name(PointId(p)) + " is outside the window");
    if (p > 0 && !follows(scene, PointId(p - 1), PointId(p)))
      messages.push_back(name(PointId(p)) + " does not follow the one before it in sweep order");
  }
}

void check_edges(const ProjectedScene& scene, Messages& messages) {
  for (std::size_t e = 0; e < scene.edge_count(); ++e) {
    const SceneEdge& edge = scene.edges[e];
    if (!(edge.top < edge.bottom)) messages.push_back(name(EdgeId(e)) + " has its top not before its bottom");
    if (e > 0 && std::pair(scene.edges[e - 1].top, scene.edges[e - 1].bottom) >= std::pair(edge.top, edge.bottom))
      messages.push_back(name(EdgeId(e)) + " is repeated or out of order");
    if (scene.sides_of(EdgeId(e)).empty() && !scene.has_mirrored_lines)
      messages.push_back(name(EdgeId(e)) + " belongs to no facet");
    for (const EdgeSide& side : scene.sides_of(EdgeId(e))) {
      if (side.winding == 0) messages.push_back(name(EdgeId(e)) + " changes nothing for " + name(side.facet));
      if (scene.status[side.facet.index()] != FacetStatus::in_view)
        messages.push_back(name(EdgeId(e)) + " has a side of " + name(side.facet) + ", which is not in view");
    }
  }
}

// Calls report(key) for every key whose amounts do not add up to zero. It takes O(n log n).
template <class Key, class Report>
void for_each_imbalance(std::vector<std::pair<Key, std::int64_t>>& amounts, Report report) {
  std::ranges::sort(amounts);
  for (std::size_t begin = 0; begin < amounts.size();) {
    const Key& key = amounts[begin].first;
    std::int64_t sum = 0;
    std::size_t end = begin;
    for (; end < amounts.size() && amounts[end].first == key; ++end) sum += amounts[end].second;
    if (sum != 0) report(key);
    begin = end;
  }
}

void check_closed(const ProjectedScene& scene, Messages& messages) {
  std::vector<std::pair<std::pair<FacetId, PointId>, std::int64_t>> windings;
  windings.reserve(2 * scene.sides.size());
  for (std::size_t e = 0; e < scene.edge_count(); ++e) {
    for (const EdgeSide& side : scene.sides_of(EdgeId(e))) {
      windings.push_back({{side.facet, scene.edges[e].top}, side.winding});
      windings.push_back({{side.facet, scene.edges[e].bottom}, -std::int64_t{side.winding}});
    }
  }
  for_each_imbalance(windings, [&](const auto& key) {
    messages.push_back(name(key.first) + " has a boundary that is not closed at " + name(key.second));
  });
}

struct SideKey {
  FacetId facet;
  PointId top;
  PointId bottom;
  MeshEdgeId mesh_edge;
  friend auto operator<=>(const SideKey&, const SideKey&) = default;
};

// The sides of a facet are its polygon's: the boundary of a polygon runs down where its winding number grows.
void check_sides_against_polygons(const ProjectedScene& scene, Messages& messages) {
  std::vector<std::pair<SideKey, std::int64_t>> windings;
  windings.reserve(scene.sides.size() + scene.polygon_corners.size());
  for (std::size_t e = 0; e < scene.edge_count(); ++e) {
    const SceneEdge& edge = scene.edges[e];
    for (const EdgeSide& side : scene.sides_of(EdgeId(e)))
      windings.push_back({{side.facet, edge.top, edge.bottom, side.mesh_edge}, side.winding});
  }
  for (std::size_t f = 0; f < scene.status.size(); ++f) {
    const auto polygon = scene.polygon(FacetId(f));
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const PointId from = polygon[i].point;
      const PointId to = polygon[i + 1 == polygon.size() ? 0 : i + 1].point;
      if (from < to) windings.push_back({{FacetId(f), from, to, polygon[i].edge_after}, -1});
      if (to < from) windings.push_back({{FacetId(f), to, from, polygon[i].edge_after}, 1});
    }
  }
  for_each_imbalance(windings, [&](const SideKey& key) {
    messages.push_back(name(key.facet) + " has other sides than its polygon from " + name(key.top) + " to " +
                       name(key.bottom));
  });
}

void check_status(const ProjectedScene& scene, Messages& messages) {
  for (std::size_t i = 0; i < scene.status.size(); ++i) {
    const FacetId f(i);
    const FacetStatus status = scene.status[i];
    const std::size_t corners = scene.polygon(f).size();
    const bool culled = scene.facing[i] == FacetFacing::back && scene.sides_shown == Sides::front;
    if ((status == FacetStatus::edge_on) != (scene.facing[i] == FacetFacing::edge_on) ||
        (status == FacetStatus::culled) != culled)
      messages.push_back(name(f) + " has a status that does not fit the way it faces");
    if (status == FacetStatus::in_view && corners < 3) messages.push_back(name(f) + " is in view and has no polygon");
    if (status != FacetStatus::in_view && corners > 0)
      messages.push_back(name(f) + " is not in view and has a polygon");
  }
}

}  // namespace

std::vector<std::string> validate(const ProjectedScene& scene) {
  Messages messages = check_arrays(scene);
  if (!messages.empty()) return messages;
  check_points(scene, messages);
  check_edges(scene, messages);
  check_closed(scene, messages);
  check_sides_against_polygons(scene, messages);
  check_status(scene, messages);
  return messages;
}

}  // namespace sightline::inline geometry
