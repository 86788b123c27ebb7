// Swap edges: the lines of the image along which two surfaces that pass through each other change places.
//
// In:  an unrounded scene; pairs of facets, as somebody asks for them.
// Out: per pair of surfaces a line, directed downwards like an edge of the scene, and which of both is nearer on its right.
// A pair may be asked for whose facets overlap beside and behind the camera, too.
// Method: how near a plane is to the eye (1 / W of a pinhole camera, minus the depth otherwise) is a linear form of the
//      homogeneous place (x, y, w), found from three corners. Where two forms are equal, the planes meet; so the line is the
//      difference of the forms, and its sign says who is nearer.
// Complexity: O(1) per pair, in integers of any size, once.
// Source: docs/design.md, section 9.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "sweep/unrounded/unrounded_scene.h"

namespace sightline::inline sweep {

struct SwapEdge {
  std::array<FacetId, 2> surfaces;  // smaller id first (facet_plane.h)
  ExactLine line;
  double a = 0, b = 0, c = 0;  // the line with its largest coefficient 1, each off by at most 2^-53
  Sign first_nearer = 0;       // +1 where the first surface is nearer on the right of the line
  // False where the planes meet in the camera's own plane, which the image does not show: then first_nearer is said of all of
  // the image.
  bool is_seen = true;
};

class SwapEdges {
 public:
  explicit SwapEdges(const UnroundedScene& scene) : scene_(scene) {}

  // Ids follow those of the scene's edges.
  [[nodiscard]] bool is_one(EdgeId e) const { return e.index() >= scene_.scene.edge_count(); }
  [[nodiscard]] const SwapEdge& operator[](EdgeId e) const { return edges_[e.index() - scene_.scene.edge_count()]; }
  [[nodiscard]] std::size_t size() const { return edges_.size(); }

  // Returns the edge of two facets' surfaces. Precondition: these pass through each other.
  [[nodiscard]] EdgeId between(FacetId f, FacetId g);

  // Returns +1 where the facet, of one of the edge's surfaces, is the nearer one on the right of the edge, -1 where on its
  // left.
  [[nodiscard]] Sign nearer_side(EdgeId e, FacetId f) const;

 private:
  // (a x + b y + c w) / k says how near the plane is; k > 0.
  struct Nearness {
    BigInteger a, b, c, k;
  };
  [[nodiscard]] const Nearness& nearness(FacetId surface);
  [[nodiscard]] SwapEdge made(FacetId f, FacetId g);

  const UnroundedScene& scene_;
  std::vector<SwapEdge> edges_;
  std::map<std::array<FacetId, 2>, EdgeId> known_;
  std::map<FacetId, Nearness> nearness_;
};

}  // namespace sightline::inline sweep
