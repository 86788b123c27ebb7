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

// Each edge has its direction here, in the sweep's arithmetic.
template <class Decisions>
class EdgeDirections {
 public:
  explicit EdgeDirections(const ProjectedScene& scene) {
    direction_.reserve(scene.edge_count());
    for (std::size_t e = 0; e < scene.edge_count(); ++e) {
      direction_.push_back(Decisions::direction(scene.point(scene.edges[e].top), scene.point(scene.edges[e].bottom)));
    }
  }

  // Returns +1 where, below a common point, a lies left of b; 0 where they lie on each other.
  [[nodiscard]] Sign turn(EdgeId a, EdgeId b) const {
    return Decisions::turn(direction_[a.index()], direction_[b.index()]);
  }

 private:
  std::vector<typename Decisions::Direction> direction_;
};

}  // namespace sightline::inline sweep
