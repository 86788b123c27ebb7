#include "sweep/bands/joined_crossings.h"

#include <tbb/parallel_sort.h>

#include <algorithm>

#include "geometry/numbers/parallel.h"
#include "sweep/segments/crossing_point.h"

namespace sightline::inline sweep {
namespace {

struct Placed {
  Crossing crossing;
  CrossingPoint place;
};

std::vector<Placed> in_sweep_order(const ProjectedScene& scene, const std::vector<Crossing>& crossings) {
  std::vector<Placed> all(crossings.size());
  parallel_for_each(all.size(), [&](std::size_t i) {
    all[i] = {crossings[i], crossing_point(scene, crossings[i].a, crossings[i].b)};
  });
  tbb::parallel_sort(all.begin(), all.end(), [](const Placed& x, const Placed& y) {
    if (x.crossing.after != y.crossing.after) return x.crossing.after < y.crossing.after;
    return sweep_compare(x.place, y.place) < 0;
  });
  return all;
}

}  // namespace

JoinedCrossings::JoinedCrossings(const ProjectedScene& scene, const std::vector<Crossing>& crossings)
    : vertices_(scene.points.size()) {
  for (const Placed& p : in_sweep_order(scene, crossings)) {
    if (!crossings_.empty() && key_of(crossings_.back()) == key_of(p.crossing)) continue;
    index_.emplace_back(key_of(p.crossing), crossings_.size());
    crossings_.push_back(p.crossing);
  }
  tbb::parallel_sort(index_.begin(), index_.end());
}

PointId JoinedCrossings::name(const Crossing& crossing) const {
  const auto found = std::ranges::lower_bound(index_, key_of(crossing), {}, &std::pair<Key, std::size_t>::first);
  return PointId(vertices_ + found->second);
}

}  // namespace sightline::inline sweep
