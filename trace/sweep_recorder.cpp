#include "trace/sweep_recorder.h"

#include <algorithm>
#include <set>

#include "geometry/mesh/facet_plane.h"
#include "trace/step_sentence.h"

namespace sightline::trace {

namespace {

constexpr std::size_t shown_of_queue = 8;

SegmentNumber number_of(const OpenSegment& open) {
  return open.segment.valid() ? static_cast<SegmentNumber>(open.segment.index() + 1) : 0;
}

LoggedBundle logged(const Bundle& bundle, StepPredicates& predicates) {
  LoggedBundle result;
  result.edges.assign(bundle.edges.begin(), bundle.edges.end());
  for (const Node& node : bundle.right.nodes()) result.nodes.push_back(node.facet);
  predicates.sort_by_depth(result.nodes, bundle.right.topmost());
  result.left_segment = number_of(bundle.left_segment);
  result.right_segment = number_of(bundle.right_segment);
  return result;
}

std::vector<EdgeId> edges_of(std::span<const LoggedBundle> bundles) {
  std::vector<EdgeId> edges;
  for (const LoggedBundle& bundle : bundles) edges.insert(edges.end(), bundle.edges.begin(), bundle.edges.end());
  return edges;
}

// Returns whether a visible segment runs along it.
bool is_seen(EdgeId edge, std::span<const LoggedBundle> bundles) {
  return std::any_of(bundles.begin(), bundles.end(), [&](const LoggedBundle& bundle) {
    const bool seen = bundle.left_segment != 0 || bundle.right_segment != 0;
    return seen && std::find(bundle.edges.begin(), bundle.edges.end(), edge) != bundle.edges.end();
  });
}

bool contains(const std::vector<EdgeId>& edges, EdgeId edge) {
  return std::find(edges.begin(), edges.end(), edge) != edges.end();
}

// There is one per surface and point.
std::string emit_vertex(FacetId surface, SweepStep& step) {
  for (const EmittedVertex& vertex : step.vertices) {
    if (vertex.surface == surface) return vertex.name;
  }
  step.vertices.push_back({surface, name_of_emitted(step.name, step.vertices.size())});
  return step.vertices.back().name;
}

}  // namespace

SweepRecorder::SweepRecorder(const SceneNames& names, std::size_t most_steps, SweepLog& log)
    : mesh_(log.scene.mesh()), names_(names), most_steps_(most_steps), log_(log), predicates_(log, names) {}

void SweepRecorder::on_state(const SweepState& state) {
  log_.depth_is_transitive = state.so_far().statistics.depth_is_transitive;
  if (log_.steps.size() == most_steps_) throw TooManySteps(log_.scene.points.size());
  SweepStep step;
  std::vector<LoggedBundle> after;
  step.place = state.here();
  step.upcoming = state.upcoming(shown_of_queue);
  find_bundles(state, after, step);
  find_edges(step);
  name_point(step);
  find_segments(state.so_far(), step);
  find_thread(state.so_far(), step);
  find_visibility(step);
  find_covered_edges(step);
  step.predicates = predicates_.of(step, active_, after);
  step.says = sentence_of(step, log_, after);
  active_ = std::move(after);
  log_.steps.push_back(std::move(step));
}

// Only the bundles through the point differ.
void SweepRecorder::find_bundles(const SweepState& state, std::vector<LoggedBundle>& after, SweepStep& step) {
  const ActiveEdgeList& active = state.active();
  for (BundleId b = active.first(); b.valid(); b = active.next(b)) {
    after.push_back(logged(active[b], predicates_));
    if (b == state.left_neighbour()) step.position = after.size();
  }
  const std::size_t below = state.below().size();
  const auto first = after.begin() + static_cast<std::ptrdiff_t>(step.position);
  step.inserted.assign(first, first + static_cast<std::ptrdiff_t>(below));
  step.removed = active_.size() + below - after.size();
}

void SweepRecorder::find_edges(SweepStep& step) const {
  const std::vector<EdgeId> above = edges_of(std::span(active_).subspan(step.position, step.removed));
  const std::vector<EdgeId> below = edges_of(step.inserted);
  for (const EdgeId e : above) (contains(below, e) ? step.passed : step.ended).push_back(e);
  for (const EdgeId e : below) {
    if (!contains(above, e)) step.started.push_back(e);
  }
}

void SweepRecorder::name_point(SweepStep& step) {
  if (!step.place.vertex.valid()) {
    step.kind = PointKind::crossing;
    step.name = name_of_crossing(crossings_++, names_);
    return;
  }
  step.name = log_.point_names[step.place.vertex.index()];
  if (!step.ended.empty()) step.kind = step.started.empty() ? PointKind::bottom : PointKind::side;
}

// What was open along the bundles above either stays open or has both ends now.
void SweepRecorder::find_segments(const VisibleSegments& so_far, SweepStep& step) {
  for (std::size_t i = 0; i < step.removed; ++i) {
    const LoggedBundle& bundle = active_[step.position + i];
    for (const SegmentNumber number : {bundle.left_segment, bundle.right_segment}) {
      if (number == 0) continue;
      const VisibleSegment& segment = so_far.segments[number - 1];
      if (segment.start.valid() && segment.end.valid()) close(number, step);
    }
  }
  while (log_.segments.size() < so_far.segments.size())
    open(static_cast<SegmentNumber>(log_.segments.size() + 1), so_far, step);
}

void SweepRecorder::close(SegmentNumber number, SweepStep& step) {
  LoggedSegment& segment = log_.segments[number - 1];
  segment.closed = log_.steps.size();
  segment.lower = emit_vertex(segment.surface, step);
  step.closed.push_back(number);
}

void SweepRecorder::open(SegmentNumber number, const VisibleSegments& so_far, SweepStep& step) {
  const VisibleSegment& opened = so_far.segments[number - 1];
  LoggedSegment segment;
  segment.surface = surface_of(mesh_, opened.facet);
  segment.other = surface_of(mesh_, opened.other);
  segment.edge = opened.edge;
  segment.upwards = opened.end.valid();
  segment.opened = log_.steps.size();
  segment.upper = emit_vertex(segment.surface, step);
  log_.segments.push_back(segment);
  step.opened.push_back(number);
}

void SweepRecorder::find_thread(const VisibleSegments& so_far, SweepStep& step) {
  if (so_far.threads.size() == threads_) return;
  threads_ = so_far.threads.size();
  step.thread = static_cast<SegmentNumber>(so_far.threads.back().segment.index() + 1);
}

// The facets are those of the spans that meet at the point; the outermost ones are the same above and below it.
void SweepRecorder::find_visibility(SweepStep& step) const {
  std::set<FacetId> above, below;
  const FacetId left = step.position > 0 ? topmost_surface(active_[step.position - 1]) : FacetId();
  above.insert(left);
  below.insert(left);
  for (std::size_t i = 0; i < step.removed; ++i) above.insert(topmost_surface(active_[step.position + i]));
  for (const LoggedBundle& bundle : step.inserted) below.insert(topmost_surface(bundle));
  above.insert(FacetId());
  below.insert(FacetId());
  std::set_difference(below.begin(), below.end(), above.begin(), above.end(), std::back_inserter(step.appeared));
  std::set_difference(above.begin(), above.end(), below.begin(), below.end(), std::back_inserter(step.vanished));
}

void SweepRecorder::find_covered_edges(SweepStep& step) const {
  const auto above = std::span(active_).subspan(step.position, step.removed);
  for (const EdgeId edge : step.passed) {
    const bool was_seen = is_seen(edge, above);
    const bool seen_below = is_seen(edge, step.inserted);
    if (was_seen && !seen_below) step.covered.push_back(edge);
    if (!was_seen && seen_below) step.surfaced.push_back(edge);
  }
}

FacetId SweepRecorder::topmost_surface(const LoggedBundle& bundle) const {
  return bundle.nodes.empty() ? FacetId() : surface_of(mesh_, bundle.nodes.front());
}

}  // namespace sightline::trace
