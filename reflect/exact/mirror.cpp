#include "reflect/exact/mirror.h"

#include <algorithm>
#include <cmath>

#include "reflect/world/uncut_facets.h"

namespace sightline::inline reflect {
namespace {

// Grid coordinates are exact in double, and so is their share of the half window.
WindowPart around(const std::vector<ImagePolygon>& polygons, int grid_bits) {
  const auto coordinate = [grid_bits](std::int64_t grid) { return std::ldexp(static_cast<double>(grid), -grid_bits); };
  WindowPart part{1, -1, 1, -1};
  for (const ImagePolygon& polygon : polygons) {
    for (const ImagePoint& p : polygon) {
      part.left = std::min(part.left, coordinate(p.x));
      part.right = std::max(part.right, coordinate(p.x));
      part.bottom = std::min(part.bottom, coordinate(p.y));
      part.top = std::max(part.top, coordinate(p.y));
    }
  }
  return part;
}

// Rounding moves a panel's or a shadow's border by up to half a spacing: what reaches into the widened part counts.
WindowPart widened(const WindowPart& part, int grid_bits) {
  const double spacing = std::ldexp(1.0, -grid_bits);
  return {part.left - spacing, part.right + spacing, part.bottom - spacing, part.top + spacing};
}

std::vector<Point3> corners_of(const CutMesh& mesh, UncutFacetId uncut) {
  std::vector<Point3> corners;
  for (const VertexId v : mesh.uncut_corners(uncut)) corners.push_back(mesh.position(v));
  return corners;
}

void add_if_any(std::vector<ImagePolygon>& polygons, ImagePolygon polygon) {
  if (!polygon.empty()) polygons.push_back(std::move(polygon));
}

}  // namespace

Mirror::Mirror(const MirrorWorld& world, const ProjectedScene& scene, FacetId surface)
    : world_(world), scene_(scene), surface_(surface) {
  std::array<Point3, 3> plane = plane_points(*world.surface, surface);
  if (scene.facing[surface.index()] == FacetFacing::back) std::swap(plane[1], plane[2]);
  forms_ = mirrored_forms(scene.camera, plane);
}

std::vector<std::size_t> Mirror::panels_reached(const WindowPart& part) const {
  const Pyramid pyramid(forms_, widened(part, scene_.grid_bits));
  std::vector<std::size_t> reached;
  for (std::size_t p = 0; p < world_.panels.size(); ++p) {
    if (pyramid.may_touch(world_.panel_boxes[p]) && !world_.is_snapped_surface(p, surface_)) reached.push_back(p);
  }
  return reached;
}

RegionBorder Mirror::reflecting(const RegionBorder& polygon, const WindowPart& part, std::size_t panel,
                                ReflectionStatistics& statistics) {
  ++statistics.pyramids;
  const PanelImage& image = image_of(panel);
  const WindowPart common = common_part(part, image.part);
  if (image.polygons.empty() || common.is_empty()) return {};
  return common_part(polygon, lit_region(image.polygons, shadows(common, panel, image, statistics), scene_.grid_bits));
}

MirrorView& Mirror::exact_view() {
  if (!view_) view_.emplace(scene_.camera, plane_through(forms_.plane), scene_.grid_bits);
  return *view_;
}

const Mirror::PanelImage& Mirror::image_of(std::size_t panel) {
  const auto [found, is_new] = images_.try_emplace(panel);
  PanelImage& image = found->second;
  if (!is_new) return image;
  const CutMesh& mesh = world_.panel_meshes[panel];
  const ExactPlane& plane = world_.panel_planes[panel];
  const BoundedForm form = bounded_form(panel_plane(mesh));
  const auto certain = certain_side_of_centre(forms_, scene_.camera, form);
  const Sign side = certain ? *certain : exact_view().side_of_centre(plane);
  if (side == 0 || (side < 0 && world_.panels[panel].emits == Emits::front)) return image;
  image.towards_centre = side > 0 ? plane : plane.turned();
  image.towards_centre_form = side > 0 ? form : -form;
  image.polygons = polygons_of(mesh);
  image.part = around(image.polygons, scene_.grid_bits);
  return image;
}

std::vector<ImagePolygon> Mirror::polygons_of(const CutMesh& panel) {
  std::vector<ImagePolygon> polygons;
  for (std::size_t f = 0; f < panel.facet_count(); ++f) {
    auto polygon = certain_image(forms_, scene_.camera, corners_of(panel, UncutFacetId(f)), scene_.grid_bits);
    add_if_any(polygons, polygon ? *std::move(polygon) : exact_view().image(uncut_polygon(panel, UncutFacetId(f))));
  }
  return polygons;
}

std::vector<ImagePolygon> Mirror::shadows(const WindowPart& part, std::size_t panel, const PanelImage& image,
                                          ReflectionStatistics& statistics) {
  const Pyramid pyramid(forms_, widened(part, scene_.grid_bits));
  std::vector<ImagePolygon> shadows;
  for (const UncutFacetId obstacle : world_.obstacles.in([&](const Box& box) { return pyramid.may_touch(box); })) {
    if (world_.is_snapped(panel, obstacle) || world_.is_snapped_to_mirror(surface_, obstacle)) continue;
    ++statistics.obstacles;
    add_if_any(shadows, shadow(*world_.surface, obstacle, image));
  }
  for (std::size_t p = 0; p < world_.panels.size(); ++p) {
    if (p == panel || world_.is_in_plane(panel, p) || world_.is_snapped_surface(p, surface_)) continue;
    if (!pyramid.may_touch(world_.panel_boxes[p])) continue;
    for (std::size_t f = 0; f < world_.panel_meshes[p].facet_count(); ++f) {
      ++statistics.obstacles;
      add_if_any(shadows, shadow(world_.panel_meshes[p], UncutFacetId(f), image));
    }
  }
  for (const std::size_t p : world_.panels_over[panel]) {
    for (ImagePolygon& over : polygons_of(world_.panel_meshes[p])) shadows.push_back(std::move(over));
  }
  statistics.blocked += shadows.empty() ? 0 : 1;
  return shadows;
}

// Most facets in a pyramid are the mirror's neighbours, and no corner of theirs is in front of it. Of the others certified numbers decide
// nearly always.
ImagePolygon Mirror::shadow(const CutMesh& mesh, UncutFacetId obstacle, const PanelImage& image) {
  const std::vector<Point3> corners = corners_of(mesh, obstacle);
  if (std::ranges::none_of(corners, [&](const Point3& corner) {
        return orient3d(forms_.plane[0], forms_.plane[1], forms_.plane[2], corner) > 0;
      }))
    return {};
  if (image.towards_centre_form.is_positive_at(corners)) {
    if (auto certain = certain_image(forms_, scene_.camera, corners, scene_.grid_bits)) return *std::move(certain);
  }
  const CutPolygon before_panel = part_in_front(uncut_polygon(mesh, obstacle), image.towards_centre);
  return before_panel.empty() ? ImagePolygon{} : exact_view().image(before_panel);
}

}  // namespace sightline::inline reflect
