#include "sweep/engine.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <mutex>

#include "geometry/numbers/parallel.h"
#include "sweep/bands/bands.h"
#include "sweep/bands/joined_segments.h"
#include "sweep/bands/scene_part.h"
#include "sweep/fast/cell_grid.h"
#include "sweep/fast/covers.h"
#include "sweep/fast/large_covers.h"
#include "sweep/fast/roles.h"

namespace sightline::inline sweep {
namespace {

constexpr int highest_level = 11;
constexpr std::size_t most_samples = 1 << 16;

// Cells are as fine as so many pairs of a facet and a cell in its bounding box allow, per facet in view: contour edges
// then touch few of them, and looking at all pairs still costs little. Where nothing continues, all is contour, and
// fine cells have to find what can be left out.
constexpr double pairs_of_surface_facet = 6;
constexpr double pairs_of_lone_facet = 40;

double contour_share(const ProjectedScene& scene, const Continuation& continuation) {
  std::atomic<std::size_t> contours = 0;
  parallel_for_ranges(scene.edge_count(), [&](std::size_t /*range*/, std::size_t begin, std::size_t end) {
    std::size_t here = 0;
    for (std::size_t e = begin; e < end; ++e) here += continuation.is_contour(EdgeId(e)) ? 1 : 0;
    contours += here;
  });
  return static_cast<double>(contours) / static_cast<double>(std::max<std::size_t>(scene.edge_count(), 1));
}

// Returns, per level of cells, the pairs of all facets that are not known to be hidden, as a sample of them says.
std::array<double, highest_level + 1> pairs_by_level(const ProjectedScene& scene,
                                                     const std::vector<std::uint8_t>& hidden) {
  const CellGrid finest(scene.grid_bits, highest_level);
  const std::size_t step = 1 + scene.status.size() / most_samples;
  std::array<double, highest_level + 1> pairs{};
  for (std::size_t f = 0; f < scene.status.size(); f += step) {
    if (scene.status[f] != Status::in_view || hidden[f] != 0) continue;
    const CellRange range = finest.range_of(FacetOutline(scene, FacetId(f)).points());
    for (int level = 0; level <= highest_level; ++level) {
      const int shift = highest_level - level;
      const double columns = (range.right >> shift) - (range.left >> shift) + 1;
      const double rows = (range.top >> shift) - (range.bottom >> shift) + 1;
      pairs[static_cast<std::size_t>(level)] += static_cast<double>(step) * columns * rows;
    }
  }
  return pairs;
}

int level_for(const ProjectedScene& scene, const Continuation& continuation, const std::vector<std::uint8_t>& hidden) {
  const auto pairs = pairs_by_level(scene, hidden);
  const double share = contour_share(scene, continuation);
  const double per_facet = share * pairs_of_lone_facet + (1 - share) * pairs_of_surface_facet;
  const auto facets = static_cast<double>(std::ranges::count(scene.status, Status::in_view));
  int level = highest_level;
  while (level > 0 && pairs[static_cast<std::size_t>(level)] > per_facet * facets) --level;
  return level;
}

// This tells an observer where the sweeps of several bands are in the whole: how far all of them are together.
class BandObservers {
 public:
  BandObservers(const ProjectedScene& whole, SweepObserver* observer) : whole_(whole), observer_(observer) {}

  class Band : public SweepObserver {
   public:
    Band(BandObservers& all, const ScenePart& part) : all_(all), part_(part) {}
    void at(const SweepPoint& point) override {
      SweepPoint in_whole = point;
      if (point.vertex.valid()) in_whole.vertex = part_.point[point.vertex.index()];
      all_.at(in_whole, point.points_done - done_);
      done_ = point.points_done;
    }

   private:
    BandObservers& all_;
    const ScenePart& part_;
    std::size_t done_ = 0;
  };

  void expect(std::size_t points) {
    const std::lock_guard lock(mutex_);
    expected_ += points;
  }
  [[nodiscard]] bool is_watched() const { return observer_ != nullptr; }

 private:
  void at(SweepObserver::SweepPoint& point, std::size_t newly_done) {
    const std::lock_guard lock(mutex_);
    done_ += newly_done;
    point.points_done = whole_.points.size() * done_ / std::max(expected_, done_);
    observer_->at(point);
  }

  const ProjectedScene& whole_;
  SweepObserver* const observer_;
  std::mutex mutex_;
  std::size_t expected_ = 0;
  std::size_t done_ = 0;
};

VisibleSegments swept_band(const ProjectedScene& scene, const Continuation& continuation,
                           std::span<const DepthRange> depths, std::span<const FacetId> facets,
                           BandObservers& observers) {
  const ScenePart part = part_of(scene, continuation, facets);
  observers.expect(part.point.size());
  BandObservers::Band observer(observers, part);
  return in_whole(scene, part, plain_sweep(part.scene, depths, observers.is_watched() ? &observer : nullptr));
}

std::vector<VisibleSegments> swept_bands(const ProjectedScene& scene, const Continuation& continuation,
                                         std::span<const DepthRange> depths, const Bands& bands,
                                         SweepObserver* observer) {
  BandObservers observers(scene, observer);
  std::vector<VisibleSegments> swept(bands.swept.size());
  parallel_for_each(swept.size(), 1, [&](std::size_t band) {
    swept[band] = swept_band(scene, continuation, depths, bands.swept[band], observers);
  });
  return swept;
}

}  // namespace

VisibleSegments fast_visible_segments(const ProjectedScene& scene, const FastOptions& options,
                                      SweepObserver* observer) {
  const CutMesh& mesh = scene.mesh();
  if (scene.arithmetic != Arithmetic::exact) return plain_sweep(scene, observer);
  const Continuation continuation(scene);
  const std::vector<DepthRange> depths = depth_ranges(scene);
  std::vector<std::uint8_t> behind_large = hidden_behind_large_facets(scene, depths);
  keep_surfaces_whole(scene, behind_large);
  const CellGrid grid(scene.grid_bits, options.level ? *options.level : level_for(scene, continuation, behind_large));
  const FacetCells cells(scene, continuation, grid, behind_large);
  const Covers covers = find_covers(scene, depths, continuation, grid, cells, behind_large);
  const std::vector<Role> roles = find_roles(scene, continuation, covers, grid, cells);
  const Bands bands = make_bands(mesh, roles, grid, cells, options.bands.value_or(band_count(roles, grid, cells)));
  std::vector<VisibleSegments> swept = swept_bands(scene, continuation, depths, bands, observer);
  return join_segments(scene, continuation, roles, bands, std::move(swept));
}

VisibleSegments find_visible_segments(const ProjectedScene& scene, Engine engine, SweepObserver* observer) {
  return engine == Engine::full ? plain_sweep(scene, observer) : fast_visible_segments(scene, {}, observer);
}

}  // namespace sightline::inline sweep
