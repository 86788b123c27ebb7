// The sweep's planar tests, in a scene's arithmetic and exactly, for edges and points by their ids.
//
// Out: the signs that image_decisions.h gives in exact, float or double.
#pragma once

#include <optional>

#include "sweep/segments/image_decisions.h"

namespace sightline::trace {

struct ImageSign {
  Sign sign = 0;
  std::optional<Sign> exact;  // where it differs
};

// `ask` is a function of a decisions policy.
template <class Ask>
[[nodiscard]] ImageSign image_sign(Arithmetic arithmetic, const Ask& ask) {
  const Sign exact = ask(ExactDecisions{});
  if (arithmetic == Arithmetic::exact) return {exact, std::nullopt};
  const Sign sign = arithmetic == Arithmetic::single_precision ? ask(UnfilteredDecisions<float>{})
                                                               : ask(UnfilteredDecisions<double>{});
  return {sign, sign == exact ? std::nullopt : std::optional<Sign>(exact)};
}

[[nodiscard]] inline ImageSign side_of_edge(const ProjectedScene& scene, EdgeId edge, PointId point) {
  const SceneEdge& e = scene.edge(edge);
  return image_sign(scene.arithmetic, [&](auto decisions) {
    return decisions.side(scene.point(e.top), scene.point(e.bottom), scene.point(point));
  });
}

[[nodiscard]] inline ImageSign turn_of_edges(const ProjectedScene& scene, EdgeId a, EdgeId b) {
  return image_sign(scene.arithmetic, [&](auto decisions) {
    const auto direction = [&](EdgeId e) {
      return decisions.direction(scene.point(scene.edge(e).top), scene.point(scene.edge(e).bottom));
    };
    return decisions.turn(direction(a), direction(b));
  });
}

}  // namespace sightline::trace
