// A surface that can be projected and swept: on a grid one whose facets do not pass through each other; without rounding any.
//
// In:  a mesh cut along the common lines of its facets (cut_along_common_lines), or one that is taken as it is
//      (uncrossed).
// Holds (validate(mesh) checks it): what holds of a Mesh holds here for exact positions. The vertices that cutting made
//      are known exactly, and `vertices` has them rounded once. Faces and the input's vertices keep their numbers.
#pragma once

#include "geometry/mesh/mesh.h"
#include "geometry/numbers/exact_position.h"
#include "geometry/numbers/export.h"

namespace sightline::inline geometry {

// The cuts are what is known of the uncut facets. All of it is empty where nothing was cut, but for `outside_frame`.
struct FacetCuts {
  std::vector<ExactPosition> points;         // the exact positions of the vertices behind those of the input
  PolygonList uncut_facets;                  // the facets before, all of them; corners are the input's vertices
  std::vector<UncutFacetId> uncut_facet_of;  // per facet
  std::vector<FacetId> first_facet;          // per uncut facet, and one past the end
  std::vector<std::array<UncutFacetId, 2>> crossing;  // those that pass through each other: smaller id first; sorted
  // Per mesh edge: the ends of the input's edge that it is on; invalid where it lies on a common line.
  std::vector<std::array<VertexId, 2>> input_edge;
  // Per facet: whether it lies outside the frame of the camera for which the mesh was cut (frame_cut.h); else empty.
  std::vector<std::uint8_t> outside_frame;
};

struct CutMesh : PolygonMesh {
  FacetCuts cuts;
  // Per uncut facet the one whose plane is its own in the order of depth, so that both are coplanar there (snapped_planes.h);
  // empty where nothing is snapped. In everything else a facet has its own plane.
  std::vector<UncutFacetId> snapped_to;

  [[nodiscard]] bool is_cut() const { return !cuts.uncut_facet_of.empty(); }
  [[nodiscard]] std::size_t input_vertex_count() const { return vertices.size() - cuts.points.size(); }

  // An uncut facet is a facet as it was before cutting. Where nothing was cut these are the facets, by the same numbers.
  [[nodiscard]] std::size_t uncut_facet_count() const { return is_cut() ? cuts.uncut_facets.size() : facets.size(); }
  [[nodiscard]] UncutFacetId uncut_facet(FacetId f) const {
    return is_cut() ? cuts.uncut_facet_of[f.index()] : UncutFacetId(f.index());
  }
  [[nodiscard]] std::span<const VertexId> uncut_corners(UncutFacetId u) const {
    return is_cut() ? cuts.uncut_facets[u.index()] : corners(FacetId(u.index()));
  }
  [[nodiscard]] UncutFacetId plane_of(UncutFacetId u) const { return snapped_to.empty() ? u : snapped_to[u.index()]; }
  [[nodiscard]] bool is_snapped(UncutFacetId u) const { return plane_of(u) != u; }
  // The pieces of an uncut facet are consecutive: [first_piece, end_piece).
  [[nodiscard]] FacetId first_piece(UncutFacetId u) const {
    return is_cut() ? cuts.first_facet[u.index()] : FacetId(u.index());
  }
  [[nodiscard]] FacetId end_piece(UncutFacetId u) const {
    return is_cut() ? cuts.first_facet[u.index() + 1] : FacetId(u.index() + 1);
  }
};

// Returns the mesh as it is: to be swept without rounding; or, on a grid, by a caller who knows that none of its facets pass
// through each other, or who accepts that where they do the wrong facet is on top in places.
[[nodiscard]] SIGHTLINE_EXPORT CutMesh uncrossed(Mesh mesh);

// Returns the exact position of a vertex, whether it is the input's or made by cutting.
[[nodiscard]] SIGHTLINE_EXPORT ExactPosition exact_position(const CutMesh& mesh, VertexId v);

// Returns whether three vertices lie on one line, exactly.
[[nodiscard]] SIGHTLINE_EXPORT bool collinear(const CutMesh& mesh, VertexId a, VertexId b, VertexId c);

// Returns what of the above does not hold, one line each, with the ids; empty for a valid mesh.
[[nodiscard]] SIGHTLINE_EXPORT std::vector<std::string> validate(const CutMesh& mesh);

}  // namespace sightline::inline geometry
