#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "bench/scenes/generated_scenes.h"
#include "bench/scenes/scene_parts.h"

namespace sightline::bench {
namespace {

// Each triangle lies in a ball, and the ball in a cell of its own: a cube with this many radii to an edge, in which it
// leaves some room. Fewer cells than there are have one.
constexpr double cell_in_radii = 2.5;
constexpr double shake_in_radii = 0.15;
constexpr double share_of_cells = 0.7;

using Triangle = std::array<Point3, 3>;

Vector3 random_direction(Random& random) {
  for (;;) {
    const Vector3 v{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    const double length = norm(v);
    if (length > 0.1 && length < 1) return (1 / length) * v;
  }
}

// The corners are on a circle around the middle, in a random plane: a third of it apart but for 45 degrees each way.
Triangle random_triangle(const Point3& middle, double radius, Random& random) {
  const Vector3 u = random_direction(random);
  const Vector3 across = u.cross(random_direction(random));
  const Vector3 v = (1 / norm(across)) * across;
  Triangle triangle;
  for (int corner = 0; corner < 3; ++corner) {
    const double shift = random.between(-std::numbers::pi / 4, std::numbers::pi / 4);
    const double angle = 2 * std::numbers::pi * corner / 3 + shift;
    triangle[static_cast<std::size_t>(corner)] =
        middle + (radius * std::cos(angle)) * u + (radius * std::sin(angle)) * v;
  }
  return triangle;
}

// The cells of a layer begin anywhere, so that no two layers have theirs at the same places.
void fill_layer(std::vector<Triangle>& triangles, double layer, double radius, Random& random) {
  const double cell = cell_in_radii * radius;
  const double first_x = random.between(-1, cell - 1);
  const double first_y = random.between(-1, cell - 1);
  const auto shake = [&] { return radius * random.between(-shake_in_radii, shake_in_radii); };
  for (double y = first_y; y < 1; y += cell) {
    for (double x = first_x; x < 1; x += cell) {
      if (random.unit() > share_of_cells) continue;
      const Point3 middle{x + shake(), y + shake(), (layer + 0.5) * cell + shake()};
      triangles.push_back(random_triangle(middle, radius, random));
    }
  }
}

void shuffle(std::vector<Triangle>& triangles, Random& random) {
  for (std::size_t i = triangles.size(); i > 1; --i) std::swap(triangles[i - 1], triangles[random.below(i)]);
}

// The soup has as many layers as it takes, pressed together to the box's depth: that changes neither what is in front
// of what nor which planes part which triangles.
Mesh soup(std::size_t count, double radius) {
  Random random(count);
  std::vector<Triangle> triangles;
  double layers = 0;
  for (; triangles.size() < count; ++layers) fill_layer(triangles, layers, radius, random);
  triangles.resize(count);
  shuffle(triangles, random);
  const double scale = 2 / (layers * cell_in_radii * radius);
  std::vector<Point3> vertices;
  PolygonList faces;
  for (const Triangle& triangle : triangles) {
    for (const Point3& p : triangle) vertices.push_back(as_in_a_file({p.x(), p.y(), scale * p.z() - 1}));
    add_triangle(faces, vertices.size() - 3, vertices.size() - 2, vertices.size() - 1);
  }
  return build_mesh(std::move(vertices), std::move(faces));
}

}  // namespace

// The mean area of a triangle is 1.05 radius^2, and half of that seen along an axis. The box's front has the area 4.
Mesh shrinking_soup(std::size_t triangles) { return soup(triangles, std::sqrt(38 / static_cast<double>(triangles))); }

Mesh deep_soup(std::size_t triangles) { return soup(triangles, 0.2); }

}  // namespace sightline::bench
