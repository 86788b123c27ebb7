#include "reflect/smooth/smooth_mirror.h"

#include <cmath>

#include "reflect/world/uncut_facets.h"

namespace sightline::inline reflect {
namespace {

BentMirror::WindowTriangle in_window(const ImageTriangle& triangle, int grid_bits) {
  BentMirror::WindowTriangle result;
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = {std::ldexp(static_cast<double>(triangle[i].x), -grid_bits),
                 std::ldexp(static_cast<double>(triangle[i].y), -grid_bits)};
  return result;
}

// A facet of the surface or of a panel, as a ray meets it from one side: there its corners are seen counter-clockwise.
struct FacetSide {
  std::vector<Point3> corners;  // scaled
  std::vector<VertexId> vertices;
  BentMirror::Plane plane;
  std::uint32_t object = 0;  // the number of its panel, or that behind the last one for the surface
  bool from_front = true;
};

FacetSide facet_side(const MirrorWorld& world, const CutMesh& mesh, UncutFacetId facet, std::size_t object,
                     bool from_front) {
  FacetSide side;
  side.object = static_cast<std::uint32_t>(object);
  side.from_front = from_front;
  const auto corners = mesh.uncut_corners(facet);
  side.vertices.assign(corners.begin(), corners.end());
  if (!from_front) std::ranges::reverse(side.vertices);
  for (const VertexId v : side.vertices) side.corners.push_back(world.scale * mesh.position(v));
  std::array<Point3, 3> plane = plane_points(mesh, mesh.first_piece(facet));
  if (!from_front) std::swap(plane[1], plane[2]);
  const Vector3 along = world.scale * plane[1] - world.scale * plane[0];
  side.plane = {unit(along.cross(world.scale * plane[2] - world.scale * plane[0])), world.scale * plane[0]};
  return side;
}

Seam seam_of(const CutMesh& mesh, const FacetSide& side, std::size_t i) {
  const VertexId p = mesh.weld[side.vertices[i].index()];
  const VertexId q = mesh.weld[side.vertices[(i + 1) % side.vertices.size()].index()];
  return {side.object, side.from_front, p.value, q.value};
}

// Collects conditions as long as none fails.
class Collector {
 public:
  [[nodiscard]] bool add(const Condition& condition, std::optional<Seam> seam = std::nullopt) {
    const Standing at = standing(condition);
    is_possible_ = is_possible_ && at != Standing::fails;
    if (at == Standing::open) part_.push_back({condition, seam});
    return is_possible_;
  }
  [[nodiscard]] ConvexPart take() { return std::move(part_); }

 private:
  ConvexPart part_;
  bool is_possible_ = true;
};

// Adds that a ray meets the facet from this side.
bool add_meeting(const BentMirror& mirror, const CutMesh& mesh, const FacetSide& side, Collector& collector) {
  bool is_possible = collector.add(mirror.starts_before(side.plane));
  for (std::size_t i = 0; i < side.corners.size() && is_possible; ++i)
    is_possible = collector.add(mirror.passes_left_of(side.corners[i], side.corners[(i + 1) % side.corners.size()]),
                                seam_of(mesh, side, i));
  return is_possible;
}

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

// Returns whether some place of the region is lit for certain: one is looked for beside each of its borders.
bool has_witness(const RegionBorder& border, const std::vector<LitCell>& covers) {
  return std::ranges::any_of(border, [&](const BorderSegment& s) {
    const Stretch stretch = widest_stretch(border, (s.start.at.y + s.end.at.y) / 2);
    return stretch.width > 0 &&
           std::ranges::any_of(covers, [&](const LitCell& cover) { return is_lit_at(cover, stretch.middle); });
  });
}

RegionBorder inside_half_planes(RegionBorder border, const SmoothPatch& patch, int grid_bits) {
  for (const ImagePolygon& half_plane : patch.half_planes) {
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

SmoothMirror::SmoothMirror(const MirrorWorld& world, const ProjectedScene& scene, FacetId surface)
    : world_(world),
      scene_(scene),
      plane_(plane_points(*world.surface, surface)),
      patches_(smooth_patches(world, scene, surface)) {
  if (scene.facing[surface.index()] == FacetFacing::back) std::swap(plane_[1], plane_[2]);
}

SmoothMirror::Reflecting SmoothMirror::reflecting(const RegionBorder& polygon, std::size_t panel,
                                                  const CellPrecision& precision, CellResult wanted,
                                                  ReflectionStatistics& statistics) const {
  Reflecting result;
  const PolygonOutline outline(polygon);
  const double area = area_of(polygon);
  RegionBorder found;
  bool is_whole = false;
  std::vector<LitCell> covers;
  for (const SmoothPatch& patch : patches_) {
    for (const PanelSide& side : sides_of(panel)) {
      LitCells cells(outline, precision, wanted);
      bool is_lit = patches_.size() == 1;
      for (const ImageTriangle& cover : patch.covers) {
        LitCell cell = cell_of(patch, cover, side, statistics);
        is_lit = is_lit && !cell.images.empty();
        if (cell.images.empty()) continue;
        covers.push_back(cell);
        cells.look_at(std::move(cell));
      }
      statistics.pyramids += cells.cell_count();
      statistics.blocked += cells.shadow_count();
      is_whole = is_whole || (is_lit && cells.is_all_lit());
      result.uncertain_area += cells.uncertain_area();
      result.distance = std::max(result.distance, cells.distance());
      result.uncertain_cells += cells.uncertain_count();
      result.area += cells.estimated_area();
      const RegionBorder part = inside_half_planes(cells.border(), patch, scene_.grid_bits);
      found.insert(found.end(), part.begin(), part.end());
    }
  }
  result.uncertain_area = std::min(result.uncertain_area, area);
  result.area = is_whole ? area : std::min(result.area, area);
  if (wanted == CellResult::measure) return result;
  result.area = 0;
  if (found.empty()) return result;
  result.border = is_whole ? polygon : common_part(polygon, without_seams(std::move(found)));
  result.area = area_of(result.border);
  if (has_witness(result.border, covers)) return result;
  result.uncertain_area = std::max(result.uncertain_area, result.area);
  result.border.clear();
  result.area = 0;
  return result;
}

std::vector<SmoothMirror::PanelSide> SmoothMirror::sides_of(std::size_t panel) const {
  std::vector<PanelSide> sides{{panel, true}};
  if (world_.panels[panel].emits == Emits::both) sides.push_back({panel, false});
  return sides;
}

// There are no images where no ray meets this side of the panel.
LitCell SmoothMirror::cell_of(const SmoothPatch& patch, const ImageTriangle& cover, const PanelSide& side,
                              ReflectionStatistics& statistics) const {
  const BentMirror mirror(scene_.camera, world_.scale, patch.triangle, in_window(cover, scene_.grid_bits));
  const RayBeam beam = mirror.beam();
  const Box& box = world_.panel_boxes[side.panel];
  LitCell cell{cover, {}, {}};
  if (!beam.may_reach({world_.scale * box.low, world_.scale * box.high})) return cell;
  add_images(mirror, side, cell.images);
  if (!narrow_to_lit(cell)) return {cover, {}, {}};
  cell.shadows = shadows(mirror, beam, side, statistics);
  return cell;
}

void SmoothMirror::add_images(const BentMirror& mirror, const PanelSide& side, std::vector<ConvexPart>& images) const {
  const CutMesh& mesh = world_.panel_meshes[side.panel];
  for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
    Collector collector;
    if (add_meeting(mirror, mesh, facet_side(world_, mesh, UncutFacetId(f), side.panel, side.from_front), collector) &&
        collector.add(mirror.rises()))
      images.push_back(collector.take());
  }
}

std::vector<ConvexPart> SmoothMirror::shadows(const BentMirror& mirror, const RayBeam& beam, const PanelSide& panel,
                                              ReflectionStatistics& statistics) const {
  const FacetSide emitting =
      facet_side(world_, world_.panel_meshes[panel.panel], UncutFacetId(0), panel.panel, panel.from_front);
  std::vector<Point3> panel_corners;
  for (const Point3& corner : world_.panels[panel.panel].corners) panel_corners.push_back(world_.scale * corner);
  const RayBeam to_panel = mirror.beam_to(panel_corners);
  const auto may_reach = [&](const Box& box) {
    const Box scaled{world_.scale * box.low, world_.scale * box.high};
    return beam.may_reach(scaled) && to_panel.may_reach(scaled);
  };
  std::vector<ConvexPart> result;
  const auto add = [&](const CutMesh& mesh, std::size_t object, UncutFacetId facet) {
    if (!is_in_the_way(mesh, facet, panel)) return;
    ++statistics.obstacles;
    for (const bool from_front : {true, false}) {
      const FacetSide side = facet_side(world_, mesh, facet, object, from_front);
      Collector collector;
      if (add_meeting(mirror, mesh, side, collector) && collector.add(mirror.meets_before(side.plane, emitting.plane)))
        result.push_back(collector.take());
    }
  };
  for (const UncutFacetId facet : world_.obstacles.in(may_reach)) add(*world_.surface, world_.panels.size(), facet);
  for (std::size_t p = 0; p < world_.panels.size(); ++p) {
    if (p == panel.panel || !may_reach(world_.panel_boxes[p])) continue;
    const CutMesh& mesh = world_.panel_meshes[p];
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) add(mesh, p, UncutFacetId(f));
  }
  for (const std::size_t p : world_.panels_over[panel.panel]) {
    add_images(mirror, {p, true}, result);
    add_images(mirror, {p, false}, result);
  }
  return result;
}

// Some corner is above the mirror's plane, and some, perhaps another, before the panel's emitting side.
bool SmoothMirror::is_in_the_way(const CutMesh& mesh, UncutFacetId facet, const PanelSide& side) const {
  const auto has_corner_before = [&](const std::array<Point3, 3>& plane) {
    return std::ranges::any_of(mesh.uncut_corners(facet), [&](VertexId v) {
      return orient3d(plane[0], plane[1], plane[2], mesh.position(v)) > 0;
    });
  };
  std::array<Point3, 3> emitting = plane_points(world_.panel_meshes[side.panel], FacetId(0));
  if (!side.from_front) std::swap(emitting[1], emitting[2]);
  return has_corner_before(plane_) && has_corner_before(emitting);
}

}  // namespace sightline::inline reflect
