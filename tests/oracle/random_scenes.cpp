#include "tests/oracle/random_scenes.h"

#include <algorithm>
#include <array>

#include "tests/oracle/scene_builder.h"

namespace sightline::oracle {
namespace {

// A corner that is there, one before or behind it, the middle of two, or a new one.
LatticePoint old_or_new_point(const SceneBuilder& scene, Dice& dice) {
  if (scene.points().empty()) return random_point(scene.lattice(), dice);
  const LatticePoint old = dice.any_of(scene.points());
  const int choice = dice.between(1, 12);
  if (choice <= 4) return old;
  if (choice <= 7) return in_line(scene.lattice(), old, dice);
  if (choice <= 11) return between(scene.lattice(), old, dice.any_of(scene.points()));
  return random_point(scene.lattice(), dice);
}

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

std::int64_t volume(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c, const LatticePoint& d) {
  const auto u = std::array{b.x - a.x, b.y - a.y, b.depth - a.depth};
  const auto v = std::array{c.x - a.x, c.y - a.y, c.depth - a.depth};
  const auto w = std::array{d.x - a.x, d.y - a.y, d.depth - a.depth};
  return std::int64_t{u[0]} * (v[1] * w[2] - v[2] * w[1]) + std::int64_t{u[1]} * (v[2] * w[0] - v[0] * w[2]) +
         std::int64_t{u[2]} * (v[0] * w[1] - v[1] * w[0]);
}

void add_triangle(SceneBuilder& scene, Dice& dice) { scene.add({vertices(scene, some_points(scene, dice, 3))}); }

// Four to six corners, whatever shape comes, in a plane of three points.
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

// In the plane of a face that is there already.
void add_coplanar(SceneBuilder& scene, Dice& dice) {
  if (scene.faces().empty()) return;
  const Corners corners = dice.any_of(scene.faces());
  add_polygon(scene, dice, {scene.points()[corners[0]], scene.points()[corners[1]], scene.points()[corners[2]]});
}

// Before or behind a face that is there, so that their edges coincide in the image; one corner may be another.
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

// Outside seen counter-clockwise: camera space is left-handed, so a negative volume is the usual one.
void add_tetrahedron(SceneBuilder& scene, Dice& dice) {
  std::vector<LatticePoint> p = some_points(scene, dice, 4);
  const std::int64_t v = volume(p[0], p[1], p[2], p[3]);
  if (v == 0) return;
  if (v > 0) std::swap(p[0], p[1]);
  const Corners c = vertices(scene, p);
  scene.add({{c[0], c[1], c[2]}, {c[0], c[3], c[1]}, {c[1], c[3], c[2]}, {c[2], c[3], c[0]}});
}

// A box along the axes of the view.
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

// Leaves out the vertices that no face uses, except the first of them.
void drop_unused_vertices(RandomScene& scene) {
  std::vector<bool> used(scene.vertices.size());
  for (const Corners& corners : scene.faces) {
    for (const std::uint32_t c : corners) used[c] = true;
  }
  const auto kept = std::find(used.begin(), used.end(), false);
  if (kept != used.end()) *kept = true;
  std::vector<std::uint32_t> index(used.size());
  std::vector<Point3> vertices;
  for (std::size_t v = 0; v < used.size(); ++v) {
    index[v] = static_cast<std::uint32_t>(vertices.size());
    if (used[v]) vertices.push_back(scene.vertices[v]);
  }
  for (Corners& corners : scene.faces) {
    for (std::uint32_t& c : corners) c = index[c];
  }
  scene.vertices = std::move(vertices);
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
  RandomScene scene{seed, builder.lattice().camera, dice.one_in(4) ? Sides::front : Sides::both,
                    {},   builder.faces(),          builder.notes()};
  for (const LatticePoint& p : builder.points()) scene.vertices.push_back(position(builder.lattice(), p));
  if (scene.faces.size() > 12) scene.faces.resize(12);
  drop_unused_vertices(scene);
  return scene;
}

}  // namespace sightline::oracle
