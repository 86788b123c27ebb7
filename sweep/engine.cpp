#include "sweep/engine.h"

#include <algorithm>
#include <array>
#include <optional>

#include "sweep/covers.h"
#include "sweep/facet_outline.h"
#include "sweep/joined_segments.h"
#include "sweep/large_covers.h"
#include "sweep/patches.h"
#include "sweep/scene_part.h"

namespace sightline {
namespace {

// Cells are as fine as so many pairs of a facet and a cell in its bounding box allow, per facet: contour edges then touch
// few of them, and looking at all pairs still costs little.
constexpr int highest_level = 11;
constexpr double pairs_per_facet = 10;
constexpr std::size_t most_samples = 1 << 16;

int level_for(const ProjectedScene& scene) {
  std::array<double, highest_level + 1> pairs{};
  double facets = 0;
  for (std::size_t f = 0; f < scene.status.size(); f += 1 + scene.status.size() / most_samples) {
    if (scene.status[f] != Status::in_view) continue;
    const CellRange range = CellGrid(scene.grid_bits, highest_level).range_of(FacetOutline(scene, FacetId(f)).points());
    for (int level = 0; level <= highest_level; ++level) {
      const int shift = highest_level - level;
      pairs[static_cast<std::size_t>(level)] +=
          static_cast<double>((range.right >> shift) - (range.left >> shift) + 1) *
          static_cast<double>((range.top >> shift) - (range.bottom >> shift) + 1);
    }
    ++facets;
  }
  int level = highest_level;
  while (level > 0 && pairs[static_cast<std::size_t>(level)] > pairs_per_facet * facets) --level;
  return level;
}

// Tells an observer of the sweep of a part where it is in the whole.
class WholeObserver : public SweepObserver {
 public:
  WholeObserver(const ProjectedScene& whole, const ScenePart& part, SweepObserver& observer)
      : whole_(whole), part_(part), observer_(observer) {}

  void at(const SweepPoint& point) override {
    SweepPoint in_whole = point;
    if (point.vertex.valid()) in_whole.vertex = part_.point[point.vertex.index()];
    const bool is_last = point.points_done == part_.point.size();
    in_whole.points_done = is_last ? whole_.points.size() : part_.point[point.points_done].index();
    observer_.at(in_whole);
  }

 private:
  const ProjectedScene& whole_;
  const ScenePart& part_;
  SweepObserver& observer_;
};

}  // namespace

VisibleSegments fast_visible_segments(const Mesh& mesh, const ProjectedScene& scene, int level,
                                      SweepObserver* observer) {
  if (mesh.touched.empty() || scene.arithmetic != Arithmetic::exact) return sweep(mesh, scene, observer);
  const CellGrid grid(scene.grid_bits, level);
  const Continuation continuation(scene);
  const FacetCells cells(scene, grid);
  const std::vector<DepthRange> depths = depth_ranges(scene);
  const auto hidden =
      hidden_behind_covers(mesh, scene, depths, continuation, grid, cells, hidden_behind_large_facets(scene, depths));
  const Patches patches = find_patches(mesh, scene, continuation, hidden, grid, cells);
  const ScenePart part = part_of(scene, patches.swept);
  std::optional<WholeObserver> watch;
  if (observer != nullptr) watch.emplace(scene, part, *observer);
  VisibleSegments swept = sweep(mesh, part.scene, watch ? &*watch : nullptr);
  if (!swept.statistics.depth_is_transitive) return sweep(mesh, scene, observer);
  return join_segments(scene, continuation, patches, in_whole(scene, part, std::move(swept)));
}

VisibleSegments find_visible_segments(const Mesh& mesh, const ProjectedScene& scene, Engine engine,
                                      SweepObserver* observer) {
  if (engine == Engine::full) return sweep(mesh, scene, observer);
  return fast_visible_segments(mesh, scene, level_for(scene), observer);
}

}  // namespace sightline
