// Writes down what a sweep does at each of its points.
//
// In:  the states of a sweep, as SweepObserver::on_state shows them.
// Out: the steps and segments of a SweepLog; rings are not known before the end (trace_sweep.h).
// Complexity: per step O(l) for the length l of the active edge list with its node lists, and what the predicates cost.
// Errors: TooManySteps at the first sweep point beyond the limit.
#pragma once

#include <vector>

#include "geometry/mesh/cut_mesh.h"
#include "geometry/numbers/errors.h"
#include "sweep/plain/sweep.h"
#include "trace/step_predicates.h"
#include "trace/sweep_log.h"

namespace sightline::trace {

// The sweep has too many points to be traced.
class TooManySteps : public Error {
 public:
  explicit TooManySteps(std::size_t points_in_view)
      : Error("the sweep has too many points to be traced"), points_in_view_(points_in_view) {}

  // The points that vertices make; crossings are not among them.
  [[nodiscard]] std::size_t points_in_view() const { return points_in_view_; }

 private:
  std::size_t points_in_view_;
};

class SweepRecorder : public SweepObserver {
 public:
  // `log` has its scene and names, and gets its steps and segments.
  SweepRecorder(const SceneNames& names, std::size_t most_steps, SweepLog& log);

  void on_point(const SweepPoint& /*point*/) override {}
  void on_state(const SweepState& state) override;

 private:
  void find_bundles(const SweepState& state, std::vector<LoggedBundle>& after, SweepStep& step);
  void find_edges(SweepStep& step) const;
  void name_point(SweepStep& step);
  void find_segments(const VisibleSegments& so_far, SweepStep& step);
  void close(SegmentNumber number, SweepStep& step);
  void open(SegmentNumber number, const VisibleSegments& so_far, SweepStep& step);
  void find_thread(const VisibleSegments& so_far, SweepStep& step);
  void find_visibility(SweepStep& step) const;
  void find_covered_edges(SweepStep& step) const;
  [[nodiscard]] FacetId topmost_surface(const LoggedBundle& bundle) const;

  const CutMesh& mesh_;
  const SceneNames& names_;
  const std::size_t most_steps_;
  SweepLog& log_;
  StepPredicates predicates_;
  std::vector<LoggedBundle> active_;  // before the step
  std::size_t crossings_ = 0;         // sweep points that were crossings only
  std::size_t threads_ = 0;
};

}  // namespace sightline::trace
