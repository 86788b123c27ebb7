// Which of two edges is left of the other below a common point, whoever knows it: the grid, or an unrounded scene.
#pragma once

#include "geometry/projection/projected_scene.h"
#include "sweep/segments/image_decisions.h"

namespace sightline::inline sweep {

class EdgeTurns {
 public:
  virtual ~EdgeTurns() = default;

  // Returns +1 where, below a common point, a lies left of b; 0 where they lie on each other.
  [[nodiscard]] virtual Sign turn(EdgeId a, EdgeId b) const = 0;
};

// Of a scene whose points were rounded to the grid, exactly.
class GridTurns final : public EdgeTurns {
 public:
  explicit GridTurns(const ProjectedScene& scene) : scene_(scene) {}
  [[nodiscard]] Sign turn(EdgeId a, EdgeId b) const override {
    return ExactDecisions::turn(direction(a), direction(b));
  }

 private:
  [[nodiscard]] ImagePoint direction(EdgeId e) const {
    return ExactDecisions::direction(scene_.point(scene_.edge(e).top), scene_.point(scene_.edge(e).bottom));
  }

  const ProjectedScene& scene_;
};

}  // namespace sightline::inline sweep
