#include "reflect/smooth/polygon_reflection.h"

#include <algorithm>

#include "reflect/regions/lit_region.h"

namespace sightline::inline reflect {
namespace {

// Where a level line crosses a region, the widest stretch of it that is inside; none where rounding leaves none.
struct Stretch {
  Point2 middle;
  double width = 0;
};

Stretch widest_stretch(const RegionBorder& border, double y) {
  std::vector<std::pair<double, int>> crossings;
  for (const BorderSegment& s : border) {
    const CrossingPoint& p = s.start.at;
    const CrossingPoint& q = s.end.at;
    if ((p.y > y) != (q.y > y)) crossings.emplace_back(p.x + (y - p.y) / (q.y - p.y) * (q.x - p.x), p.y > y ? 1 : -1);
  }
  std::ranges::sort(crossings);
  Stretch widest;
  int winding = 0;
  for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
    winding += crossings[i].second;
    const double width = crossings[i + 1].first - crossings[i].first;
    if (winding > 0 && width > widest.width) widest = {{crossings[i].first + width / 2, y}, width};
  }
  return widest;
}

RegionBorder inside_half_planes(RegionBorder border, const std::vector<ImagePolygon>& half_planes, int grid_bits) {
  for (const ImagePolygon& half_plane : half_planes) {
    if (border.empty() || half_plane.size() < 3) return {};
    border = common_part(lit_region({half_plane}, {}, grid_bits), border);
  }
  return border;
}

}  // namespace

// They are measured around the first place, to keep digits.
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

PolygonReflection::PolygonReflection(const RegionBorder& polygon) : outline_(polygon), area_(area_of(polygon)) {}

void PolygonReflection::add(std::vector<LitCell> covers, const std::vector<ImagePolygon>& half_planes,
                            bool may_be_whole, const CellPrecision& precision) {
  PatchCells patch{{}, half_planes, may_be_whole};
  for (LitCell& cover : covers) patch.cells.add(std::move(cover), outline_, precision);
  patches_.push_back(std::move(patch));
}

void PolygonReflection::divide(const CellPrecision& precision) {
  for (PatchCells& patch : patches_) patch.cells.divide(outline_, precision);
}

bool PolygonReflection::is_dark() const {
  return std::ranges::all_of(patches_, [](const PatchCells& patch) { return patch.cells.cells().empty(); });
}

bool PolygonReflection::is_whole() const {
  return std::ranges::any_of(
      patches_, [](const PatchCells& patch) { return patch.may_be_whole && patch.cells.found().is_all_lit; });
}

double PolygonReflection::largest_uncertain_area() const {
  double largest = 0;
  for (const PatchCells& patch : patches_) largest = std::max(largest, patch.cells.found().largest_uncertain_area);
  return largest;
}

Reflecting PolygonReflection::measured() const {
  CellsFound found;
  for (const PatchCells& patch : patches_) found += patch.cells.found();
  const double area = is_whole() ? area_ : std::min(found.lit_area, area_);
  return {{}, area, std::min(found.uncertain_area, area_), found.distance};
}

Reflecting PolygonReflection::bordered(const RegionBorder& polygon, int grid_bits) const {
  Reflecting result = measured();
  RegionBorder found;
  for (const PatchCells& patch : patches_) {
    const RegionBorder part = inside_half_planes(patch.cells.border(), patch.half_planes, grid_bits);
    found.insert(found.end(), part.begin(), part.end());
  }
  result.border = is_whole() ? polygon : common_part(polygon, without_seams(std::move(found)));
  result.area = area_of(result.border);
  if (result.border.empty() || has_witness(result.border)) return result;
  return {{}, 0, std::max(result.uncertain_area, result.area), result.distance};
}

// A place is looked for beside each of the borders.
bool PolygonReflection::has_witness(const RegionBorder& border) const {
  return std::ranges::any_of(border, [&](const BorderSegment& s) {
    const Stretch stretch = widest_stretch(border, (s.start.at.y + s.end.at.y) / 2);
    const auto is_lit_there = [&](const LitCell& cell) { return is_lit_at(cell, stretch.middle); };
    return stretch.width > 0 && std::ranges::any_of(patches_, [&](const PatchCells& patch) {
             return std::ranges::any_of(patch.cells.cells(), is_lit_there);
           });
  });
}

std::uint64_t PolygonReflection::cell_count() const {
  std::uint64_t count = 0;
  for (const PatchCells& patch : patches_) count += patch.cells.count();
  return count;
}

std::uint64_t PolygonReflection::shadowed_count() const {
  std::uint64_t count = 0;
  for (const PatchCells& patch : patches_)
    count += static_cast<std::uint64_t>(
        std::ranges::count_if(patch.cells.cells(), [](const LitCell& cell) { return !cell.shadows.empty(); }));
  return count;
}

}  // namespace sightline::inline reflect
