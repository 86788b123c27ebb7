#include "oracle/scenes/crossing_scenes.h"

#include <algorithm>
#include <array>

#include "oracle/scenes/scene_shapes.h"

namespace sightline::lattice {
namespace {

// A centre has a near and a far depth, and a place in the image where what runs from one to the other is halfway.
struct Centre {
  int x = 0;
  int y = 0;
  int near = 0;
  int far = 0;
};

Centre random_centre(const Lattice& lattice, Dice& dice) {
  Centre centre{dice.between(-1, 1), dice.between(-1, 1), 0, 0};
  if (lattice.projection == Projection::orthographic) {
    const auto [near, far] = dice.any_of(std::array{std::array{0, 3}, std::array{1, 2}, std::array{0, 2}});
    return {centre.x, centre.y, near, far};
  }
  std::vector<int> depths = lattice.depths;
  std::erase_if(depths, [](int depth) { return depth <= 0; });
  const auto [near, far] = std::minmax({dice.any_of(depths), dice.any_of(depths)});
  return {centre.x, centre.y, near, far};
}

// Adds a parallelogram or triangle around the centre, near on one side and far on the other.
void add_through(SceneBuilder& scene, Dice& dice, const Centre& centre) {
  const int reach = std::max(1, scene.lattice().reach);
  const auto step = [&] { return dice.between(-reach, reach); };
  const std::array<int, 2> u{step(), step()};
  const std::array<int, 2> v{step(), step()};
  const auto corner = [&](int along_u, int along_v) {
    return at_image(scene.lattice(), centre.x + along_u * u[0] + along_v * v[0],
                    centre.y + along_u * u[1] + along_v * v[1], along_u > 0 ? centre.near : centre.far);
  };
  std::vector<LatticePoint> corners{corner(1, -1), corner(1, 1), corner(-1, 1), corner(-1, -1)};
  if (dice.one_in(4)) corners = {corner(1, -1), corner(1, 1), corner(-1, 0)};
  scene.add({vertices(scene, corners)});
}

// Adds a face that is there a second time, with what is near far and what is far near: both have the same edges in the
// image.
void add_exchanged(SceneBuilder& scene, Dice& dice) {
  if (scene.faces().empty()) return;
  std::vector<LatticePoint> corners;
  for (const std::uint32_t c : dice.any_of(scene.faces())) corners.push_back(scene.points()[c]);
  const auto by_depth = [](const LatticePoint& p, const LatticePoint& q) { return p.depth < q.depth; };
  const auto [nearest, farthest] = std::minmax_element(corners.begin(), corners.end(), by_depth);
  const int near = nearest->depth;
  const int far = farthest->depth;
  if (near <= 0 && scene.lattice().projection == Projection::perspective) return;
  for (LatticePoint& p : corners) {
    if (p.depth != near && p.depth != far) return;
    p = at_depth(scene.lattice(), p, p.depth == near ? far : near);
  }
  scene.add({vertices(scene, corners)});
}

void add_something(SceneBuilder& scene, Dice& dice, const std::array<Centre, 2>& centres) {
  const int choice = dice.between(1, 24);
  if (choice <= 9) return add_through(scene, dice, centres[0]);
  if (choice <= 11) return add_through(scene, dice, centres[1]);
  if (choice <= 14) return add_exchanged(scene, dice);
  if (choice <= 16) return add_shadow(scene, dice);
  if (choice <= 18) return add_triangle(scene, dice);
  if (choice <= 20) return add_polygon(scene, dice, some_points(scene, dice, 3));
  if (choice == 21) return add_coplanar(scene, dice);
  if (choice == 22) return add_strip(scene, dice);
  if (choice == 23) return add_box(scene, dice);
  add_quadrangle(scene, dice);
}

}  // namespace

RandomScene crossing_scene(std::uint64_t seed) {
  Dice dice(seed);
  Lattice lattice = random_lattice(dice);
  lattice.reach = std::max(lattice.reach, dice.between(1, 2));
  const std::array centres{random_centre(lattice, dice), random_centre(lattice, dice)};
  SceneBuilder builder(lattice, dice, Crossings::allowed);
  const auto wanted = static_cast<std::size_t>(dice.between(3, 8));
  for (int attempt = 0; builder.faces().size() < wanted && attempt < 200; ++attempt) {
    add_something(builder, dice, centres);
  }
  return scene_of(builder, seed, dice.one_in(4) ? Sides::front : Sides::both, 8);
}

}  // namespace sightline::lattice
