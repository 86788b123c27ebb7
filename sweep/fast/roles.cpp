#include "sweep/fast/roles.h"

#include <algorithm>
#include <atomic>

#include "geometry/mesh/facet_plane.h"
#include "geometry/numbers/parallel.h"

namespace sightline::inline sweep {
namespace {

class RoleFinder {
 public:
  RoleFinder(const SceneInCells& in, const Covers& covers)
      : mesh_(in.mesh()),
        scene_(in.scene),
        continuation_(in.continuation),
        covers_(covers),
        grid_(in.grid),
        cells_(in.cells) {}

  std::vector<Role> find() {
    const std::vector<std::uint8_t> clear = clear_cells();
    std::vector<Role> roles(mesh_.facet_count(), Role::absent);
    parallel_for_each(roles.size(), [&](std::size_t f) {
      if (scene_.status[f] != FacetStatus::in_view) return;
      roles[f] = is_hidden(FacetId(f)) ? Role::hidden : (is_plain(FacetId(f), clear) ? Role::plain : Role::open);
    });
    return roles;
  }

 private:
  [[nodiscard]] bool is_hidden(FacetId f) const { return covers_.hidden[f.index()] != 0; }

  // A cell is clear where it has one sheet and no contour edge touches it.
  [[nodiscard]] std::vector<std::uint8_t> clear_cells() const {
    std::vector<std::uint8_t> clear = covers_.one_sheet;
    parallel_for_each(scene_.edge_count(), [&](std::size_t e) {
      if (!is_contour(EdgeId(e))) return;
      const SceneEdge& edge = scene_.edges[e];
      grid_.for_each_on_segment(scene_.point(edge.top), scene_.point(edge.bottom), [&](unsigned column, unsigned row) {
        std::atomic_ref(clear[grid_.cell(column, row)]).store(0, std::memory_order_relaxed);
        return true;
      });
    });
    return clear;
  }

  // A contour is where a facet that may be seen ends and no other that may be seen continues it. What is hidden anyway
  // has no contour.
  [[nodiscard]] bool is_contour(EdgeId e) const {
    if (!continuation_.is_contour(e)) {
      const Neighbours& across = continuation_.across(e);
      return is_hidden(across.left) != is_hidden(across.right);
    }
    const auto sides = scene_.sides_of(e);
    return std::any_of(sides.begin(), sides.end(), [this](const EdgeSide& side) { return !is_hidden(side.facet); });
  }

  // A facet is plain where it is all of its surface and all its cells are clear.
  [[nodiscard]] bool is_plain(FacetId f, const std::vector<std::uint8_t>& clear) const {
    const FacetId surface = surface_of(mesh_, f);
    return end_of_surface(mesh_, surface).index() == surface.index() + 1 &&
           std::ranges::all_of(cells_.of(f), [&](const FacetCell& cell) { return clear[cell.cell()] != 0; });
  }

  const CutMesh& mesh_;
  const ProjectedScene& scene_;
  const Continuation& continuation_;
  const Covers& covers_;
  const CellGrid& grid_;
  const FacetCells& cells_;
};

}  // namespace

std::vector<Role> find_roles(const SceneInCells& in, const Covers& covers) { return RoleFinder(in, covers).find(); }

}  // namespace sightline::inline sweep
