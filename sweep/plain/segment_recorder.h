// Emits visible segments while the sweep goes by (Fang 1993, appendix B.1 and B.2, without the constraints).
//
// At each sweep point: the segments that were open along the bundles above, and what is visible along the bundles
// below, decide which segments end, which stay open and which start.
//
// A segment runs along one edge between one face on its left and one on its right:
//   - its edge is one of the visible face's own edges where one lies there, else one of the face's on the other side;
//   - it stays open through a sweep point as long as that edge and its surface stay the same (what lies on the other
//     side may change: Fang's segment 4), and no other segment of its surface starts or ends at that point: so the
//     segments of one surface meet in end points only.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/mesh/cut_mesh.h"
#include "geometry/projection/projected_scene.h"
#include "sweep/plain/active_edge_list.h"
#include "sweep/segments/edge_turns.h"
#include "sweep/segments/visible_segments.h"

namespace sightline::inline sweep {

// This segment was open along a bundle above the sweep point.
struct AboveSegment {
  OpenSegment open;
  bool left_of_edge = false;
};

// The sweep is at a vertex, or, where that is invalid, at the crossing of two edges.
struct NamedPoint {
  PointId vertex;
  Crossing crossing;
};

// What a decider knows of edges, of swap edges among them (decider.h).
class SweptEdges : public EdgeTurns {
 public:
  [[nodiscard]] virtual std::array<FacetId, 2> surfaces_of_swap_edge(EdgeId e) const = 0;
};

class SegmentRecorder {
 public:
  SegmentRecorder(const ProjectedScene& scene, const SweptEdges& edges, DepthOrder& depth, VisibleSegments& result)
      : mesh_(scene.mesh()),
        scene_(scene),
        edge_count_(scene.edge_count()),
        edges_(edges),
        depth_(depth),
        result_(result) {}

  // `below` has the bundles below the point, left to right; they are in the active edge list with their edges and node
  // lists, and get their open segments here. `left` is what is over the span left of the point.
  void record(const NamedPoint& point, std::span<const AboveSegment> above, std::span<const BundleId> below,
              const NodeList& left, ActiveEdgeList& active);

 private:
  void look_below(std::span<const BundleId> below, const NodeList& left, ActiveEdgeList& active) const;
  [[nodiscard]] OpenSegment wanted(std::span<const EdgeId> edges, const NodeList& own, const NodeList& other) const;
  [[nodiscard]] EdgeId carrier(std::span<const EdgeId> edges, const NodeList& own, const NodeList& other) const;
  [[nodiscard]] EdgeId carrier_of_cycle(std::span<const EdgeId> edges, const NodeList& own,
                                        const NodeList& other) const;
  [[nodiscard]] bool is_swap_edge(EdgeId edge) const { return edge.index() >= edge_count_; }
  [[nodiscard]] bool carries(EdgeId edge, FacetId facet) const;
  void keep_or_end(std::span<const AboveSegment> above, ActiveEdgeList& active);
  [[nodiscard]] bool continues(const AboveSegment& above, const OpenSegment& below,
                               std::span<const EdgeId> edges) const;
  void note_starts(std::span<const BundleId> below, const ActiveEdgeList& active);
  void end_kept_at_end_points(std::span<const BundleId> below, ActiveEdgeList& active);
  [[nodiscard]] bool has_end_point(FacetId facet) const;
  void emit(std::span<const BundleId> below, ActiveEdgeList& active);
  void start(OpenSegment& open, bool left_of_edge);
  void split_edges(std::span<const BundleId> below, const ActiveEdgeList& active);
  void add_thread(FacetId left, BundleId first_below, const ActiveEdgeList& active);
  void name(const NamedPoint& point, std::span<const BundleId> below, const ActiveEdgeList& active);
  [[nodiscard]] Crossing crossing_of_carriers(PointId after, std::span<const BundleId> below,
                                              const ActiveEdgeList& active) const;

  const CutMesh& mesh_;
  const ProjectedScene& scene_;
  const std::size_t edge_count_;
  const SweptEdges& edges_;
  DepthOrder& depth_;
  VisibleSegments& result_;

  // These belong to the current sweep point.
  PointId point_;
  std::vector<AboveSegment> ending_;
  std::vector<FacetId> end_point_surfaces_;  // sorted once complete
};

}  // namespace sightline::inline sweep
