// One surface as a bent mirror: what of its visible polygons reflects a panel, with interpolated vertex normals.
//
// In:  a surface in view, its visible polygons, a world with normals.
// Out: per visible polygon and panel the border of the part that mirrors the panel into the camera, up to the world's
//      tolerance: a model of the smooth surface that the mesh stands for. A flat mirror's is that of mirror.h, but for
//      rounding.
// Method: squares of the image that the polygon reaches, halved until dividing them once more changes the area of the
//      polygon that reflects in them by no more than the tolerance (a share of their own area). In each, rays are
//      traced at its corners, and what they do is taken as linear in between (mirror_cell.h): what meets the panel is
//      cut out, and so is what obstacles before it hide. A ray starts on the flat face, and what does not rise from it
//      is blocked by it.
// Floating point, but for putting the parts together, which is exact (overlay.h): whatever the rounding, the borders
// are those of a part of the polygon.
// Complexity: O(1) per square and panel, and obstacle in its way.
// Source: Koucky 2014, 3.9 (vertex normals). He has a yes or no per triangle; cutting within it is this project's.
#pragma once

#include <map>

#include "geometry/cutting/facet_cutter.h"
#include "reflect/exact/pyramid.h"
#include "reflect/regions/polygon_outline.h"
#include "reflect/smooth/mirror_cell.h"
#include "reflect/world/mirror_world.h"

namespace sightline::inline reflect {

class SmoothMirror {
 public:
  SmoothMirror(const MirrorWorld& world, const ProjectedScene& scene, FacetId surface);

  // Returns the panels that may be reflected: all of them.
  [[nodiscard]] std::vector<std::size_t> panels_reached(const WindowPart& part) const;

  // `polygon` is the border of one of the surface's visible polygons, `part` a rectangle around it.
  [[nodiscard]] RegionBorder reflecting(const RegionBorder& polygon, const WindowPart& part, std::size_t panel,
                                        ReflectionStatistics& statistics);

 private:
  struct Square {
    ImagePoint low;
    std::int64_t size = 0;
  };
  struct CellRegion {
    RegionBorder border;
    double area = 0;  // in grid units squared
    bool is_known = true;
    bool is_outside = false;  // no part of the polygon is here
  };
  using SpacePolygon = std::vector<Point3>;

  // This is one emitting side of a panel, with what has been found to be in its way.
  struct PanelFace {
    std::size_t panel = 0;
    PolygonSide side = PolygonSide::front;
    ExactPlane plane;                 // with the emitting side in front
    std::vector<SpacePolygon> parts;  // what of it is before the mirror
    // Each obstacle has what of it is before the mirror and the panel. It is named by the number of its panel, or by
    // that behind the last one for the surface.
    std::map<std::pair<std::size_t, UncutFacetId>, SpacePolygon> obstacles;
  };

  // A search is for one polygon and panel.
  struct Search {
    const RegionBorder& polygon;
    const PolygonOutline outline;
    std::vector<PanelFace>& faces;
    RegionBorder border;  // of what has been found
    ReflectionStatistics& statistics;
  };

  [[nodiscard]] std::vector<Square> squares_around(const WindowPart& part) const;
  void divide(const Square& square, const CellRegion& coarse, int divisions, Search& search) const;
  [[nodiscard]] CellRegion region(const Square& square, Search& search) const;
  [[nodiscard]] RegionBorder reflected_in(const MirrorCell& cell, PanelFace& face,
                                          ReflectionStatistics& statistics) const;
  [[nodiscard]] std::vector<const SpacePolygon*> obstacles_before(const MirrorCell& cell, PanelFace& face,
                                                                  ReflectionStatistics& statistics) const;
  [[nodiscard]] std::vector<PanelFace>& faces_of(std::size_t panel);
  [[nodiscard]] const SpacePolygon& part_before(PanelFace& face, const CutMesh& mesh, std::size_t number,
                                                UncutFacetId uncut) const;
  [[nodiscard]] SpacePolygon scaled(const CutPolygon& polygon) const;

  const MirrorWorld& world_;
  const ProjectedScene& scene_;
  ExactPlane exact_plane_;  // of the surface, with the eye in front
  PlaneForm plane_form_;    // the same, scaled
  ShadingNormals normals_;
  SmoothRays rays_;
  std::map<std::size_t, std::vector<PanelFace>> faces_;  // per panel, once for all polygons of the surface
};

}  // namespace sightline::inline reflect
