#include <algorithm>
#include <utility>

#include "bench/rivals/rivals.h"
#include "bench/scenes/scene_parts.h"
#include "cli/system/resources.h"

namespace sightline::bench {
using namespace cli;

double seconds_to_sort(std::vector<ImagePoint> points) {
  Random random(points.size());
  for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1], points[random.below(i)]);
  const ProcessorTime watch;
  std::sort(points.begin(), points.end(), sweeps_before);
  return watch.seconds();
}

}  // namespace sightline::bench
