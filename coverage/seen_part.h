// A seen part is all that coverage (coverage.h) keeps of a view: what of the labelled surface is seen, and mirrors which
// panels.
//
// In:  the labelled surface of one camera. Out: per surface (surface_of in facet_plane.h) of which something is seen,
//      its triangles that are seen.
// Holds: surfaces are sorted; triangles are by surface.
// Memory: 32 bytes for each surface that is seen, and 80 for each of its triangles that are seen; but none of them
//      where all of it is seen and mirrors the same panels, as most surfaces do. The labelled surface itself can go.
// Complexity: O(n).
#pragma once

#include <span>
#include <vector>

#include "coverage/union_share.h"
#include "geometry/numbers/export.h"
#include "reconstruct/labelling/labelled_mesh.h"

namespace sightline::inline coverage {

struct SeenTriangle {
  SpaceTriangle corners;
  std::uint64_t reflecting = 0;  // bit p: it mirrors panel p into the camera
};

struct SeenSurface {
  FacetId surface;
  std::uint32_t first_triangle = 0;
  std::uint64_t reflecting_everywhere = 0;  // bit p: all of it mirrors panel p
  std::uint64_t reflecting_somewhere = 0;   // bit p: some of it does
  bool seen_everywhere = false;
};

struct SeenPart {
  std::vector<SeenSurface> surfaces;
  std::vector<SeenTriangle> triangles;

  // Returns the triangles of surfaces[i]; there are none where every panel is mirrored everywhere or nowhere on it, and
  // all of it is seen.
  [[nodiscard]] std::span<const SeenTriangle> triangles_of(std::size_t i) const {
    const std::size_t first = surfaces[i].first_triangle;
    const std::size_t end = i + 1 < surfaces.size() ? surfaces[i + 1].first_triangle : triangles.size();
    return std::span(triangles).subspan(first, end - first);
  }
};

[[nodiscard]] SIGHTLINE_EXPORT SeenPart seen_part(const LabelledMesh& labelled);

// The same of a view's labelled surface and its mesh, which was cut where the camera has a lens: surfaces are called as before,
// as those of the other cameras.
[[nodiscard]] SIGHTLINE_EXPORT SeenPart seen_part(const LabelledMesh& labelled, const CutMesh& mesh);

}  // namespace sightline::inline coverage
