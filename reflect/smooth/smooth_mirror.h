// One surface as a bent mirror: what of its visible polygons reflects a panel, with interpolated vertex normals.
//
// In:  a surface in view, its visible polygons, a world with normals; how much may stay uncertain.
// Out: per visible polygon and panel the part that mirrors the panel into the camera (polygon_reflection.h): a model of the smooth surface
//      that the mesh stands for. A flat mirror's is that of mirror.h, but for rounding. With it comes how much of it may be
//      wrong: a bound, as all that is approximate has one (lit_cells.h). Where no ray is known to meet the panel, nothing is lit.
// Method: what a mirrored ray meets is told by signs of polynomials (bent_mirror.h). A ray starts on the flat face, and what does
//      not rise from it is blocked by it; so what has no corner above the face's plane, exactly, is in no ray's way. Where the surface is
//      closed only fronts are (closed_surface.h).
// Floating point with bounds, but for putting the parts together, which is exact (overlay.h): whatever the rounding, the borders
// are those of a part of the polygon.
// Complexity: O(1) per panel and obstacle in the way of the surface's rays, then that of lit_cells.h.
// Source: Koucky 2014, 3.9 (vertex normals). He has a yes or no per triangle; cutting within it is this project's.
// Rejected: squares of the image, with rays at their corners taken as linear in between, halved until that changed little.
//      It could not say what it missed: faces narrower than a square, and obstacles that rounding put a last bit in front of the
//      mirror, whose shadows were noise and were divided without end.
#pragma once

#include "reflect/smooth/polygon_reflection.h"
#include "reflect/smooth/smooth_patches.h"
#include "reflect/world/mirror_world.h"

namespace sightline::inline reflect {

class SmoothMirror {
 public:
  SmoothMirror(const MirrorWorld& world, const ProjectedScene& scene, FacetId surface);

  // `polygon` is the border of one of the surface's visible polygons. Returns nothing where no ray meets the panel.
  [[nodiscard]] std::optional<PolygonReflection> look_at(const RegionBorder& polygon, std::size_t panel,
                                                         const CellPrecision& precision,
                                                         ReflectionStatistics& statistics) const;

 private:
  // One emitting side of a panel.
  struct PanelSide {
    std::size_t panel = 0;
    bool from_front = true;
  };

  [[nodiscard]] std::vector<PanelSide> sides_of(std::size_t panel) const;
  [[nodiscard]] LitCell cell_of(const SmoothPatch& patch, const ImageTriangle& cover, const PanelSide& side,
                                ReflectionStatistics& statistics) const;
  void add_images(const BentMirror& mirror, const PanelSide& side, std::vector<ConvexPart>& images) const;
  [[nodiscard]] std::vector<ConvexPart> shadows(const BentMirror& mirror, const RayBeam& beam, const PanelSide& panel,
                                                ReflectionStatistics& statistics) const;
  [[nodiscard]] bool is_closed_before(std::size_t panel) const;
  [[nodiscard]] bool is_in_the_way(const CutMesh& mesh, UncutFacetId facet, const PanelSide& side) const;

  const MirrorWorld& world_;
  const ProjectedScene& scene_;
  FacetId surface_;
  std::array<Point3, 3> plane_;  // of the surface, seen counter-clockwise by the eye
  std::vector<SmoothPatch> patches_;
};

}  // namespace sightline::inline reflect
