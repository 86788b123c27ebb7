#include "sweep/engine.h"

#include <algorithm>
#include <mutex>

#include "geometry/numbers/parallel.h"
#include "sweep/bands/bands.h"
#include "sweep/bands/joined_segments.h"
#include "sweep/bands/scene_part.h"
#include "sweep/fast/covers.h"
#include "sweep/fast/roles.h"
#include "sweep/fast/scene_in_cells.h"
#include "sweep/unrounded/unrounded_sweep.h"

namespace sightline::inline sweep {
namespace {

// This tells an observer where the sweeps of several bands are in the whole: how far all of them are together.
class BandObservers {
 public:
  BandObservers(const ProjectedScene& whole, SweepObserver* observer) : whole_(whole), observer_(observer) {}

  class Band : public SweepObserver {
   public:
    Band(BandObservers& all, const ScenePart& part) : all_(all), part_(part) {}
    void on_point(const SweepPoint& point) override {
      SweepPoint in_whole = point;
      if (point.vertex.valid()) in_whole.vertex = part_.point[point.vertex.index()];
      all_.on_point(in_whole, point.points_done - done_);
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
  void on_point(SweepObserver::SweepPoint& point, std::size_t newly_done) {
    const std::lock_guard lock(mutex_);
    done_ += newly_done;
    point.points_done = whole_.points.size() * done_ / std::max(expected_, done_);
    observer_->on_point(point);
  }

  const ProjectedScene& whole_;
  SweepObserver* const observer_;
  std::mutex mutex_;
  std::size_t expected_ = 0;
  std::size_t done_ = 0;
};

VisibleSegments swept(const ProjectedScene& scene, std::span<const DepthRange> depths, SweepObserver* observer) {
  return scene.is_unrounded() ? unrounded_sweep(scene, depths, observer) : plain_sweep(scene, depths, observer);
}

VisibleSegments swept_band(const SceneInCells& in, std::span<const FacetId> facets, BandObservers& observers) {
  const ScenePart part = part_of(in.scene, in.continuation, facets);
  observers.expect(part.point.size());
  BandObservers::Band observer(observers, part);
  SweepObserver* const watched = observers.is_watched() ? &observer : nullptr;
  return in_whole(in.scene, part, swept(part.scene, in.depths, watched));
}

std::vector<VisibleSegments> swept_bands(const SceneInCells& in, const Bands& bands, SweepObserver* observer) {
  BandObservers observers(in.scene, observer);
  std::vector<VisibleSegments> swept(bands.swept.size());
  parallel_for_each(swept.size(), 1,
                    [&](std::size_t band) { swept[band] = swept_band(in, bands.swept[band], observers); });
  return swept;
}

VisibleSegments sweep_everything(const ProjectedScene& scene, SweepObserver* observer) {
  return swept(scene, is_exact(scene.arithmetic) ? depth_ranges(scene) : std::vector<DepthRange>{}, observer);
}

}  // namespace

VisibleSegments fast_visible_segments(const ProjectedScene& scene, const FastOptions& options,
                                      SweepObserver* observer) {
  if (!is_exact(scene.arithmetic)) return sweep_everything(scene, observer);
  const SceneInCells in(scene, options.level);
  const Covers covers = find_covers(in);
  const std::vector<Role> roles = find_roles(in, covers);
  const Bands bands = options.bands ? make_bands(in, roles, *options.bands) : make_bands(in, roles);
  return join_segments(in, roles, bands, swept_bands(in, bands, observer));
}

VisibleSegments find_visible_segments(const ProjectedScene& scene, Engine engine, SweepObserver* observer) {
  return engine == Engine::full ? sweep_everything(scene, observer) : fast_visible_segments(scene, {}, observer);
}

}  // namespace sightline::inline sweep
