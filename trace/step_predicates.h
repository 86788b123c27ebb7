// The decisions behind a step of the sweep: their operands, their signs, and what decided them.
//
// In:  a step, and the active edge list before and after it.
// Out: the tests that the step stands on:
//   - order:     why this point is next: it comes before the event queue's next one;
//   - side:      on which side of the neighbouring bundles a vertex lies, and that it lies on those that go on
//                through it;
//   - direction: the order of the bundles below the point; whether new neighbours come nearer to each other, and then,
//                as a side, whether they cross;
//   - depth:     for facets that are new neighbours in a node list, which is in front.
// They are decided again here, by the functions that the sweep calls (image_decisions.h, crossing_point.h,
// predicates.h, depth_ranges.h), tier by tier. So a sweep that is not traced pays nothing, and its counts are its own.
// It asks for other sides on its way through the active edge list, and for fewer depths: only what is topmost counts.
// decided_by: integers (exact by their size, there is no filter), filter (double, with a proven bound), exact
//      (integers of any size, where the filter did not decide), ranges (depths that do not overlap), rule (no
//      arithmetic), float, double.
// Complexity: as the step, and the corners of facets that are compared.
#pragma once

#include <span>
#include <vector>

#include "geometry/mesh/cut_mesh.h"
#include "sweep/plain/depth_order.h"
#include "sweep/plain/depth_ranges.h"
#include "trace/names.h"
#include "trace/sweep_log.h"

namespace sightline::trace {

class StepPredicates {
 public:
  StepPredicates(const SweepLog& log, const SceneNames& names);

  // Sorts the facets of a list, with its topmost one, from the nearest to the farthest, as Fang has his node lists.
  void sort_by_depth(std::vector<FacetId>& facets, FacetId topmost);

  [[nodiscard]] std::vector<LoggedPredicate> of(const SweepStep& step, std::span<const LoggedBundle> before,
                                                std::span<const LoggedBundle> after);

 private:
  void add_order(const SweepStep& step);
  void add_sides(const SweepStep& step, std::span<const LoggedBundle> before, std::span<const LoggedBundle> after);
  void add_directions(const SweepStep& step);
  void add_meetings(const SweepStep& step, std::span<const LoggedBundle> after);
  void add_depths(const SweepStep& step, std::span<const LoggedBundle> before);

  Sign add_side(EdgeId edge, PointId point);
  Sign add_direction(EdgeId a, EdgeId b);
  void add_meeting(EdgeId left, EdgeId right);
  void add_depth(FacetId f, FacetId g);
  // Precondition: f has the lower index.
  void add_rule_of_one_plane(FacetId f, FacetId g);
  // Returns whether the corners decide.
  bool add_corners_against_plane(FacetId f, FacetId g);
  Sign add_corner_against_plane(VertexId v, FacetId plane);
  void add_verdict(FacetId f, FacetId g, const std::string& decided_by, const std::string& because);

  [[nodiscard]] const std::string& name(FacetId f) const;
  [[nodiscard]] std::string name(EdgeId e) const;
  [[nodiscard]] Operand operand(PointId p) const;
  [[nodiscard]] const char* integers() const;

  const CutMesh& mesh_;
  const SweepLog& log_;
  const ProjectedScene& scene_;
  const SceneNames& names_;
  const std::vector<DepthRange> ranges_;
  DepthOrder depth_;
  const PieceOrder pieces_;
  std::vector<LoggedPredicate> found_;
};

}  // namespace sightline::trace
