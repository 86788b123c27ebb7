#include "reflect/smooth/smooth_mirror.h"

#include <algorithm>
#include <cmath>

#include "reflect/world/uncut_facets.h"

namespace sightline::inline reflect {
namespace {

// A square halved so often is not divided further, nor one in which rounding to the grid moves a border by a share that
// matters: what dividing it changed last is in the statistics.
constexpr int most_divisions = 12;
constexpr std::int64_t enough_spacings = 256;

// Two regions that are alike by chance, or both empty, say little.
constexpr int fewest_divisions = 2;

// It is at least 2, so that its halves have a size.
std::int64_t smallest_size(int grid_bits) {
  return std::max(std::int64_t{2}, std::min(enough_spacings, (std::int64_t{1} << grid_bits) / 64));
}

// Closed rings that run counter-clockwise count positive. They are measured around the first place, to keep digits.
double area_of(const RegionBorder& border) {
  double twice = 0;
  for (const BorderSegment& segment : border) {
    const CrossingPoint& origin = border.front().start.at;
    const CrossingPoint& p = segment.start.at;
    const CrossingPoint& q = segment.end.at;
    twice += (p.x - origin.x) * (q.y - origin.y) - (p.y - origin.y) * (q.x - origin.x);
  }
  return twice / 2;
}

std::array<ImagePoint, 4> quarters(const ImagePoint& low, std::int64_t half) {
  return {low, ImagePoint{low.x + half, low.y}, ImagePoint{low.x, low.y + half},
          ImagePoint{low.x + half, low.y + half}};
}

// These are several polygons in one triangle.
struct Cover {
  std::vector<ImagePolygon> polygons;
  bool is_whole = false;  // one of them covers the triangle

  void add(LinearPart part) {
    is_whole = is_whole || part.is_whole;
    if (!part.polygon.empty()) polygons.push_back(std::move(part.polygon));
  }
};

// Returns what of the triangle is in the image but not in shadow.
RegionBorder lit_part(const RightTriangle& triangle, const Cover& image, const Cover& shadow, int grid_bits) {
  if (shadow.is_whole) return {};
  RegionBorder border = lit_region({ImagePolygon(triangle.begin(), triangle.end())}, {}, grid_bits);
  if (image.is_whole && shadow.polygons.empty()) return border;
  return common_part(border, lit_region(image.polygons, shadow.polygons, grid_bits));
}

void append(RegionBorder& border, const RegionBorder& more) { border.insert(border.end(), more.begin(), more.end()); }

}  // namespace

SmoothMirror::SmoothMirror(const MirrorWorld& world, const ProjectedScene& scene, FacetId surface)
    : world_(world),
      scene_(scene),
      normals_(*world.surface, world.normals, surface),
      rays_(scene.camera, normals_, plane_points(*world.surface, surface)[0], world.scale) {
  std::array<Point3, 3> plane = plane_points(*world.surface, surface);
  if (scene.facing[surface.index()] == FacetFacing::back) std::swap(plane[1], plane[2]);
  exact_plane_ = plane_through(plane);
  plane_form_ = plane_form(world.scale * plane[0], world.scale * plane[1], world.scale * plane[2]);
}

std::vector<std::size_t> SmoothMirror::panels_reached(const WindowPart& /*part*/) const {
  std::vector<std::size_t> all(world_.panels.size());
  for (std::size_t p = 0; p < all.size(); ++p) all[p] = p;
  return all;
}

RegionBorder SmoothMirror::reflecting(const RegionBorder& polygon, const WindowPart& part, std::size_t panel,
                                      ReflectionStatistics& statistics) {
  std::vector<PanelFace>& faces = faces_of(panel);
  if (faces.empty()) return {};
  Search search{polygon, PolygonOutline(polygon), faces, {}, statistics};
  for (const Square& square : squares_around(part)) divide(square, region(square, search), 0, search);
  return common_part(polygon, without_seams(std::move(search.border)));
}

// Returns the window's squares of the smallest size that is at least the part's: two of them reach beyond it in each
// direction.
std::vector<SmoothMirror::Square> SmoothMirror::squares_around(const WindowPart& part) const {
  const std::int64_t window = std::int64_t{1} << scene_.grid_bits;
  const double extent = std::ldexp(std::max(part.right - part.left, part.top - part.bottom), scene_.grid_bits);
  std::int64_t size = smallest_size(scene_.grid_bits);
  while (size < window && static_cast<double>(size) < extent) size *= 2;
  std::vector<Square> squares;
  const auto first = [&](double low) {
    const auto at = static_cast<std::int64_t>(std::floor(std::ldexp(low, scene_.grid_bits))) + window;
    return std::clamp(at / size * size - window, -window, window - size);
  };
  const std::int64_t left = first(part.left);
  const std::int64_t bottom = first(part.bottom);
  const auto end = [&](std::int64_t low) { return std::min(low + 2 * size, window); };
  for (std::int64_t y = bottom; y < end(bottom); y += size) {
    for (std::int64_t x = left; x < end(left); x += size) {
      squares.push_back({{x, y}, size});
    }
  }
  return squares;
}

void SmoothMirror::divide(const Square& square, const CellRegion& coarse, int divisions, Search& search) const {
  if (coarse.is_outside) return;
  const std::int64_t half = square.size / 2;
  std::array<CellRegion, 4> parts;
  const auto lows = quarters(square.low, half);
  double fine = 0;
  bool is_known = coarse.is_known;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    parts[i] = region({lows[i], half}, search);
    fine += parts[i].area;
    is_known = is_known && parts[i].is_known;
  }
  const double whole = static_cast<double>(square.size) * static_cast<double>(square.size);
  const double change = is_known ? std::fabs(fine - coarse.area) : whole;
  const bool may_divide = divisions < most_divisions && half > smallest_size(scene_.grid_bits);
  if (may_divide && (divisions < fewest_divisions || change > world_.options.tolerance * whole)) {
    for (std::size_t i = 0; i < parts.size(); ++i) divide({lows[i], half}, parts[i], divisions + 1, search);
    return;
  }
  for (const CellRegion& region : parts) append(search.border, region.border);
  search.statistics.looked_area += std::ldexp(whole, -2 * scene_.grid_bits);
  search.statistics.changed_area += std::ldexp(change, -2 * scene_.grid_bits);
}

SmoothMirror::CellRegion SmoothMirror::region(const Square& square, Search& search) const {
  CellRegion region;
  const SquarePlace place = search.outline.place_of(square.low, square.size);
  region.is_outside = place == SquarePlace::outside;
  if (region.is_outside) return region;
  ++search.statistics.pyramids;
  const MirrorCell cell(square.low, square.size, rays_, search.outline, scene_.grid_bits);
  region.is_known = cell.is_known();
  if (!region.is_known) return region;
  for (PanelFace& face : search.faces) append(region.border, reflected_in(cell, face, search.statistics));
  if (place == SquarePlace::across && !region.border.empty())
    region.border = common_part(search.polygon, region.border);
  region.area = area_of(region.border);
  return region;
}

RegionBorder SmoothMirror::reflected_in(const MirrorCell& cell, PanelFace& face,
                                        ReflectionStatistics& statistics) const {
  std::array<Cover, MirrorCell::halves> images;
  bool is_empty = true;
  for (std::size_t half = 0; half < images.size(); ++half) {
    for (const SpacePolygon& part : face.parts) images[half].add(cell.reflecting(half, part, face.side));
    is_empty = is_empty && images[half].polygons.empty();
  }
  RegionBorder border;
  if (is_empty) return border;
  const std::vector<const SpacePolygon*> obstacles = obstacles_before(cell, face, statistics);
  for (std::size_t half = 0; half < images.size(); ++half) {
    if (images[half].polygons.empty()) continue;
    Cover shadow;
    for (const SpacePolygon* obstacle : obstacles) {
      shadow.add(cell.reflecting(half, *obstacle, PolygonSide::front));
      shadow.add(cell.reflecting(half, *obstacle, PolygonSide::back));
    }
    statistics.blocked += shadow.polygons.empty() ? 0 : 1;
    append(border, lit_part(cell.half(half), images[half], shadow, scene_.grid_bits));
  }
  return border;
}

std::vector<const SmoothMirror::SpacePolygon*> SmoothMirror::obstacles_before(const MirrorCell& cell, PanelFace& face,
                                                                              ReflectionStatistics& statistics) const {
  const auto may_reach = [&](const Box& box) {
    const Box scaled{world_.scale * box.low, world_.scale * box.high};
    return plane_form_.highest(scaled) > 0 && cell.may_reach(scaled);
  };
  std::vector<const SpacePolygon*> result;
  const auto add = [&](const CutMesh& mesh, std::size_t number, UncutFacetId uncut) {
    ++statistics.obstacles;
    const SpacePolygon& obstacle = part_before(face, mesh, number, uncut);
    if (!obstacle.empty()) result.push_back(&obstacle);
  };
  for (const UncutFacetId uncut : world_.obstacles.in(may_reach)) add(*world_.surface, world_.panels.size(), uncut);
  for (std::size_t p = 0; p < world_.panels.size(); ++p) {
    if (p == face.panel || !may_reach(world_.panel_boxes[p])) continue;
    const CutMesh& mesh = world_.panel_meshes[p];
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) add(mesh, p, UncutFacetId(f));
  }
  return result;
}

// There are none where the panel has nothing before the mirror.
std::vector<SmoothMirror::PanelFace>& SmoothMirror::faces_of(std::size_t panel) {
  const auto [found, is_new] = faces_.try_emplace(panel);
  std::vector<PanelFace>& faces = found->second;
  if (!is_new) return faces;
  std::vector<SpacePolygon> parts;
  const CutMesh& mesh = world_.panel_meshes[panel];
  for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
    SpacePolygon part = scaled(part_in_front(uncut_polygon(mesh, UncutFacetId(f)), exact_plane_));
    if (!part.empty()) parts.push_back(std::move(part));
  }
  if (parts.empty()) return faces;
  const ExactPlane& plane = world_.panel_planes[panel];
  faces.push_back({panel, PolygonSide::front, plane, parts, {}});
  if (world_.panels[panel].emits == Emits::both)
    faces.push_back({panel, PolygonSide::back, plane.turned(), std::move(parts), {}});
  return faces;
}

const SmoothMirror::SpacePolygon& SmoothMirror::part_before(PanelFace& face, const CutMesh& mesh, std::size_t number,
                                                            UncutFacetId uncut) const {
  const auto [found, is_new] = face.obstacles.try_emplace({number, uncut});
  if (is_new)
    found->second = scaled(part_in_front(part_in_front(uncut_polygon(mesh, uncut), exact_plane_), face.plane));
  return found->second;
}

SmoothMirror::SpacePolygon SmoothMirror::scaled(const CutPolygon& polygon) const {
  SpacePolygon result;
  for (const CutCorner& corner : polygon) result.push_back(world_.scale * corner.position.rounded());
  return result;
}

}  // namespace sightline::inline reflect
