#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "bench/generated_scenes.h"
#include "bench/scene_parts.h"

namespace sightline::bench {
namespace {

// Every layer once, in random order.
std::vector<std::size_t> shuffled_layers(std::size_t count, Random& random) {
  std::vector<std::size_t> layers(count);
  std::iota(layers.begin(), layers.end(), std::size_t{0});
  for (std::size_t i = count; i > 1; --i) std::swap(layers[i - 1], layers[random.below(i)]);
  return layers;
}

// Corners on a circle, a third of it apart but for 45 degrees each way: 1.05 radius^2 is the mean area. They keep off the
// fifth of the layer at its top and bottom, which is more than rounding moves them by.
void add_soup_triangle(std::vector<Point3>& vertices, double radius, double layer_low, double layer_depth,
                       Random& random) {
  const double x = random.between(-1, 1);
  const double y = random.between(-1, 1);
  const double turn = random.between(0, 2 * std::numbers::pi);
  for (int corner = 0; corner < 3; ++corner) {
    const double angle =
        turn + 2 * std::numbers::pi * corner / 3 + random.between(-std::numbers::pi / 4, std::numbers::pi / 4);
    vertices.push_back(as_in_a_file({x + radius * std::cos(angle), y + radius * std::sin(angle),
                                     layer_low + layer_depth * random.between(0.2, 0.8)}));
  }
}

Mesh soup(std::size_t triangles, double radius) {
  Random random(triangles);
  const double depth = 2 / static_cast<double>(triangles);
  std::vector<Point3> vertices;
  PolygonList faces;
  for (const std::size_t layer : shuffled_layers(triangles, random)) {
    add_soup_triangle(vertices, radius, static_cast<double>(layer) * depth - 1, depth, random);
    add_triangle(faces, vertices.size() - 3, vertices.size() - 2, vertices.size() - 1);
  }
  return build_mesh(std::move(vertices), std::move(faces));
}

}  // namespace

// n 1.05 radius^2 is five times the box's front, which has the area 4.
Mesh shrinking_soup(std::size_t triangles) { return soup(triangles, std::sqrt(19 / static_cast<double>(triangles))); }

Mesh deep_soup(std::size_t triangles) { return soup(triangles, 0.15); }

}  // namespace sightline::bench
