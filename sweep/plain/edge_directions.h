// Each edge of the projected scene has its direction here, in the sweep's arithmetic.
#pragma once

#include <vector>

#include "geometry/projection/projected_scene.h"

namespace sightline::inline sweep {

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
