// One surface as a mirror: what of its visible polygons reflects a panel.
//
// In:  a surface in view (a planar face, or a facet), its visible polygons, the panels and what may be in the way.
// Out: per visible polygon and panel the border of the part that mirrors the panel into the camera. Exact in the image:
//      rounded are only the image points of panels and obstacles in the mirror, once, to the grid.
// Method: the panel as the camera sees it in the mirror (mirror_view.h), without what obstacles hide (lit_region.h),
//      and of that what lies in the visible polygon (overlay.h). An obstacle hides a panel where it is before the
//      panel's plane, seen from the mirror camera; other panels are obstacles, with both sides. Most polygons are done
//      with when their pyramid misses the panel, most others when it has no obstacle in it (pyramid.h).
// Source: Koucky 2014, 3.9 and figures 3.9 and 3.10. Departures: his obstacle test asks for vertices inside the
//      pyramid, and a triangle reflects wholly or not at all; here an obstacle is whatever reaches into the pyramid,
//      and the reflecting part is cut out.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "reconstruct/polygons/visible_polygons.h"
#include "reflect/exact/mirror_view.h"
#include "reflect/exact/pyramid.h"
#include "reflect/regions/lit_region.h"
#include "reflect/world/mirror_world.h"

namespace sightline::inline reflect {

class Mirror {
 public:
  Mirror(const MirrorWorld& world, const ProjectedScene& scene, FacetId surface);

  // Returns the panels that the pyramid through a part of the window may reach.
  [[nodiscard]] std::vector<std::size_t> panels_reached(const WindowPart& part) const;

  // `polygon` is the border of one of the surface's visible polygons, `part` a rectangle around it, and `panel` one
  // that is reached.
  [[nodiscard]] RegionBorder reflecting(const RegionBorder& polygon, const WindowPart& part, std::size_t panel,
                                        ReflectionStatistics& statistics);

 private:
  // A panel's image in the mirror is a list of convex polygons, with a rectangle around it; it is empty where it shows
  // nothing.
  struct PanelImage {
    std::vector<ImagePolygon> polygons;
    WindowPart part;
    ExactPlane towards_centre;  // the panel's plane, with the mirror camera in front
    BoundedForm towards_centre_form;
  };

  [[nodiscard]] const PanelImage& image_of(std::size_t panel);
  [[nodiscard]] std::vector<ImagePolygon> polygons_of(const CutMesh& panel);
  [[nodiscard]] std::vector<ImagePolygon> shadows(const WindowPart& part, std::size_t panel, const PanelImage& image,
                                                  ReflectionStatistics& statistics);
  [[nodiscard]] ImagePolygon shadow(const CutMesh& mesh, UncutFacetId obstacle, const PanelImage& image);
  [[nodiscard]] MirrorView& exact_view();

  const MirrorWorld& world_;
  const ProjectedScene& scene_;
  FacetId surface_;
  MirroredForms forms_;
  std::optional<MirrorView> view_;  // made where the forms do not suffice
  std::map<std::size_t, PanelImage> images_;
};

}  // namespace sightline::inline reflect
