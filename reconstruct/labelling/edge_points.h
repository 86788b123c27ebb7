// The points that split each mesh edge, in order along it: conformity's bookkeeping.
//
// In:  what clipping cut (corners on mesh edges) and what the sweep split.
// Out: per mesh edge its points, from its first end to its second, each a new vertex of the labelled surface. Every
//      face on an edge, culled ones included, uses all of them.
// Holds: the points of one edge have different image points; a new vertex is computed from its edge alone.
// Complexity: O(m log m).
#pragma once

#include <span>
#include <vector>

#include "geometry/mesh/cut_mesh.h"
#include "geometry/projection/projected_scene.h"
#include "reconstruct/labelling/exact_lift.h"
#include "sweep/segments/image_points.h"
#include "sweep/segments/visible_segments.h"

namespace sightline::inline reconstruct {

struct EdgePoint {
  PointId point;
  VertexId vertex;  // of the labelled surface
};

class EdgePoints {
 public:
  // Appends the new vertices to `vertices`, which begins with the mesh's.
  EdgePoints(const ProjectedScene& scene, const VisibleSegments& segments, const ImagePoints& points,
             std::vector<Point3>& vertices);

  // Returns the points from the edge's first end to its second.
  [[nodiscard]] std::span<const EdgePoint> on(MeshEdgeId edge) const {
    return std::span(points_).subspan(begin_[edge.index()], begin_[edge.index() + 1] - begin_[edge.index()]);
  }

  // Returns the vertex at one of the edge's points. Precondition: there is one.
  [[nodiscard]] VertexId vertex(MeshEdgeId edge, PointId p) const;

 private:
  // This is the part of a mesh edge that is in view, whichever facet on it says it, from the edge's first end towards
  // its second.
  struct InView {
    const ClippedCorner* from = nullptr;
    const ClippedCorner* to = nullptr;
  };
  struct Candidate {
    MeshEdgeId edge;
    FacetId facet;  // one on the edge
    PointId point;
    const MadeCorner* made = nullptr;  // where clipping made it
  };

  void find_in_view(const ProjectedScene& scene, const std::vector<Candidate>& found);
  [[nodiscard]] static InView in_view_of(const ProjectedScene& scene, MeshEdgeId edge, FacetId facet);
  [[nodiscard]] static std::vector<Candidate> candidates(const ProjectedScene& scene, const VisibleSegments& segments);
  [[nodiscard]] bool before_on_edge(const Candidate& a, const Candidate& b, const ImagePoints& points) const;
  [[nodiscard]] Point3 position(const Candidate& c, const ProjectedScene& scene, const ImagePoints& points,
                                EdgeLift& lift) const;

  [[nodiscard]] const InView& in_view(MeshEdgeId edge) const { return in_view_[slot_[edge.index()] - 1]; }

  std::vector<std::uint32_t> slot_;  // per edge: one more than its place in in_view_; 0: it has no points
  std::vector<InView> in_view_;
  std::vector<std::uint32_t> begin_;
  std::vector<EdgePoint> points_;
};

}  // namespace sightline::inline reconstruct
