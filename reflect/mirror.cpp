#include "reflect/mirror.h"

#include <algorithm>
#include <cmath>

namespace sightline {
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

}  // namespace

Mirror::Mirror(const MirrorWorld& world, const ProjectedScene& scene, FacetId surface)
    : world_(world), scene_(scene), plane_(plane_points(*world.surface, surface)) {
  if (scene.facing[surface.index()] == Facing::back) std::swap(plane_[1], plane_[2]);
}

std::vector<std::size_t> Mirror::panels_reached(const WindowPart& part) const {
  const Pyramid pyramid(scene_.camera, plane_, widened(part, scene_.grid_bits));
  std::vector<std::size_t> reached;
  for (std::size_t p = 0; p < world_.panels.size(); ++p) {
    if (pyramid.may_touch(world_.panel_boxes[p])) reached.push_back(p);
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

const Mirror::PanelImage& Mirror::image_of(std::size_t panel) {
  const auto [found, is_new] = images_.try_emplace(panel);
  PanelImage& image = found->second;
  if (!is_new) return image;
  if (!view_) view_.emplace(scene_.camera, plane_through(plane_), scene_.grid_bits);
  const ExactPlane& plane = world_.panel_planes[panel];
  const Sign side = view_->side_of_centre(plane);
  if (side == 0 || (side < 0 && world_.panels[panel].emits == Emits::front)) return image;
  image.towards_centre = side > 0 ? plane : plane.turned();
  const Mesh& mesh = world_.panel_meshes[panel];
  for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
    ImagePolygon polygon = view_->image(whole_polygon(mesh, WholeId(f)));
    if (!polygon.empty()) image.polygons.push_back(std::move(polygon));
  }
  image.part = around(image.polygons, scene_.grid_bits);
  return image;
}

std::vector<ImagePolygon> Mirror::shadows(const WindowPart& part, std::size_t panel, const PanelImage& image,
                                          ReflectionStatistics& statistics) const {
  const Pyramid pyramid(scene_.camera, plane_, widened(part, scene_.grid_bits));
  std::vector<ImagePolygon> shadows;
  for (const WholeId obstacle : world_.obstacles.in([&](const Box& box) { return pyramid.may_touch(box); })) {
    ++statistics.obstacles;
    add_shadow(shadows, whole_polygon(*world_.surface, obstacle), image);
  }
  for (std::size_t p = 0; p < world_.panels.size(); ++p) {
    if (p == panel || !pyramid.may_touch(world_.panel_boxes[p])) continue;
    for (std::size_t f = 0; f < world_.panel_meshes[p].facet_count(); ++f) {
      ++statistics.obstacles;
      add_shadow(shadows, whole_polygon(world_.panel_meshes[p], WholeId(f)), image);
    }
  }
  statistics.blocked += shadows.empty() ? 0 : 1;
  return shadows;
}

void Mirror::add_shadow(std::vector<ImagePolygon>& shadows, const CutPolygon& obstacle, const PanelImage& image) const {
  const CutPolygon before_panel = part_in_front(obstacle, image.towards_centre);
  if (before_panel.empty()) return;
  ImagePolygon shadow = view_->image(before_panel);
  if (!shadow.empty()) shadows.push_back(std::move(shadow));
}

}  // namespace sightline
