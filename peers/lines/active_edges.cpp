#include "peers/lines/active_edges.h"

#include <algorithm>
#include <optional>

namespace sightline::peers {
namespace {

Point2 place(const LineEnd& end) { return {end.place.x, end.place.y}; }

bool extents_meet(const SceneLine& a, const SceneLine& b) {
  const auto meet = [](double a1, double a2, double b1, double b2) {
    return std::min(a1, a2) <= std::max(b1, b2) && std::min(b1, b2) <= std::max(a1, a2);
  };
  return meet(a.from.place.x, a.to.place.x, b.from.place.x, b.to.place.x) &&
         meet(a.from.place.y, a.to.place.y, b.from.place.y, b.to.place.y);
}

bool share_vertex(const SceneLine& a, const SceneLine& b) {
  const auto same = [](const LineEnd& p, const LineEnd& q) { return p.vertex.valid() && p.vertex == q.vertex; };
  return same(a.from, b.from) || same(a.from, b.to) || same(a.to, b.from) || same(a.to, b.to);
}

// Returns twice the area of a, b, p.
double height(const LineEnd& a, const LineEnd& b, const LineEnd& p) {
  return (b.place.x - a.place.x) * (p.place.y - a.place.y) - (b.place.y - a.place.y) * (p.place.x - a.place.x);
}

// Returns where the line meets the edge's line, which its ends are on different sides of.
double parameter(const SceneLine& line, const SceneLine& edge) {
  const double from = height(edge.from, edge.to, line.from);
  const double to = height(edge.from, edge.to, line.to);
  return from == to ? 0.5 : std::clamp(from / (from - to), 0.0, 1.0);
}

std::optional<ActiveCrossing> crossing_of(const SceneLine& line, const SceneLine& edge) {
  const Sign from_side = side_of_moved_point(place(edge.from), place(edge.to), place(line.from));
  const Sign to_side = side_of_moved_point(place(edge.from), place(edge.to), place(line.to));
  if (from_side == to_side) return std::nullopt;
  if (side_of_moved_line(place(line.from), place(line.to), place(edge.from)) ==
      side_of_moved_line(place(line.from), place(line.to), place(edge.to))) {
    return std::nullopt;
  }
  const double t = parameter(line, edge);
  const bool is_in_view_triangle = edge.at(parameter(edge, line)).depth < line.at(t).depth;
  if (!is_in_view_triangle) return std::nullopt;
  return ActiveCrossing{t, to_side * edge.winding};  // to the left: behind the polygons on the left
}

}  // namespace

ActiveEdges::ActiveEdges(std::span<const SceneLine> lines) {
  for (const SceneLine& line : lines) {
    if (line.winding != 0) edges_.push_back(&line);
  }
}

std::vector<ActiveCrossing> ActiveEdges::crossings_of(const SceneLine& line) const {
  std::vector<ActiveCrossing> crossings;
  for (const SceneLine* edge : edges_) {
    if (!extents_meet(line, *edge) || edge->edge == line.edge || share_vertex(line, *edge)) continue;
    if (const auto crossing = crossing_of(line, *edge)) crossings.push_back(*crossing);
  }
  std::stable_sort(crossings.begin(), crossings.end(),
                   [](const ActiveCrossing& a, const ActiveCrossing& b) { return a.t < b.t; });
  return crossings;
}

}  // namespace sightline::peers
