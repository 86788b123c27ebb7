#include "sweep/plain/segment_recorder.h"

#include <algorithm>
#include <tuple>

#include "geometry/mesh/facet_plane.h"
#include "geometry/numbers/errors.h"

namespace sightline::inline sweep {

void SegmentRecorder::record(const NamedPoint& point, std::span<const AboveSegment> above,
                             std::span<const BundleId> below, const NodeList& left, ActiveEdgeList& active) {
  ending_.clear();
  end_point_surfaces_.clear();
  look_below(below, left, active);
  keep_or_end(above, active);
  note_starts(below, active);
  if (!end_point_surfaces_.empty()) {
    std::sort(end_point_surfaces_.begin(), end_point_surfaces_.end());
    end_kept_at_end_points(below, active);
    name(point, below, active);
    emit(below, active);
    if (above.empty() && left.topmost().valid()) add_thread(left.topmost(), below.front(), active);
  }
  for (const BundleId b : below) active.visibility_changed(b);
}

// Each bundle below is told what it should show; there is no segment yet.
void SegmentRecorder::look_below(std::span<const BundleId> below, const NodeList& left, ActiveEdgeList& active) const {
  const NodeList* before = &left;
  for (const BundleId b : below) {
    Bundle& bundle = active[b];
    bundle.left_segment = {};
    bundle.right_segment = {};
    const FacetId left_facet = before->topmost();
    const FacetId right_facet = bundle.right.topmost();
    if (left_facet != right_facet && surface_of(mesh_, left_facet) != surface_of(mesh_, right_facet)) {
      bundle.left_segment = wanted(bundle.edge_span(), *before, bundle.right);
      bundle.right_segment = wanted(bundle.edge_span(), bundle.right, *before);
    }
    before = &bundle.right;
  }
}

OpenSegment SegmentRecorder::wanted(std::span<const EdgeId> edges, const NodeList& own, const NodeList& other) const {
  if (!own.topmost().valid()) return {};
  return {SegmentId{}, carrier(edges, own, other), own.topmost(), other.topmost()};
}

// Returns the first edge that belongs to the facet, or else to the other one: this choice does not depend on how faces
// are numbered.
EdgeId SegmentRecorder::carrier(std::span<const EdgeId> edges, const NodeList& own, const NodeList& other) const {
  for (const FacetId side : {own.topmost(), other.topmost()}) {
    const auto found = std::find_if(edges.begin(), edges.end(), [&](EdgeId e) { return carries(e, side); });
    if (found != edges.end()) return *found;
  }
  return carrier_of_cycle(edges, own, other);
}

// Where depths are no order, a facet that is not topmost itself may decide who is: one in a top cycle, or one that puts
// another of a top cycle out of range. If there were none, both lists had one top cycle. Facets that do neither may be
// hidden, and their edges missing (covers.h).
EdgeId SegmentRecorder::carrier_of_cycle(std::span<const EdgeId> edges, const NodeList& own,
                                         const NodeList& other) const {
  std::vector<FacetId> cycles = own.top_cycle(depth_);
  const std::vector<FacetId> of_other = other.top_cycle(depth_);
  cycles.insert(cycles.end(), of_other.begin(), of_other.end());
  const auto decides = [&](const EdgeSide& side) {
    return std::ranges::any_of(cycles, [&](FacetId f) {
      return f == side.facet || (f.valid() && depth_.range(side.facet).farthest < depth_.range(f).nearest);
    });
  };
  const auto found = std::ranges::find_if(
      edges, [&](EdgeId e) { return !is_swap_edge(e) && std::ranges::any_of(scene_.sides_of(e), decides); });
  if (found == edges.end())
    throw InternalError("what is seen changes along edge " + std::to_string(edges.front().value) +
                        ", and no facet on it decides that");
  return *found;
}

bool SegmentRecorder::carries(EdgeId edge, FacetId facet) const {
  if (!facet.valid()) return false;
  const FacetId surface = surface_of(mesh_, facet);
  if (is_swap_edge(edge)) {
    const auto [f, g] = edges_.surfaces_of_swap_edge(edge);
    return f == surface || g == surface;
  }
  const auto sides = scene_.sides_of(edge);
  return std::any_of(sides.begin(), sides.end(),
                     [&](const EdgeSide& side) { return surface_of(mesh_, side.facet) == surface; });
}

void SegmentRecorder::keep_or_end(std::span<const AboveSegment> above, ActiveEdgeList& active) {
  for (const AboveSegment& segment : above) {
    const BundleId b = active.bundle_of(segment.open.edge);
    if (b.valid()) {
      Bundle& bundle = active[b];
      OpenSegment& below = segment.left_of_edge ? bundle.left_segment : bundle.right_segment;
      if (continues(segment, below, bundle.edge_span())) {
        below.segment = segment.open.segment;
        below.edge = segment.open.edge;
        continue;
      }
    }
    ending_.push_back(segment);
    end_point_surfaces_.push_back(surface_of(mesh_, segment.open.facet));
  }
}

// A segment continues where its edge could have been chosen for the segment below, too.
bool SegmentRecorder::continues(const AboveSegment& above, const OpenSegment& below,
                                std::span<const EdgeId> edges) const {
  if (!below.facet.valid() || surface_of(mesh_, above.open.facet) != surface_of(mesh_, below.facet)) return false;
  for (const FacetId side : {below.facet, below.other}) {
    if (carries(above.open.edge, side)) return true;
    if (std::any_of(edges.begin(), edges.end(), [&](EdgeId e) { return carries(e, side); })) return false;
  }
  return true;
}

void SegmentRecorder::note_starts(std::span<const BundleId> below, const ActiveEdgeList& active) {
  for (const BundleId b : below) {
    for (const OpenSegment* open : {&active[b].left_segment, &active[b].right_segment}) {
      if (open->facet.valid() && !open->segment.valid()) end_point_surfaces_.push_back(surface_of(mesh_, open->facet));
    }
  }
}

void SegmentRecorder::end_kept_at_end_points(std::span<const BundleId> below, ActiveEdgeList& active) {
  for (const BundleId b : below) {
    for (const bool left : {true, false}) {
      OpenSegment& open = left ? active[b].left_segment : active[b].right_segment;
      if (!open.segment.valid() || !has_end_point(open.facet)) continue;
      ending_.push_back({open, left});
      open.segment = SegmentId{};
    }
  }
}

bool SegmentRecorder::has_end_point(FacetId facet) const {
  return std::binary_search(end_point_surfaces_.begin(), end_point_surfaces_.end(), surface_of(mesh_, facet));
}

void SegmentRecorder::name(const NamedPoint& point, std::span<const BundleId> below, const ActiveEdgeList& active) {
  point_ = point.vertex;
  if (point_.valid()) return;
  point_ = PointId(scene_.points.size() + result_.crossings.size());
  const bool exact = is_exact(scene_.arithmetic);
  result_.crossings.push_back(exact ? crossing_of_carriers(point.crossing.after, below, active) : point.crossing);
}

// The crossing depends on what is seen alone, and so do the surfaces of swap edges, not their ids: nothing starts or ends along one line only. In float and double edges may
// seem to meet here that do not cross at all, and only those that the sweep found to cross are safe names.
Crossing SegmentRecorder::crossing_of_carriers(PointId after, std::span<const BundleId> below,
                                               const ActiveEdgeList& active) const {
  std::vector<EdgeId> carriers;
  for (const AboveSegment& ending : ending_) carriers.push_back(ending.open.edge);
  for (const BundleId b : below) {
    for (const OpenSegment* open : {&active[b].left_segment, &active[b].right_segment}) {
      if (open->facet.valid() && !open->segment.valid()) carriers.push_back(open->edge);
    }
  }
  std::ranges::sort(carriers, {}, [this](EdgeId e) {
    const auto surfaces = is_swap_edge(e) ? edges_.surfaces_of_swap_edge(e) : std::array<FacetId, 2>{};
    return is_swap_edge(e) ? std::tuple(true, surfaces[0], surfaces[1], EdgeId{})
                           : std::tuple(false, FacetId{}, FacetId{}, e);
  });
  const auto other =
      std::find_if(carriers.begin(), carriers.end(), [&](EdgeId e) { return edges_.turn(carriers.front(), e) != 0; });
  if (other == carriers.end())
    throw InternalError("what is seen changes along edge " + std::to_string(carriers.front().value) + " only");
  return {carriers.front(), *other, after};
}

void SegmentRecorder::emit(std::span<const BundleId> below, ActiveEdgeList& active) {
  for (const AboveSegment& ending : ending_) {
    VisibleSegment& segment = result_.segments[ending.open.segment.index()];
    (ending.left_of_edge ? segment.start : segment.end) = point_;
  }
  for (const BundleId b : below) {
    start(active[b].left_segment, true);
    start(active[b].right_segment, false);
  }
  split_edges(below, active);
}

// The face lies to the left of its segment: left of an edge the segment runs upwards, right of it downwards (Fang's
// figure 5.4).
void SegmentRecorder::start(OpenSegment& open, bool left_of_edge) {
  if (!open.facet.valid() || open.segment.valid()) return;
  open.segment = SegmentId(result_.segments.size());
  VisibleSegment segment{{}, {}, open.facet, open.other, open.edge};
  (left_of_edge ? segment.end : segment.start) = point_;
  result_.segments.push_back(segment);
}

void SegmentRecorder::split_edges(std::span<const BundleId> below, const ActiveEdgeList& active) {
  for (const BundleId b : below) {
    for (const EdgeId e : active[b].edges) {
      if (is_swap_edge(e) || scene_.edge(e).top == point_) continue;
      for (const EdgeSide& side : scene_.sides_of(e)) {
        if (has_end_point(side.facet)) result_.splits.push_back({side.mesh_edge, side.facet, e, point_});
      }
    }
  }
}

// Nothing was visible along the bundles above, and a face lies around the point: what starts here may be a hole in it.
void SegmentRecorder::add_thread(FacetId left, BundleId first_below, const ActiveEdgeList& active) {
  const BundleId b = active.nearest_visible_before(first_below);
  if (!b.valid() || !active[b].right_segment.segment.valid() ||
      surface_of(mesh_, active[b].right_segment.facet) != surface_of(mesh_, left)) {
    throw InternalError("no visible segment of face " + std::to_string(mesh_.facet_face[left.index()].value) +
                        " bounds it left of sweep point " + std::to_string(point_.value));
  }
  result_.threads.push_back({point_, left, active[b].right_segment.segment});
}

}  // namespace sightline::inline sweep
