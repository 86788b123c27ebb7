#include "reflect/smooth/smooth_search.h"

#include <cmath>

namespace sightline::inline reflect {
namespace {

constexpr double aim = 0.7;                   // of what is allowed: what is next should do
constexpr double negligible_share = 0x1p-30;  // of the window
constexpr int most_rounds = 20;

class SmoothSearch {
 public:
  SmoothSearch(const MirrorWorld& world, const ProjectedScene& scene, const std::vector<MirrorPolygon>& polygons,
               ReflectionStatistics& statistics)
      : world_(world),
        scene_(scene),
        polygons_(polygons),
        statistics_(statistics),
        half_window_(std::ldexp(1.0, scene.grid_bits)),
        result_{std::vector(polygons.size(), std::vector<SmoothMirror::Reflecting>(world.panels.size())),
                std::vector<SmoothMirror::Reflecting>(world.panels.size())} {}

  SmoothReflections run() {
    for (std::size_t panel = 0; panel < world_.panels.size(); ++panel) {
      CellPrecision precision{half_window_ * half_window_, world_.options.tolerance * half_window_};
      for (int round = 0; round < most_rounds; ++round) {
        look_at(panel, precision, CellResult::measure, round == 0);
        if (is_precise(panel)) break;
        precision.area = next_area(panel, precision.area);
      }
      look_at(panel, precision, CellResult::border, false);
      for (int round = 0; round < most_rounds && !is_precise(panel); ++round) {
        precision.area = next_area(panel, precision.area);
        look_at(panel, precision, CellResult::border, false);
      }
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool is_precise(std::size_t panel) const {
    const SmoothMirror::Reflecting& all = result_.together[panel];
    return all.uncertain_area <= allowed(all);
  }

  [[nodiscard]] double allowed(const SmoothMirror::Reflecting& all) const {
    return std::max(world_.options.tolerance * all.area, negligible_share * 4 * half_window_ * half_window_);
  }

  // Where a border is followed by n cells, each has an uncertain area in proportion to n^-3, and all have n^-2: so to a share s of
  // what is uncertain in all belongs s^1.5 of what is in each.
  [[nodiscard]] double next_area(std::size_t panel, double area) const {
    const SmoothMirror::Reflecting& all = result_.together[panel];
    const double share = aim * allowed(all) / all.uncertain_area;
    const double mean = all.uncertain_area / static_cast<double>(std::max<std::uint64_t>(1, all.uncertain_cells));
    return std::min(area / 2, mean * std::pow(share, 1.5));
  }

  // Polygons of which nothing was uncertain, and that reflect nothing, are known.
  void look_at(std::size_t panel, const CellPrecision& precision, CellResult wanted, bool all) {
    SmoothMirror::Reflecting together;
    std::optional<SmoothMirror> mirror;
    FacetId surface;
    for (std::size_t p = 0; p < polygons_.size(); ++p) {
      SmoothMirror::Reflecting& found = result_.found[p][panel];
      const bool has_no_border = wanted == CellResult::border && found.area > 0 && found.border.empty();
      if (all || found.uncertain_area > 0 || has_no_border) {
        if (world_.is_snapped_surface(panel, polygons_[p].surface)) continue;
        if (!mirror || surface != polygons_[p].surface) mirror.emplace(world_, scene_, polygons_[p].surface);
        surface = polygons_[p].surface;
        found = mirror->reflecting(polygons_[p].border, panel, precision, wanted, statistics_);
      }
      together.area += found.area;
      together.uncertain_area += found.uncertain_area;
      together.distance = std::max(together.distance, found.distance);
      together.uncertain_cells += found.uncertain_cells;
    }
    result_.together[panel] = together;
  }

  const MirrorWorld& world_;
  const ProjectedScene& scene_;
  const std::vector<MirrorPolygon>& polygons_;
  ReflectionStatistics& statistics_;
  double half_window_;
  SmoothReflections result_;
};

}  // namespace

SmoothReflections find_smooth_reflections(const MirrorWorld& world, const ProjectedScene& scene,
                                          const std::vector<MirrorPolygon>& polygons,
                                          ReflectionStatistics& statistics) {
  return SmoothSearch(world, scene, polygons, statistics).run();
}

}  // namespace sightline::inline reflect
