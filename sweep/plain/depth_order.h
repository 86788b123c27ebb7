// Which of two facets is in front, exactly, on the input's own coordinates: depth is never rounded.
//
// In:  two facets that overlap somewhere in the image and are not edge-on; without a local order they do not pass through
//      each other either.
// Out: whether the first is nearer to the eye there.
// Holds: facets that do not pass through each other have one order wherever they overlap, since both are convex and
// planar; so the answer does not depend on the place. nearer(f, g) != nearer(g, f). Of coplanar facets one whose front the
// eye sees is in front of one that is turned away; of two alike the lower face index is in front. Pieces of facets that were
// cut along common lines have the order of the uncut facets, or, where these cross, one of their own (piece_order.h).
// Method: if all of one facet is less deep than all of the other (depth_ranges.h), it is nearer. If all of one facet is
// on one side of the other's plane, that side decides. Otherwise they straddle each other's planes, and a place where
// they overlap is found: a corner of one within the other, or edges of both that cross, seen from the eye. Such a place
// shows the order by one orient3d. Facets that overlap in the rounded image only (narrower than the grid) show no
// place; the lower facet index is in front.
// Where one of the facets counts as in the plane of another (CutMesh::snapped_to), all places show the order, and their depths there
// are compared (snapped_order.h).
// Departure from Fang's appendix B, which compares depths at the sweep point: that needs the rounded point lifted, and
// cannot be exact.
// With a local order facets may pass through each other, too; for these it is asked each time: for those that are in front in
// one place where they overlap, and behind in another.
// In float and double (arithmetic.h) the signs are plain evaluations: nearer(f, g) != nearer(g, f) and the rule of
// coplanar facets still hold, nothing else does. The order of pieces whose uncut facets cross is exact in all.
#pragma once

#include <array>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "geometry/mesh/cut_mesh.h"
#include "geometry/numbers/predicates.h"
#include "geometry/projection/projected_scene.h"
#include "sweep/plain/depth_ranges.h"
#include "sweep/plain/piece_order.h"
#include "sweep/plain/snapped_order.h"

namespace sightline::inline sweep {

// How two facets lie to each other.
struct DepthRelation {
  bool nearer = false;          // the first one, here
  bool passes_through = false;  // they may change places elsewhere; known with a local order only
};

// Says how two facets lie to each other where the sweep is, of which one is in front in one place and the other in another,
// be it out of view.
class LocalOrder {
 public:
  virtual ~LocalOrder() = default;
  [[nodiscard]] virtual DepthRelation relation_here(FacetId f, FacetId g) = 0;
};

class DepthOrder {
 public:
  // ranges: per facet, as depth_ranges(scene) gives them; or none, and then they do not help.
  DepthOrder(const ProjectedScene& scene, std::span<const DepthRange> ranges = {});

  // From here on facets that pass through each other have the order that this one says. It outlives its use.
  void set_local_order(LocalOrder* local);

  [[nodiscard]] DepthRelation relation(FacetId f, FacetId g);
  [[nodiscard]] bool nearer(FacetId f, FacetId g) { return relation(f, g).nearer; }
  // Returns whether they change places somewhere, be it out of view. Precondition: there is a local order.
  [[nodiscard]] bool pass_through(FacetId f, FacetId g);

  // The range is unbounded where no ranges are known.
  [[nodiscard]] DepthRange range(FacetId f) const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return ranges_.empty() ? DepthRange{-infinity, infinity} : ranges_[f.index()];
  }

  [[nodiscard]] const predicates::Counts& counts() const { return counts_; }
  [[nodiscard]] std::uint64_t comparisons() const { return comparisons_; }

 private:
  // The evidence counts how many places show the first facet in front, and how many behind.
  struct Evidence {
    int front = 0;
    int behind = 0;
    void add(Sign towards_eye) {
      front += towards_eye > 0 ? 1 : 0;
      behind += towards_eye < 0 ? 1 : 0;
    }
  };

  [[nodiscard]] bool is_turned(UncutFacetId u) const;
  [[nodiscard]] bool are_apart(FacetId near, FacetId far) const {
    return !ranges_.empty() && ranges_[near.index()].farthest < ranges_[far.index()].nearest;
  }
  [[nodiscard]] DepthRelation relation_of_lower(FacetId f, FacetId g);
  [[nodiscard]] DepthRelation relation_of_uncut(UncutFacetId f, UncutFacetId g);
  [[nodiscard]] DepthRelation relation_of_snapped(UncutFacetId f, UncutFacetId g);
  [[nodiscard]] DepthRelation relation_where_seen(const Evidence& seen) const;
  [[nodiscard]] DepthRelation relation_in_plane(UncutFacetId f, UncutFacetId g) const;
  [[nodiscard]] bool is_any_snapped(UncutFacetId f, UncutFacetId g) const {
    return mesh_.is_snapped(f) || mesh_.is_snapped(g);
  }
  [[nodiscard]] DepthRelation known_relation(UncutFacetId f, UncutFacetId g);
  [[nodiscard]] Evidence corners_against_plane(UncutFacetId f, UncutFacetId g);
  [[nodiscard]] Evidence overlap_evidence(UncutFacetId f, UncutFacetId g);
  // Returns +1 where f is the nearer one on the ray to v, a corner of f.
  [[nodiscard]] Sign nearer_at_corner(UncutFacetId f, UncutFacetId g, VertexId v);
  [[nodiscard]] bool covers(UncutFacetId f, VertexId v);
  void add_edge_crossings(UncutFacetId f, UncutFacetId g, Evidence& evidence);
  // Returns three corners, so turned that the eye sees them counter-clockwise.
  [[nodiscard]] std::array<VertexId, 3> plane_of(UncutFacetId w) const;
  [[nodiscard]] Sign side_towards_eye(UncutFacetId plane, VertexId v);
  [[nodiscard]] Sign seen_orientation(VertexId a, VertexId b, VertexId c);
  [[nodiscard]] Sign orientation(VertexId a, VertexId b, VertexId c, const HomogeneousPoint& d);

  const CutMesh& mesh_;
  const Arithmetic arithmetic_;
  const Camera& camera_;
  const std::vector<FacetFacing>& facing_;
  PieceOrder pieces_;
  const std::span<const DepthRange> ranges_;
  LocalOrder* local_ = nullptr;
  std::unique_ptr<SnappedOrder> snapped_;  // where facets are
  // With a local order the same pairs are asked for often. One of several pairs with one place here is remembered: no facet
  // is less than itself, so a pair of zeros is none.
  struct Known {
    std::uint64_t pair = 0;
    DepthRelation relation;
  };
  static constexpr int most_known_bits = 14;
  int known_bits_ = 0;
  std::vector<Known> known_;
  predicates::Counts counts_;
  std::uint64_t comparisons_ = 0;
};

}  // namespace sightline::inline sweep
