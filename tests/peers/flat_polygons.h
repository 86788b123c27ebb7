// Flat scenes made by hand: each polygon by its plane and its corners' places in the window.
//
// In:  polygons, the first of face 0. Out: a flat scene without a mesh, which is enough for peers at image precision.
#pragma once

#include <utility>
#include <vector>

#include "peers/scene/flat_scene.h"

namespace sightline::tests {

struct PlacedPolygon {
  peers::DepthPlane plane;
  std::vector<Point2> corners;  // counter-clockwise
};

[[nodiscard]] inline peers::FlatScene flat_scene_of(const std::vector<PlacedPolygon>& polygons) {
  peers::FlatScene scene;
  for (const PlacedPolygon& placed : polygons) {
    const std::size_t number = scene.polygons.size();
    peers::FlatPolygon polygon{FaceId(number), FacetId(number), true, placed.plane, {}};
    for (const Point2& p : placed.corners) polygon.corners.push_back({p.x, p.y, placed.plane.at(p.x, p.y)});
    scene.polygons.push_back(std::move(polygon));
  }
  return scene;
}

[[nodiscard]] inline std::vector<Point2> rectangle(const Point2& low, const Point2& high) {
  return {low, {high.x, low.y}, high, {low.x, high.y}};
}

}  // namespace sightline::tests
