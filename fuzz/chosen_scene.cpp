#include "fuzz/chosen_scene.h"

#include <algorithm>
#include <cstdlib>

#include "fuzz/choices.h"
#include "oracle/lattice/lattice.h"

namespace sightline::fuzz {
namespace {

using lattice::Lattice;
using lattice::LatticePoint;

constexpr std::size_t most_faces = 8;

Lattice chosen_lattice(Choices& choices) {
  const int high = choices.between(0, 255);
  const int low = choices.between(0, 255);
  lattice::Dice dice(static_cast<std::uint64_t>(256 * high + low));
  return lattice::random_lattice(dice);
}

// Its image is a whole number, or, where the point is further than 1 from a pinhole, a fraction if `fine`.
LatticePoint chosen_point(const Lattice& lattice, bool fine, Choices& choices) {
  const int depth = choices.any_of(lattice.depths);
  const int spread = lattice.projection == Projection::perspective ? std::max(1, std::abs(depth)) : 1;
  const int step = fine ? 1 : spread;
  const int reach = lattice.reach * spread / step;
  const int x = choices.between(-reach, reach);
  const int y = choices.between(-reach, reach);
  return {x * step, y * step, depth};
}

// Returns a vertex that is there already, or a new one, which may have an old one's place.
std::uint32_t chosen_vertex(std::vector<LatticePoint>& points, const Lattice& lattice, Choices& choices) {
  constexpr int old = 128;
  const int choice = choices.between(0, 255);
  if (choice < old && !points.empty())
    return static_cast<std::uint32_t>(static_cast<std::size_t>(choice) % points.size());
  points.push_back(chosen_point(lattice, choice % 8 == 7, choices));
  return static_cast<std::uint32_t>(points.size() - 1);
}

}  // namespace

lattice::RandomScene chosen_scene(std::string_view bytes) {
  Choices choices(bytes);
  const Lattice lattice = chosen_lattice(choices);
  lattice::RandomScene scene;
  scene.camera = lattice.camera;
  scene.sides = choices.between(0, 3) == 3 ? Sides::front : Sides::both;
  std::vector<LatticePoint> points;
  while (choices.any_left() && scene.faces.size() < most_faces) {
    std::vector<std::uint32_t> corners(static_cast<std::size_t>(choices.between(3, 5)));
    for (std::uint32_t& corner : corners) corner = chosen_vertex(points, lattice, choices);
    scene.faces.push_back(corners);
  }
  for (const LatticePoint& p : points) scene.vertices.push_back(lattice::position(lattice, p));
  return scene;
}

}  // namespace sightline::fuzz
