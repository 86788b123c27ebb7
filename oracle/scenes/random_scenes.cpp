#include "oracle/scenes/random_scenes.h"

#include <algorithm>

#include "oracle/scenes/scene_shapes.h"

namespace sightline::lattice {
namespace {

void add_something(SceneBuilder& scene, Dice& dice, bool quadrangles) {
  const int choice = dice.between(1, 20);
  if (choice <= 6) return add_shadow(scene, dice);
  if (choice <= 8) return add_triangle(scene, dice);
  if (choice <= 11) return add_polygon(scene, dice, some_points(scene, dice, 3));
  if (choice <= 13) return add_coplanar(scene, dice);
  if (choice <= 15) return add_fan(scene, dice);
  if (choice <= 17) return add_strip(scene, dice);
  if (choice == 18) return add_tetrahedron(scene, dice);
  if (choice == 19) return add_box(scene, dice);
  if (quadrangles) add_quadrangle(scene, dice);
}

}  // namespace

RandomScene random_scene(std::uint64_t seed) {
  Dice dice(seed);
  SceneBuilder builder(random_lattice(dice), dice);
  const auto wanted = static_cast<std::size_t>(std::max(dice.between(3, 12), dice.between(6, 12)));
  const bool quadrangles = dice.one_in(4);
  for (int attempt = 0; builder.faces().size() < wanted && attempt < 200; ++attempt) {
    add_something(builder, dice, quadrangles);
  }
  return scene_of(builder, seed, dice.one_in(4) ? Sides::front : Sides::both, 12);
}

}  // namespace sightline::lattice
