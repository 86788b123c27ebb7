#include "peers/pixels/ray_casting.h"

#include <limits>

#include "peers/errors/pixel_cover.h"

namespace sightline::peers {
namespace {

struct Obstacle {
  const FlatPolygon* polygon = nullptr;
  Extent extent;
};

std::vector<Obstacle> obstacles_of(const FlatScene& scene) {
  std::vector<Obstacle> obstacles;
  for (const FlatPolygon& polygon : scene.polygons) obstacles.push_back({&polygon, extent_of(polygon.corners)});
  return obstacles;
}

// Returns those that a ray at this height may meet.
std::vector<Obstacle> at_height(const std::vector<Obstacle>& obstacles, double y) {
  std::vector<Obstacle> met;
  for (const Obstacle& obstacle : obstacles) {
    if (obstacle.extent.least.y <= y && y <= obstacle.extent.most.y) met.push_back(obstacle);
  }
  return met;
}

// The rays of the normalized view volume are parallel: each has one x and y, and comes from depth minus infinity.
class RayCaster {
 public:
  FaceId first_hit(const std::vector<Obstacle>& obstacles, const Point2& ray) {
    ++rays_;
    FaceId hit;
    double nearest = std::numeric_limits<double>::infinity();
    for (const Obstacle& obstacle : obstacles) {
      if (ray.x < obstacle.extent.least.x || obstacle.extent.most.x < ray.x) continue;
      ++tests_;
      const double depth = obstacle.polygon->plane.at(ray.x, ray.y);
      if (!(depth < nearest) || !covers(obstacle.polygon->corners, ray)) continue;
      nearest = depth;
      hit = obstacle.polygon->face;
    }
    return hit;
  }

  [[nodiscard]] std::vector<Count> counts() const {
    return {{"rays", rays_}, {"rays tested against polygons", tests_}};
  }

 private:
  std::uint64_t rays_ = 0;
  std::uint64_t tests_ = 0;
};

Outcome cast_rays(const FlatScene& scene, int resolution) {
  ItemBuffer buffer(resolution);
  RayCaster caster;
  const std::vector<Obstacle> obstacles = obstacles_of(scene);
  for (int row = 0; row < resolution; ++row) {
    const std::vector<Obstacle> met = at_height(obstacles, buffer.y_of(row));
    for (int column = 0; column < resolution; ++column) {
      buffer.paint(column, row, caster.first_hit(met, {buffer.x_of(column), buffer.y_of(row)}));
    }
  }
  return {std::move(buffer), caster.counts()};
}

}  // namespace

Peer ray_casting() {
  return {
      "ray-casting",
      "Ray casting",
      "Koucký 2014, section 2.2; Fang 1993, section 2.3; slides 001, generic image precision algorithm",
      ComputedAt::image_precision,
      "Sends one ray from the eye through the centre of each pixel and tests it against every polygon whose screen "
      "extent it passes through. The pixel gets the face of the nearest polygon that the ray meets. Each pixel is "
      "decided for itself, by no more than the definition of what is visible.",
      "It sees only what lies under the centres of pixels: a face that is thinner than a pixel appears in some pixels "
      "and not in others, and one between the centres is missed altogether. Along each edge of what is visible whole "
      "pixels go to one side, so the areas are wrong by parts of the pixels along those edges: more pixels make the "
      "error smaller, and never zero.",
      cast_rays};
}

}  // namespace sightline::peers
