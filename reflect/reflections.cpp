#include "reflect/reflections.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reflect/exact/mirror.h"
#include "reflect/reflecting_border.h"
#include "reflect/smooth/smooth_search.h"
#include "sweep/segments/image_points.h"

namespace sightline::inline reflect {
namespace {

// The borders of what reflects which panel, surface by surface.
struct ReflectingBorders {
  struct Owner {
    FacetId surface;
    std::size_t panel = 0;
  };
  RegionBorder segments;
  std::vector<Owner> owners;  // parallel to the segments
  ReflectionStatistics statistics;
  std::vector<Reflecting> smooth;  // per panel, where mirrors are smooth

  // `found` has a border per panel.
  void add(FacetId surface, std::vector<RegionBorder> found) {
    found = divided_at_meetings(std::move(found));
    for (std::size_t panel = 0; panel < found.size(); ++panel) {
      segments.insert(segments.end(), found[panel].begin(), found[panel].end());
      owners.resize(segments.size(), {surface, panel});
    }
  }
};

// Polygons are sorted by their surface.
class ReflectionSearch {
 public:
  ReflectionSearch(const MirrorWorld& world, const ImagePoints& image, const VisiblePolygons& polygons)
      : world_(world), scene_(image.scene()), segments_(image.segments()), polygons_(polygons), points_(image) {}

  ReflectingBorders run() {
    if (world_.options.mode == ReflectionMode::smooth) {
      add_smooth();
      return std::move(found_);
    }
    for (std::size_t p = 0; p < polygons_.polygons.size(); ++p) {
      if (is_mirror(polygons_.polygons[p])) add_polygon(p);
    }
    return std::move(found_);
  }

 private:
  [[nodiscard]] bool is_mirror(const VisiblePolygon& polygon) const {
    return !polygon.below_resolution && world_.mirrors(polygon.face);
  }

  void add_smooth() {
    if (world_.panels.empty()) return;
    std::vector<MirrorPolygon> polygons;
    for (std::size_t p = 0; p < polygons_.polygons.size(); ++p) {
      if (is_mirror(polygons_.polygons[p])) polygons.push_back({polygons_.polygons[p].facet, border_of(p)});
    }
    SmoothReflections smooth = find_smooth_reflections(world_, scene_, polygons, found_.statistics);
    for (std::size_t p = 0; p < polygons.size(); ++p) {
      std::vector<RegionBorder> borders;
      for (Reflecting& found : smooth.found[p]) borders.push_back(std::move(found.border));
      found_.add(polygons[p].surface, std::move(borders));
    }
    found_.smooth = std::move(smooth.together);
  }

  void add_polygon(std::size_t p) {
    const FacetId surface = polygons_.polygons[p].facet;
    if (!mirror_ || surface != mirrored_surface_) {
      mirror_.emplace(world_, scene_, surface);
      mirrored_surface_ = surface;
    }
    const WindowPart part = part_around(p);
    const std::vector<std::size_t> reached = mirror_->panels_reached(part);
    if (reached.empty()) return;
    const RegionBorder border = border_of(p);
    std::vector<RegionBorder> found(world_.panels.size());
    for (const std::size_t panel : reached) found[panel] = mirror_->reflecting(border, part, panel, found_.statistics);
    found_.add(surface, std::move(found));
  }

  template <class Visit>
  void for_each_segment(std::size_t polygon, Visit visit) const {
    const VisiblePolygon& p = polygons_.polygons[polygon];
    for (std::size_t r = p.first_ring; r < p.first_ring + p.ring_count; ++r) {
      for (const SegmentId s : polygons_.ring(r)) visit(segments_.segments[s.index()]);
    }
  }

  [[nodiscard]] RegionBorder border_of(std::size_t polygon) const {
    RegionBorder border;
    for_each_segment(polygon, [&](const VisibleSegment& s) { border.push_back(border_segment(points_, s)); });
    return border;
  }

  // Places are off by less than one spacing.
  [[nodiscard]] WindowPart part_around(std::size_t polygon) const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    WindowPart grid{infinity, -infinity, infinity, -infinity};
    for_each_segment(polygon, [&](const VisibleSegment& s) {
      const CertifiedPlace place = points_.certified(s.start);
      const double x = std::ldexp(place.x, scene_.grid_bits);
      const double y = std::ldexp(place.y, scene_.grid_bits);
      grid = {std::min(grid.left, x), std::max(grid.right, x), std::min(grid.bottom, y), std::max(grid.top, y)};
    });
    const auto window = [this](double place) { return std::ldexp(place, -scene_.grid_bits); };
    return {window(std::floor(grid.left) - 1), window(std::ceil(grid.right) + 1), window(std::floor(grid.bottom) - 1),
            window(std::ceil(grid.top) + 1)};
  }

  const MirrorWorld& world_;
  const ProjectedScene& scene_;
  const VisibleSegments& segments_;
  const VisiblePolygons& polygons_;
  const ImagePoints& points_;
  std::optional<Mirror> mirror_;
  FacetId mirrored_surface_;
  ReflectingBorders found_;
};

std::vector<SurfaceSegment> border_of_panel(const ReflectingBorders& borders, std::size_t panel,
                                            const MergedScene& merged) {
  std::vector<SurfaceSegment> border;
  for (std::size_t i = 0; i < borders.owners.size(); ++i) {
    if (borders.owners[i].panel == panel) border.push_back({borders.owners[i].surface, merged.border[i]});
  }
  return border;
}

PanelReflection panel_reflection(const MergedScene& merged, std::vector<SurfaceSegment> border) {
  PanelReflection reflection;
  reflection.segments = reflecting_segments(merged, std::move(border));
  reflection.polygons = reconstruct_polygons(merged.scene, reflection.segments);
  find_splits(reflection.segments, merged.scene, merged.segments);
  return reflection;
}

void add_splits(VisibleSegments& segments, const VisibleSegments& reflecting) {
  auto& splits = segments.splits;
  splits.insert(splits.end(), reflecting.splits.begin(), reflecting.splits.end());
  std::ranges::sort(splits);
  splits.erase(std::unique(splits.begin(), splits.end()), splits.end());
}

ReflectedView reflected_view(const MirrorWorld& world, const ReflectingBorders& borders, MergedScene merged) {
  Reflections reflections;
  reflections.mode = world.options.mode;
  reflections.statistics = borders.statistics;
  for (std::size_t panel = 0; panel < world.panels.size(); ++panel)
    reflections.panels.push_back(panel_reflection(merged, border_of_panel(borders, panel, merged)));
  for (std::size_t panel = 0; panel < borders.smooth.size(); ++panel) {
    const int grid_bits = merged.scene.grid_bits;
    reflections.panels[panel].uncertain_area = std::ldexp(borders.smooth[panel].uncertain_area, -2 * grid_bits);
    reflections.panels[panel].border_distance = std::ldexp(borders.smooth[panel].distance, -grid_bits);
  }
  for (const PanelReflection& panel : reflections.panels) add_splits(merged.segments, panel.segments);
  return {std::move(merged.scene), std::move(merged.segments), std::move(reflections)};
}

std::vector<VisibleSegment> border_above_resolution(const PanelReflection& panel) {
  std::vector<VisibleSegment> border;
  for (const VisiblePolygon& p : panel.polygons.polygons) {
    if (p.below_resolution) continue;
    for (std::size_t r = p.first_ring; r < p.first_ring + p.ring_count; ++r) {
      for (const SegmentId s : panel.polygons.ring(r)) border.push_back(panel.segments.segments[s.index()]);
    }
  }
  return border;
}

}  // namespace

PanelBorders panel_borders(const Reflections& reflections) {
  PanelBorders borders;
  for (const PanelReflection& panel : reflections.panels) borders.push_back(border_above_resolution(panel));
  return borders;
}

ReflectedView find_reflections(const MirrorWorld& world, ProjectedScene scene, VisibleSegments segments,
                               const VisiblePolygons& polygons) {
  return with_invariants_of(scene.arithmetic, [&] {
    const ImagePoints image(scene, segments);
    const ReflectingBorders borders = ReflectionSearch(world, image, polygons).run();
    if (scene.is_unrounded()) return reflected_view(world, borders, merge(image, borders.segments));
    return reflected_view(world, borders, merge(std::move(scene), std::move(segments), borders.segments));
  });
}

}  // namespace sightline::inline reflect
