// The sweep looks things up in these tables over the projected scene.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "geometry/mesh/cut_mesh.h"
#include "geometry/projection/projected_scene.h"

namespace sightline::inline sweep {

class SweepInput {
 public:
  SweepInput(const ProjectedScene& scene);

  // Returns the edges with this vertex as their lower (upper) end; there are none for an invalid vertex.
  [[nodiscard]] std::span<const EdgeId> ending_at(PointId p) const { return range(by_bottom_, bottom_begin_, p); }
  [[nodiscard]] std::span<const EdgeId> starting_at(PointId p) const { return range(by_top_, top_begin_, p); }

  // Returns whether vertices at different positions of the input fall on this point.
  [[nodiscard]] bool has_several_vertices(PointId p) const { return several_vertices_[p.index()] != 0; }

 private:
  static std::span<const EdgeId> range(const std::vector<EdgeId>& edges, const std::vector<std::uint32_t>& begin,
                                       PointId p) {
    if (!p.valid()) return {};
    return std::span(edges).subspan(begin[p.index()], begin[p.index() + 1] - begin[p.index()]);
  }
  void find_several_vertices(const ProjectedScene& scene);

  std::vector<EdgeId> by_top_, by_bottom_;
  std::vector<std::uint32_t> top_begin_, bottom_begin_;
  std::vector<std::uint8_t> several_vertices_;
};

}  // namespace sightline::inline sweep
