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

BentMirror::Plane plane_of_side(const MirrorWorld& world, std::array<Point3, 3> plane, bool from_front) {
  if (!from_front) std::swap(plane[1], plane[2]);
  const Vector3 along = world.scale * plane[1] - world.scale * plane[0];
  return {unit(along.cross(world.scale * plane[2] - world.scale * plane[0])), world.scale * plane[0]};
}

FacetSide facet_side(const MirrorWorld& world, const CutMesh& mesh, UncutFacetId facet, std::size_t object,
                     bool from_front) {
  FacetSide side;
  side.object = static_cast<std::uint32_t>(object);
  side.from_front = from_front;
  const auto corners = mesh.uncut_corners(facet);
  side.vertices.assign(corners.begin(), corners.end());
  if (!from_front) std::ranges::reverse(side.vertices);
  for (const VertexId v : side.vertices) side.corners.push_back(world.scale * mesh.position(v));
  side.plane = plane_of_side(world, plane_points(mesh, mesh.first_piece(facet)), from_front);
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

}  // namespace

SmoothMirror::SmoothMirror(const MirrorWorld& world, const ProjectedScene& scene, FacetId surface)
    : world_(world),
      scene_(scene),
      surface_(surface),
      plane_(plane_points(*world.surface, surface)),
      patches_(smooth_patches(world, scene, surface)) {
  if (scene.facing[surface.index()] == FacetFacing::back) std::swap(plane_[1], plane_[2]);
}

std::optional<PolygonReflection> SmoothMirror::look_at(const RegionBorder& polygon, std::size_t panel,
                                                       const CellPrecision& precision,
                                                       ReflectionStatistics& statistics) const {
  std::optional<PolygonReflection> result;
  for (const SmoothPatch& patch : patches_) {
    for (const PanelSide& side : sides_of(panel)) {
      std::vector<LitCell> covers;
      for (const ImageTriangle& cover : patch.covers) {
        LitCell cell = cell_of(patch, cover, side, statistics);
        if (!cell.images.empty()) covers.push_back(std::move(cell));
      }
      if (covers.empty()) continue;
      if (!result) result.emplace(polygon);
      const bool is_all = patches_.size() == 1 && covers.size() == patch.covers.size();
      result->add(std::move(covers), patch.half_planes, is_all, precision);
    }
  }
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
  const BentMirror::Plane emitting =
      plane_of_side(world_, panel_plane(world_.panel_meshes[panel.panel]), panel.from_front);
  std::vector<Point3> panel_corners;
  for (const Point3& corner : world_.panels[panel.panel].corners) panel_corners.push_back(world_.scale * corner);
  const RayBeam to_panel = mirror.beam_to(panel_corners);
  const auto may_reach = [&](const Box& box) {
    const Box scaled{world_.scale * box.low, world_.scale * box.high};
    return beam.may_reach(scaled) && to_panel.may_reach(scaled);
  };
  std::vector<ConvexPart> result;
  const bool fronts_suffice = is_closed_before(panel.panel);
  const auto add = [&](const CutMesh& mesh, std::size_t object, UncutFacetId facet) {
    if (!is_in_the_way(mesh, facet, panel)) return;
    ++statistics.obstacles;
    for (const bool from_front : {true, false}) {
      if (!from_front && fronts_suffice && &mesh == world_.surface.get()) continue;
      const FacetSide side = facet_side(world_, mesh, facet, object, from_front);
      Collector collector;
      if (add_meeting(mirror, mesh, side, collector) && collector.add(mirror.meets_before(side.plane, emitting)))
        result.push_back(collector.take());
    }
  };
  for (const UncutFacetId facet : world_.obstacles.in(may_reach)) {
    if (world_.is_snapped(panel.panel, facet) || world_.is_snapped_to_mirror(surface_, facet)) continue;
    add(*world_.surface, world_.panels.size(), facet);
  }
  for (std::size_t p = 0; p < world_.panels.size(); ++p) {
    if (p == panel.panel || world_.is_in_plane(panel.panel, p) || world_.is_snapped_surface(p, surface_)) continue;
    if (!may_reach(world_.panel_boxes[p])) continue;
    const CutMesh& mesh = world_.panel_meshes[p];
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) add(mesh, p, UncutFacetId(f));
  }
  for (const std::size_t p : world_.panels_over[panel.panel]) {
    add_images(mirror, {p, true}, result);
    add_images(mirror, {p, false}, result);
  }
  return result;
}

// Both the eye and the panel are outside of a closed surface, and no near plane opens it.
bool SmoothMirror::is_closed_before(std::size_t panel) const {
  const Camera& camera = scene_.camera;
  if (!world_.closed || camera.near_distance || overlap(*world_.closed, world_.panel_boxes[panel])) return false;
  return camera.projection == Projection::orthographic || !contains(*world_.closed, camera.eye.xyz);
}

// Some corner is above the mirror's plane, and some, perhaps another, before the panel's emitting side.
bool SmoothMirror::is_in_the_way(const CutMesh& mesh, UncutFacetId facet, const PanelSide& side) const {
  const auto has_corner_before = [&](const std::array<Point3, 3>& plane) {
    return std::ranges::any_of(mesh.uncut_corners(facet), [&](VertexId v) {
      return orient3d(plane[0], plane[1], plane[2], mesh.position(v)) > 0;
    });
  };
  std::array<Point3, 3> emitting = panel_plane(world_.panel_meshes[side.panel]);
  if (!side.from_front) std::swap(emitting[1], emitting[2]);
  return has_corner_before(plane_) && has_corner_before(emitting);
}

}  // namespace sightline::inline reflect
