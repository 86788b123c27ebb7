#include "sweep/segments/validate_crossings.h"

#include "geometry/numbers/id_names.h"
#include "sweep/segments/crossing_point.h"

namespace sightline::inline sweep {
namespace {

using Messages = std::vector<std::string>;

// Returns whether the ends of b lie strictly on different sides of a.
bool separates(const ProjectedScene& scene, EdgeId a, EdgeId b) {
  const auto side = [&](PointId p) {
    return orientation(scene.point(scene.edge(a).top), scene.point(scene.edge(a).bottom), scene.point(p));
  };
  return side(scene.edge(b).top) * side(scene.edge(b).bottom) < 0;
}

class CrossingCheck {
 public:
  CrossingCheck(const VisibleSegments& segments, const ProjectedScene& scene, Messages& messages)
      : segments_(segments), scene_(scene), messages_(messages) {}

  void run() {
    for (std::size_t c = 0; c < segments_.crossings.size(); ++c) {
      const Crossing& crossing = segments_.crossings[c];
      if (!cross_inside_both(scene_, crossing.a, crossing.b)) {
        messages_.push_back(crossing_name(c) + " is of " + name(crossing.a) + " and " + name(crossing.b) +
                            ", which do not cross inside both");
      } else {
        check_place(c);
      }
    }
  }

 private:
  void check_place(std::size_t c) {
    const CrossingPoint point = place(c);
    const std::size_t after = segments_.crossings[c].after.index();
    if ((after > 0 && sweep_compare(point, scene_.points[after - 1]) <= 0) ||
        (after < scene_.points.size() && sweep_compare(point, scene_.points[after]) >= 0))
      messages_.push_back(crossing_name(c) + " is not where it should be between the scene's points");
    if (has_previous_ && sweep_compare(previous_, point) >= 0)
      messages_.push_back(crossing_name(c) + " does not follow the one before it in sweep order");
    previous_ = point;
    has_previous_ = true;
  }

  [[nodiscard]] CrossingPoint place(std::size_t c) const {
    const SceneEdge& a = scene_.edge(segments_.crossings[c].a);
    const SceneEdge& b = scene_.edge(segments_.crossings[c].b);
    return crossing_point(scene_.point(a.top), scene_.point(a.bottom), scene_.point(b.top), scene_.point(b.bottom));
  }

  const VisibleSegments& segments_;
  const ProjectedScene& scene_;
  Messages& messages_;
  CrossingPoint previous_;
  bool has_previous_ = false;
};

}  // namespace

bool cross_inside_both(const ProjectedScene& scene, EdgeId a, EdgeId b) {
  return separates(scene, a, b) && separates(scene, b, a);
}

void check_crossings(const VisibleSegments& segments, const ProjectedScene& scene, std::vector<std::string>& messages) {
  CrossingCheck(segments, scene, messages).run();
}

}  // namespace sightline::inline sweep
