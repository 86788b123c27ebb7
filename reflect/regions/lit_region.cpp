#include "reflect/regions/lit_region.h"

#include <algorithm>

#include "sweep/plain/sweep.h"

namespace sightline::inline reflect {
namespace {

ImageLine line_between(const ImagePoint& p, const ImagePoint& q) {
  return sweeps_before(p, q) ? ImageLine{p, q, nullptr, {}} : ImageLine{q, p, nullptr, {}};
}

// Returns twice the signed area.
Int128 twice_area(const ImagePolygon& polygon) {
  Int128 sum = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) sum += twice_area(polygon[0], polygon[i], polygon[i + 1]);
  return sum;
}

// The border is added counter-clockwise.
void add_border(RegionBorder& border, ImagePolygon polygon) {
  if (twice_area(polygon) < 0) std::ranges::reverse(polygon);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    border.push_back(border_segment(polygon[i], polygon[i + 1 == polygon.size() ? 0 : i + 1]));
  }
}

}  // namespace

BorderSegment border_segment(const ImagePoint& start, const ImagePoint& end) {
  return {grid_place(start), grid_place(end), line_between(start, end)};
}

BorderSegment border_segment(const ImagePoints& image, const VisibleSegment& segment) {
  return {image_place(image, segment.start), image_place(image, segment.end), image_line(image, segment.edge)};
}

RegionBorder lit_region(const std::vector<ImagePolygon>& panel, const std::vector<ImagePolygon>& shadows,
                        int grid_bits) {
  RegionBorder border;
  if (shadows.empty()) {
    for (const ImagePolygon& polygon : panel) add_border(border, polygon);
    return border;
  }
  Sheets sheets(grid_bits);
  for (const ImagePolygon& polygon : panel) sheets.add(polygon, 0);
  const std::size_t lit = sheets.count();
  for (const ImagePolygon& polygon : shadows) sheets.add(polygon, 1);
  const ProjectedScene scene = project(sheets.mesh(), straight_down(), Sides::both, {Arithmetic::exact, grid_bits});
  const VisibleSegments segments = plain_sweep(scene);
  const ImagePoints image(scene, segments);
  for (const VisibleSegment& segment : segments.segments) {
    if (scene.mesh().facet_face[segment.facet.index()].index() < lit) border.push_back(border_segment(image, segment));
  }
  return border;
}

}  // namespace sightline::inline reflect
