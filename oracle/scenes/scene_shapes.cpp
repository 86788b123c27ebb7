#include "oracle/scenes/scene_shapes.h"

#include <algorithm>
#include <array>

namespace sightline::lattice {
namespace {

// Returns a corner that is there, one before or behind it, the middle of two, or a new one.
LatticePoint old_or_new_point(const SceneBuilder& scene, Dice& dice) {
  if (scene.points().empty()) return random_point(scene.lattice(), dice);
  const LatticePoint old = dice.any_of(scene.points());
  const int choice = dice.between(1, 12);
  if (choice <= 4) return old;
  if (choice <= 7) return in_line(scene.lattice(), old, dice);
  if (choice <= 11) return between(scene.lattice(), old, dice.any_of(scene.points()));
  return random_point(scene.lattice(), dice);
}

std::int64_t volume(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c, const LatticePoint& d) {
  const auto u = std::array{b.x - a.x, b.y - a.y, b.depth - a.depth};
  const auto v = std::array{c.x - a.x, c.y - a.y, c.depth - a.depth};
  const auto w = std::array{d.x - a.x, d.y - a.y, d.depth - a.depth};
  return std::int64_t{u[0]} * (v[1] * w[2] - v[2] * w[1]) + std::int64_t{u[1]} * (v[2] * w[0] - v[0] * w[2]) +
         std::int64_t{u[2]} * (v[0] * w[1] - v[1] * w[0]);
}

}  // namespace

std::vector<LatticePoint> some_points(const SceneBuilder& scene, Dice& dice, int count) {
  std::vector<LatticePoint> result;
  for (int i = 0; i < count; ++i) result.push_back(old_or_new_point(scene, dice));
  return result;
}

Corners vertices(SceneBuilder& scene, const std::vector<LatticePoint>& points) {
  Corners result;
  for (const LatticePoint& p : points) result.push_back(scene.vertex(p));
  return result;
}

void add_triangle(SceneBuilder& scene, Dice& dice) { scene.add({vertices(scene, some_points(scene, dice, 3))}); }

void add_polygon(SceneBuilder& scene, Dice& dice, const std::vector<LatticePoint>& three) {
  const std::vector<LatticePoint> all = all_points(scene.lattice());
  std::vector<LatticePoint> in_plane;
  for (const LatticePoint& p : all) {
    if (volume(three[0], three[1], three[2], p) == 0) in_plane.push_back(p);
  }
  if (in_plane.size() < 4 || in_plane.size() == all.size()) return;
  for (int attempt = 0; attempt < 8; ++attempt) {
    std::vector<LatticePoint> corners;
    const int count = dice.between(4, 6);
    for (int i = 0; i < count; ++i) corners.push_back(dice.any_of(in_plane));
    std::sort(corners.begin(), corners.end());
    if (std::adjacent_find(corners.begin(), corners.end()) != corners.end()) continue;
    for (int i = count - 1; i > 0; --i) {
      std::swap(corners[static_cast<std::size_t>(i)], corners[static_cast<std::size_t>(dice.between(0, i))]);
    }
    if (scene.add({vertices(scene, corners)})) return;
  }
}

void add_coplanar(SceneBuilder& scene, Dice& dice) {
  if (scene.faces().empty()) return;
  const Corners corners = dice.any_of(scene.faces());
  add_polygon(scene, dice, {scene.points()[corners[0]], scene.points()[corners[1]], scene.points()[corners[2]]});
}

void add_shadow(SceneBuilder& scene, Dice& dice) {
  if (scene.faces().empty()) return;
  std::vector<LatticePoint> corners;
  for (const std::uint32_t c : dice.any_of(scene.faces())) {
    corners.push_back(in_line(scene.lattice(), scene.points()[c], dice));
  }
  if (dice.one_in(2)) corners.front() = old_or_new_point(scene, dice);
  if (dice.one_in(2)) std::reverse(corners.begin(), corners.end());
  scene.add({vertices(scene, corners)});
}

void add_quadrangle(SceneBuilder& scene, Dice& dice) { scene.add({vertices(scene, some_points(scene, dice, 4))}); }

void add_fan(SceneBuilder& scene, Dice& dice) {
  const Corners c = vertices(scene, some_points(scene, dice, 6));
  for (std::size_t i = 1; i + 1 < c.size(); ++i) scene.add({{c[0], c[i], c[i + 1]}});
}

void add_strip(SceneBuilder& scene, Dice& dice) {
  const Corners c = vertices(scene, some_points(scene, dice, 6));
  for (std::size_t i = 0; i + 2 < c.size(); ++i) {
    scene.add({i % 2 == 0 ? Corners{c[i], c[i + 1], c[i + 2]} : Corners{c[i + 1], c[i], c[i + 2]}});
  }
}

// Faces are counter-clockwise seen from outside: camera space is left-handed, so a negative volume is the usual one.
void add_tetrahedron(SceneBuilder& scene, Dice& dice) {
  std::vector<LatticePoint> p = some_points(scene, dice, 4);
  const std::int64_t v = volume(p[0], p[1], p[2], p[3]);
  if (v == 0) return;
  if (v > 0) std::swap(p[0], p[1]);
  const Corners c = vertices(scene, p);
  scene.add({{c[0], c[1], c[2]}, {c[0], c[3], c[1]}, {c[1], c[3], c[2]}, {c[2], c[3], c[0]}});
}

void add_box(SceneBuilder& scene, Dice& dice) {
  const LatticePoint a = old_or_new_point(scene, dice);
  const LatticePoint b = old_or_new_point(scene, dice);
  if (a.x >= b.x || a.y >= b.y || a.depth >= b.depth) return;
  const Corners c = vertices(scene, {{a.x, a.y, b.depth},
                                     {b.x, a.y, b.depth},
                                     {b.x, b.y, b.depth},
                                     {a.x, b.y, b.depth},
                                     {a.x, a.y, a.depth},
                                     {b.x, a.y, a.depth},
                                     {b.x, b.y, a.depth},
                                     {a.x, b.y, a.depth}});
  scene.add({{c[4], c[5], c[6], c[7]},
             {c[3], c[2], c[1], c[0]},
             {c[0], c[1], c[5], c[4]},
             {c[1], c[2], c[6], c[5]},
             {c[2], c[3], c[7], c[6]},
             {c[3], c[0], c[4], c[7]}});
}

}  // namespace sightline::lattice
