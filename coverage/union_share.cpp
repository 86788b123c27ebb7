#include "coverage/union_share.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/mesh/box_hierarchy.h"
#include "geometry/mesh/facet_plane.h"
#include "reflect/regions/sheets.h"
#include "sweep/plain/sweep.h"
#include "sweep/segments/image_points.h"

namespace sightline::inline coverage {
namespace {

constexpr int grid_bits = default_grid_bits;

std::vector<SpaceTriangle> fans_of(const CutMesh& mesh, FacetId surface) {
  std::vector<SpaceTriangle> triangles;
  for (FacetId f = surface; f < end_of_surface(mesh, surface); f = FacetId(f.index() + 1)) {
    const auto corners = mesh.corners(f);
    for (std::size_t i = 2; i < corners.size(); ++i)
      triangles.push_back({mesh.position(corners[0]), mesh.position(corners[i - 1]), mesh.position(corners[i])});
  }
  return triangles;
}

Box bounds(std::span<const SpaceTriangle> triangles) {
  Box box{triangles[0][0], triangles[0][0]};
  for (const SpaceTriangle& triangle : triangles) {
    for (const Point3& p : triangle) box = hull(box, {p, p});
  }
  return box;
}

// An axis takes a coordinate to the grid; [low, high] fills the window. It works with halves, so that no difference
// overflows; a corner that rounding has moved out of the rectangle goes back to its border.
struct Axis {
  double low = 0;
  double high = 0;

  [[nodiscard]] double half_extent() const { return 0.5 * high - 0.5 * low; }
  // The share is in [0, 1].
  [[nodiscard]] double share(double coordinate) const {
    if (!(low < high)) return 0;
    const double factor = std::max(-low, high) > 1 ? 0.5 : 1;
    const double within = std::clamp(coordinate, low, high);
    return (factor * within - factor * low) / (factor * high - factor * low);
  }
  [[nodiscard]] std::int64_t on_grid(double coordinate) const {
    return std::llround(std::ldexp(2 * share(coordinate) - 1, grid_bits));
  }
};

using Axes = std::array<Axis, 3>;

Axes axes_of(std::span<const SpaceTriangle> surface) {
  const Box box = bounds(surface);
  return {Axis{box.low.x(), box.high.x()}, Axis{box.low.y(), box.high.y()}, Axis{box.low.z(), box.high.z()}};
}

// Returns the triangle's image, seen along the axis `along`.
ImagePolygon image(const Axes& axes, std::size_t along, const SpaceTriangle& triangle) {
  const std::size_t x = (along + 1) % 3;
  const std::size_t y = (along + 2) % 3;
  ImagePolygon polygon;
  for (const Point3& p : triangle) {
    const std::array at{p.x(), p.y(), p.z()};
    polygon.push_back({axes[x].on_grid(at[x]), axes[y].on_grid(at[y])});
  }
  return polygon;
}

// Returns twice the area, in window units squared, of triangles that do not overlap.
double twice_area_seen(const Axes& axes, std::size_t along, std::span<const SpaceTriangle> triangles) {
  Int128 sum = 0;
  for (const SpaceTriangle& triangle : triangles) {
    const ImagePolygon polygon = image(axes, along, triangle);
    const Int128 area = twice_area(polygon[0], polygon[1], polygon[2]);
    sum += area < 0 ? -area : area;
  }
  return std::ldexp(static_cast<double>(sum), -2 * grid_bits);
}

// Returns the axis along which the surface is seen largest, in space: across the others, what rounding has done to the
// corners in space would be stretched with the rectangle.
std::size_t best_axis(const Axes& axes, std::span<const SpaceTriangle> surface) {
  const double longest = std::max({axes[0].half_extent(), axes[1].half_extent(), axes[2].half_extent()});
  std::array<double, 3> sizes{};
  for (std::size_t along = 0; along < 3; ++along) {
    const double width = axes[(along + 1) % 3].half_extent() / longest;
    const double height = axes[(along + 2) % 3].half_extent() / longest;
    sizes[along] = width * height * twice_area_seen(axes, along, surface);
  }
  return static_cast<std::size_t>(std::ranges::max_element(sizes) - sizes.begin());
}

// Returns twice the area, in window units squared, of what is seen: it is a sum over its directed border.
double twice_area_of(const ProjectedScene& scene, const VisibleSegments& segments) {
  const ImagePoints points(scene, segments);
  double sum = 0;
  for (const VisibleSegment& segment : segments.segments) {
    const Point2 p = points.in_window(segment.start);
    const Point2 q = points.in_window(segment.end);
    sum += p.x * q.y - p.y * q.x;
  }
  return sum;
}

}  // namespace

UnionShare union_share(const CutMesh& mesh, FacetId surface, std::span<const SpaceTriangle> triangles) {
  const std::vector<SpaceTriangle> whole = fans_of(mesh, surface);
  const Axes axes = axes_of(whole);
  const std::size_t along = best_axis(axes, whole);
  const double twice_whole = twice_area_seen(axes, along, whole);
  if (!(twice_whole > 0)) return {0, std::numeric_limits<double>::infinity()};
  Sheets sheets(grid_bits);
  for (const SpaceTriangle& triangle : triangles) sheets.add(image(axes, along, triangle), 0);
  const ProjectedScene scene = project(sheets.mesh(), straight_down(), Sides::both, {Arithmetic::exact, grid_bits});
  const auto count = static_cast<double>(triangles.size() + whole.size());
  return {twice_area_of(scene, plain_sweep(scene)) / twice_whole, 0x1p-37 * count / (twice_whole / 2)};
}

}  // namespace sightline::inline coverage
