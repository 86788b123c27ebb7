#include "reflect/regions/sheets.h"

#include <cmath>

namespace sightline::inline reflect {

void Sheets::add(const ImagePolygon& polygon, double height) {
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const std::array corners{corner(polygon[0], height), corner(polygon[i], height), corner(polygon[i + 1], height)};
    faces_.push_back(corners);
  }
}

VertexId Sheets::corner(const ImagePoint& p, double height) {
  const auto coordinate = [this](std::int64_t grid) { return std::ldexp(static_cast<double>(grid), -grid_bits_); };
  vertices_.push_back({coordinate(p.x), coordinate(p.y), height});
  return VertexId(vertices_.size() - 1);
}

Camera straight_down() {
  Camera camera;
  camera.name = "straight down";
  camera.projection = Projection::orthographic;
  camera.right = {1, 0, 0};
  camera.up = {0, 1, 0};
  camera.forward = {0, 0, -1};
  camera.eye = {{0, 0, 1}, 0};
  return camera;
}

}  // namespace sightline::inline reflect
