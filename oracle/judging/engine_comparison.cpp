#include "oracle/judging/engine_comparison.h"

#include <algorithm>
#include <tuple>
#include <vector>

namespace sightline::lattice {
namespace {

auto as_tuple(const Crossing& c) { return std::tuple(c.a, c.b, c.after); }
auto as_tuple(const VisibleSegment& s) { return std::tuple(s.start, s.end, s.facet, s.other, s.edge); }
auto as_tuple(const SwapEdge& e) { return std::tuple(e.surfaces, e.first_nearer); }
auto as_tuple(const Thread& t) { return std::tuple(t.top, t.facet, t.segment); }

// Returns where two lists begin to differ; empty where they do not.
template <class Item>
std::string difference(const char* what, const std::vector<Item>& a, const std::vector<Item>& b) {
  const auto [x, y] = std::mismatch(a.begin(), a.end(), b.begin(), b.end(),
                                    [](const Item& p, const Item& q) { return as_tuple(p) == as_tuple(q); });
  if (x == a.end() && y == b.end()) return "";
  return std::string(what) + " differ from number " + std::to_string(x - a.begin()) + " on; ";
}

std::string difference(const VisibleSegments& fast, const VisibleSegments& full) {
  return difference("crossings", fast.crossings, full.crossings) +
         difference("segments", fast.segments, full.segments) + difference("threads", fast.threads, full.threads) +
         difference("swap edges", fast.swap_edges, full.swap_edges) +
         (fast.splits == full.splits ? "" : "splits differ");
}

}  // namespace

std::string engine_differences(const ProjectedScene& scene, std::initializer_list<FastOptions> all,
                               EngineTally& tally) {
  const VisibleSegments full = find_visible_segments(scene, Engine::full);
  std::string found = difference(find_visible_segments(scene, Engine::fast), full);
  for (const FastOptions& options : all) {
    const VisibleSegments fast = fast_visible_segments(scene, options);
    if (options.bands == 1) tally.points += full.statistics.sweep_points;
    if (options.bands == 1) tally.swept += fast.statistics.sweep_points;
    const std::string here = difference(fast, full);
    if (!here.empty())
      found += "level " + std::to_string(*options.level) + ", " + std::to_string(*options.bands) + " bands: " + here;
  }
  return found;
}

}  // namespace sightline::lattice
