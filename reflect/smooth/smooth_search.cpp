#include "reflect/smooth/smooth_search.h"

#include <cmath>

namespace sightline::inline reflect {
namespace {

constexpr double aim = 0.9;                   // of what is allowed: an area is an estimate as long as it has no border
constexpr double negligible_share = 0x1p-30;  // of the window
constexpr int most_rounds = 100;

// All polygons and one panel.
class PanelSearch {
 public:
  PanelSearch(const MirrorWorld& world, const ProjectedScene& scene, const std::vector<MirrorPolygon>& polygons,
              std::size_t panel)
      : polygons_(polygons),
        grid_bits_(scene.grid_bits),
        half_window_(std::ldexp(1.0, scene.grid_bits)),
        tolerance_(world.options.tolerance),
        panel_(panel),
        reflections_(polygons.size()),
        found_(polygons.size()),
        has_border_(polygons.size(), true) {}

  void run(const MirrorWorld& world, const ProjectedScene& scene, ReflectionStatistics& statistics) {
    look_at_all(world, scene, statistics);
    for (int round = 0; round < most_rounds; ++round) {
      while (!is_precise(aim) && divide_most_uncertain()) ++round;
      add_borders();
      if (is_precise(1) || !divide_most_uncertain()) break;
    }
    add_borders();
    statistics.pyramids += dark_cells_;
    for (const auto& reflection : reflections_) {
      if (!reflection) continue;
      statistics.pyramids += reflection->cell_count();
      statistics.blocked += reflection->shadowed_count();
    }
  }

  [[nodiscard]] Reflecting together() const {
    Reflecting all;
    for (const Reflecting& found : found_) {
      all.area += found.area;
      all.uncertain_area += found.uncertain_area;
      all.distance = std::max(all.distance, found.distance);
    }
    return all;
  }
  [[nodiscard]] Reflecting take(std::size_t polygon) { return std::move(found_[polygon]); }

 private:
  void look_at_all(const MirrorWorld& world, const ProjectedScene& scene, ReflectionStatistics& statistics) {
    const CellPrecision precision{4 * half_window_ * half_window_, tolerance_ * half_window_};
    std::optional<SmoothMirror> mirror;
    FacetId surface;
    for (std::size_t p = 0; p < polygons_.size(); ++p) {
      if (world.is_snapped_surface(panel_, polygons_[p].surface)) continue;
      if (!mirror || surface != polygons_[p].surface) mirror.emplace(world, scene, polygons_[p].surface);
      surface = polygons_[p].surface;
      reflections_[p] = mirror->look_at(polygons_[p].border, panel_, precision, statistics);
      if (reflections_[p]) measure(p);
    }
  }

  // What is dark needs no further look.
  void measure(std::size_t p) {
    found_[p] = reflections_[p]->measured();
    has_border_[p] = reflections_[p]->is_dark();
    if (!reflections_[p]->is_dark()) return;
    dark_cells_ += reflections_[p]->cell_count();
    reflections_[p].reset();
  }

  [[nodiscard]] bool is_precise(double share) const {
    const Reflecting all = together();
    const double negligible = negligible_share * 4 * half_window_ * half_window_;
    return all.uncertain_area <= std::max(share * tolerance_ * all.area, negligible);
  }

  // Returns false where all cells are as small as they can be.
  [[nodiscard]] bool divide_most_uncertain() {
    double most = 0;
    for (const auto& reflection : reflections_) {
      if (reflection) most = std::max(most, reflection->largest_uncertain_area());
    }
    if (most == 0) return false;
    for (std::size_t p = 0; p < polygons_.size(); ++p) {
      if (!reflections_[p] || reflections_[p]->largest_uncertain_area() <= most / 2) continue;
      reflections_[p]->divide({most / 2, tolerance_ * half_window_});
      measure(p);
    }
    return true;
  }

  void add_borders() {
    for (std::size_t p = 0; p < polygons_.size(); ++p) {
      if (has_border_[p]) continue;
      found_[p] = reflections_[p]->bordered(polygons_[p].border, grid_bits_);
      has_border_[p] = true;
    }
  }

  const std::vector<MirrorPolygon>& polygons_;
  int grid_bits_;
  double half_window_;
  double tolerance_;
  std::size_t panel_;
  std::vector<std::optional<PolygonReflection>> reflections_;
  std::vector<Reflecting> found_;
  std::vector<bool> has_border_;
  std::uint64_t dark_cells_ = 0;
};

}  // namespace

SmoothReflections find_smooth_reflections(const MirrorWorld& world, const ProjectedScene& scene,
                                          const std::vector<MirrorPolygon>& polygons,
                                          ReflectionStatistics& statistics) {
  SmoothReflections result{std::vector<std::vector<Reflecting>>(polygons.size()), {}};
  for (std::size_t panel = 0; panel < world.panels.size(); ++panel) {
    PanelSearch search(world, scene, polygons, panel);
    search.run(world, scene, statistics);
    result.together.push_back(search.together());
    for (std::size_t p = 0; p < polygons.size(); ++p) result.found[p].push_back(search.take(p));
  }
  return result;
}

}  // namespace sightline::inline reflect
