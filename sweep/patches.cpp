#include "sweep/patches.h"

#include <algorithm>

#include "geometry/facet_plane.h"

namespace sightline {
namespace {

class PatchFinder {
 public:
  PatchFinder(const Mesh& mesh, const ProjectedScene& scene, const Continuation& continuation, const CellGrid& grid,
              const FacetCells& cells)
      : mesh_(mesh), scene_(scene), continuation_(continuation), grid_(grid), cells_(cells) {}

  Patches find(const std::vector<std::uint8_t>& hidden) {
    set_roles(hidden);
    join_patches();
    return std::move(result_);
  }

 private:
  void set_roles(const std::vector<std::uint8_t>& hidden) {
    result_.role.assign(mesh_.facet_count(), Role::absent);
    for (std::size_t f = 0; f < mesh_.facet_count(); ++f) {
      if (scene_.status[f] == Status::in_view) result_.role[f] = hidden[f] != 0 ? Role::hidden : Role::open;
    }
    const auto contour_cells = cells_with_contours();
    for (std::size_t f = 0; f < mesh_.facet_count(); ++f) {
      if (result_.role[f] == Role::open && is_plain(FacetId(f), contour_cells)) result_.role[f] = Role::plain;
    }
  }

  [[nodiscard]] bool is_hidden(FacetId f) const { return result_.role[f.index()] == Role::hidden; }

  // Where a facet that may be seen ends and no other that may be seen continues it. What is hidden anyway has no contour.
  [[nodiscard]] bool is_contour(EdgeId e) const {
    if (!continuation_.is_contour(e)) {
      const Neighbours& across = continuation_.across(e);
      return is_hidden(across.left) != is_hidden(across.right);
    }
    const auto sides = scene_.sides_of(e);
    return std::any_of(sides.begin(), sides.end(), [this](const EdgeSide& side) { return !is_hidden(side.facet); });
  }

  [[nodiscard]] std::vector<std::uint8_t> cells_with_contours() const {
    std::vector<std::uint8_t> cells(grid_.cell_count(), 0);
    for (std::size_t e = 0; e < scene_.edge_count(); ++e) {
      if (!is_contour(EdgeId(e))) continue;
      const SceneEdge& edge = scene_.edges[e];
      grid_.for_each_on_segment(scene_.point(edge.top), scene_.point(edge.bottom), [&](unsigned column, unsigned row) {
        cells[grid_.cell(column, row)] = 1;
        return true;
      });
    }
    return cells;
  }

  // A facet that is all of its surface, that nothing touches, and whose cells no contour edge touches.
  [[nodiscard]] bool is_plain(FacetId f, const std::vector<std::uint8_t>& contour_cells) const {
    const FacetId surface = surface_of(mesh_, f);
    if (end_of_surface(mesh_, surface).index() != surface.index() + 1 || mesh_.touched[f.index()] != 0) return false;
    return touches_no(f, contour_cells);
  }

  [[nodiscard]] bool touches_no(FacetId f, const std::vector<std::uint8_t>& cells) const {
    return std::ranges::none_of(cells_.of(f), [&](const FacetCell& cell) { return cells[cell.cell()] != 0; });
  }

  // Plain facets that continue each other are of one patch. Patches are numbered by their first facets.
  void join_patches() {
    parent_.resize(mesh_.facet_count());
    for (std::size_t f = 0; f < parent_.size(); ++f) parent_[f] = static_cast<std::uint32_t>(f);
    for (std::size_t e = 0; e < scene_.edge_count(); ++e) {
      if (continuation_.is_contour(EdgeId(e))) continue;
      const Neighbours& across = continuation_.across(EdgeId(e));
      if (is_plain(across.left) && is_plain(across.right)) join(across.left.value, across.right.value);
    }
    result_.patch_of.resize(mesh_.facet_count());
    for (std::size_t f = 0; f < mesh_.facet_count(); ++f) {
      if (!is_plain(FacetId(f))) continue;
      PatchId& root = result_.patch_of[root_of(static_cast<std::uint32_t>(f))];
      if (!root.valid()) root = PatchId(result_.patch_count++);
      result_.patch_of[f] = root;
    }
  }

  [[nodiscard]] bool is_plain(FacetId f) const { return result_.role[f.index()] == Role::plain; }

  std::uint32_t root_of(std::uint32_t f) {
    while (parent_[f] != f) {
      parent_[f] = parent_[parent_[f]];
      f = parent_[f];
    }
    return f;
  }

  void join(std::uint32_t f, std::uint32_t g) {
    f = root_of(f);
    g = root_of(g);
    parent_[std::max(f, g)] = std::min(f, g);
  }

  const Mesh& mesh_;
  const ProjectedScene& scene_;
  const Continuation& continuation_;
  const CellGrid& grid_;
  const FacetCells& cells_;
  Patches result_;
  std::vector<std::uint32_t> parent_;
};

}  // namespace

Patches find_patches(const Mesh& mesh, const ProjectedScene& scene, const Continuation& continuation,
                     const std::vector<std::uint8_t>& hidden, const CellGrid& grid, const FacetCells& cells) {
  return PatchFinder(mesh, scene, continuation, grid, cells).find(hidden);
}

}  // namespace sightline
