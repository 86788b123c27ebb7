#include "sweep/unrounded/unrounded_sweep.h"

#include <algorithm>

#include "sweep/plain/sweep_loop.h"
#include "sweep/unrounded/swaps.h"

namespace sightline::inline sweep {

namespace {

// Returns, per edge of the scene and then per swap edge, whether the result names it.
std::vector<std::uint8_t> named_edges(const VisibleSegments& segments, std::size_t edges) {
  std::vector<std::uint8_t> named(edges, 0);
  for (const Crossing& c : segments.crossings) named[c.a.index()] = named[c.b.index()] = 1;
  for (const VisibleSegment& s : segments.segments) named[s.edge.index()] = 1;
  return named;
}

// Keeps the swap edges that the result names, by their surfaces: the order in which they were found says nothing.
void arrange_swap_edges(std::vector<SwapEdge> found, std::size_t scene_edges, VisibleSegments& segments) {
  const std::vector<std::uint8_t> named = named_edges(segments, scene_edges + found.size());
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (named[scene_edges + i] != 0) order.push_back(i);
  }
  std::ranges::sort(order, {}, [&](std::size_t i) { return found[i].surfaces; });
  std::vector<EdgeId> name(found.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    name[order[i]] = EdgeId(scene_edges + i);
    segments.swap_edges.push_back(found[order[i]]);
  }
  const auto rename = [&](EdgeId& e) {
    if (e.index() >= scene_edges) e = name[e.index() - scene_edges];
  };
  for (Crossing& c : segments.crossings) {
    rename(c.a);
    rename(c.b);
  }
  for (VisibleSegment& s : segments.segments) rename(s.edge);
}

}  // namespace

VisibleSegments unrounded_sweep(const ProjectedScene& scene, std::span<const DepthRange> depths,
                                SweepObserver* observer, UnroundedCounts* counts) {
  const UnroundedDecider decider(scene);
  VisibleSegments segments = Sweep(scene, decider, depths, observer).run();
  arrange_swap_edges(decider.swap_edges(), scene.edge_count(), segments);
  if (counts != nullptr) *counts = decider.counts();
  return segments;
}

}  // namespace sightline::inline sweep
