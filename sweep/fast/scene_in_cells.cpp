#include "sweep/fast/scene_in_cells.h"

#include <algorithm>
#include <array>
#include <atomic>

#include "geometry/mesh/facet_plane.h"
#include "geometry/numbers/parallel.h"
#include "sweep/fast/large_covers.h"

namespace sightline::inline sweep {
namespace {

constexpr int highest_level = 11;
constexpr std::size_t most_samples = 1 << 16;

// So many pairs of a facet and a cell are allowed. Where nothing continues, all is contour, and fine cells have to find
// what can be left out.
constexpr double pairs_of_surface_facet = 6;
constexpr double pairs_of_lone_facet = 40;

double contour_share(const ProjectedScene& scene, const Continuation& continuation) {
  std::atomic<std::size_t> contours = 0;
  parallel_for_ranges(scene.edge_count(), [&](std::size_t /*range*/, std::size_t begin, std::size_t end) {
    std::size_t here = 0;
    for (std::size_t e = begin; e < end; ++e) here += continuation.is_contour(EdgeId(e)) ? 1 : 0;
    contours += here;
  });
  return static_cast<double>(contours) / static_cast<double>(std::max<std::size_t>(scene.edge_count(), 1));
}

// Returns, per level of cells, the pairs of all facets that are not known to be hidden, as a sample of them says.
std::array<double, highest_level + 1> pairs_by_level(const ProjectedScene& scene,
                                                     const std::vector<std::uint8_t>& hidden) {
  const CellGrid finest(scene.grid_bits, highest_level);
  const std::size_t step = 1 + scene.status.size() / most_samples;
  std::array<double, highest_level + 1> pairs{};
  for (std::size_t f = 0; f < scene.status.size(); f += step) {
    if (scene.status[f] != FacetStatus::in_view || hidden[f] != 0) continue;
    const CellRange range = finest.range_of(FacetOutline(scene, FacetId(f)).points());
    for (int level = 0; level <= highest_level; ++level) {
      const int shift = highest_level - level;
      const double columns = (range.right >> shift) - (range.left >> shift) + 1;
      const double rows = (range.top >> shift) - (range.bottom >> shift) + 1;
      pairs[static_cast<std::size_t>(level)] += static_cast<double>(step) * columns * rows;
    }
  }
  return pairs;
}

int level_for(const ProjectedScene& scene, const Continuation& continuation, const std::vector<std::uint8_t>& hidden) {
  const auto pairs = pairs_by_level(scene, hidden);
  const double share = contour_share(scene, continuation);
  const double per_facet = share * pairs_of_lone_facet + (1 - share) * pairs_of_surface_facet;
  const auto facets = std::ranges::count(scene.status, FacetStatus::in_view);
  int level = std::min(highest_level, highest_level_for(static_cast<std::size_t>(facets)));
  while (level > 0 && pairs[static_cast<std::size_t>(level)] > per_facet * static_cast<double>(facets)) --level;
  return level;
}

std::vector<std::uint8_t> hidden_surfaces(const ProjectedScene& scene, const CellSides& sides,
                                          const std::vector<DepthRange>& depths) {
  std::vector<std::uint8_t> hidden = hidden_behind_large_facets(scene, sides, depths);
  keep_surfaces_whole(scene, hidden);
  return hidden;
}

}  // namespace

SceneInCells::SceneInCells(const ProjectedScene& whole, std::optional<int> level)
    : scene(whole),
      sides(whole),
      continuation(whole),
      depths(depth_ranges(whole)),
      hidden(hidden_surfaces(whole, sides, depths)),
      grid(whole.grid_bits, level ? *level : level_for(whole, continuation, hidden), spread_of(whole)),
      cells(whole, sides, continuation, grid, hidden) {}

SceneInCells::SceneInCells(const ProjectedScene& whole, int level, std::vector<std::uint8_t> known_hidden)
    : scene(whole),
      sides(whole),
      continuation(whole),
      depths(depth_ranges(whole)),
      hidden(std::move(known_hidden)),
      grid(whole.grid_bits, level, spread_of(whole)),
      cells(whole, sides, continuation, grid, hidden) {}

void keep_surfaces_whole(const ProjectedScene& scene, std::vector<std::uint8_t>& hidden) {
  const CutMesh& mesh = scene.mesh();
  parallel_for_each(hidden.size(), [&](std::size_t begin) {
    if (surface_of(mesh, FacetId(begin)) != FacetId(begin)) return;
    const std::size_t end = end_of_surface(mesh, FacetId(begin)).index();
    std::size_t seen = 0;
    for (std::size_t f = begin; f < end; ++f) seen += scene.status[f] == FacetStatus::in_view && hidden[f] == 0 ? 1 : 0;
    if (seen > 0) std::fill_n(hidden.begin() + static_cast<std::ptrdiff_t>(begin), end - begin, std::uint8_t{0});
  });
}

}  // namespace sightline::inline sweep
