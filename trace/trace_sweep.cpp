#include "trace/trace_sweep.h"

#include <algorithm>
#include <optional>

#include "geometry/mesh/facet_plane.h"
#include "sightline/analyzer.h"

namespace sightline::trace {

namespace {

void add_ring(const CutMesh& mesh, const VisiblePolygons& polygons, std::size_t polygon, std::size_t ring,
              SweepLog& log) {
  const VisiblePolygon& of = polygons.polygons[polygon];
  LoggedRing logged{surface_of(mesh, of.facet), polygon, ring != of.first_ring, {}};
  std::size_t closes = 0;
  for (const SegmentId s : polygons.ring(ring)) {
    logged.segments.push_back(static_cast<SegmentNumber>(s.index() + 1));
    closes = std::max(closes, log.segments[s.index()].closed.value());
  }
  log.steps[closes].rings.push_back(log.rings.size());
  log.steps[closes].says += logged.is_hole ? " With that the ring of a hole closes." : " With that a ring closes.";
  log.rings.push_back(std::move(logged));
}

void add_rings(const Visibility& visible, SweepLog& log) {
  const VisiblePolygons& polygons = visible.polygons;
  for (std::size_t p = 0; p < polygons.polygons.size(); ++p) {
    const VisiblePolygon& polygon = polygons.polygons[p];
    for (std::size_t r = 0; r < polygon.ring_count; ++r)
      add_ring(visible.mesh(), polygons, p, polygon.first_ring + r, log);
  }
}

// Has the sweep of an analysis recorded.
class TracingHook : public AnalysisHook {
 public:
  TracingHook(const SceneNames& names, std::size_t most_points, SweepLog& log)
      : names_(names), most_points_(most_points), log_(log) {}

  void projected(const ProjectedScene& scene) override {
    log_.scene = scene;
    log_.point_names = names_of_points(scene, names_);
    log_.face_names = names_of_faces(scene.mesh(), names_);
    log_.face_of = scene.mesh().facet_face;
    if (scene.points.size() > most_points_) throw TooManySteps(scene.points.size());
    recorder_.emplace(names_, most_points_, log_);
  }

  [[nodiscard]] SweepObserver* sweep_observer() override { return &*recorder_; }
  [[nodiscard]] bool has_begun() const { return recorder_.has_value(); }

 private:
  const SceneNames& names_;
  std::size_t most_points_;
  SweepLog& log_;
  std::optional<SweepRecorder> recorder_;
};

}  // namespace

SweepLog trace_sweep(const TracedView& view, std::size_t most_points) {
  SweepLog log;
  TracingHook hook(view.names, most_points, log);
  const Analyzer analyzer(
      view.mesh, {.sides = policy_of(view.sides), .precision = view.precision, .engine = Engine::full, .hook = &hook});
  try {
    add_rings(analyzer.visible(view.camera), log);
  } catch (const ArithmeticError& error) {
    if (!hook.has_begun()) throw;
    log.broken = error.broken();
  }
  return log;
}

}  // namespace sightline::trace
