#include "oracle/lattice/lattice.h"

#include <algorithm>
#include <array>

namespace sightline::lattice {
namespace {

Vector3 axis(int which, int sign) {
  return {which == 0 ? 1.0 * sign : 0, which == 1 ? 1.0 * sign : 0, which == 2 ? 1.0 * sign : 0};
}

// Returns image units per unit across the view: a point of a pinhole's view at depth w has image x / w.
int spread(const Lattice& lattice, int depth) {
  return lattice.projection == Projection::perspective ? std::max(1, depth < 0 ? -depth : depth) : 1;
}

Camera camera_of(const Lattice& lattice, const Point3& origin) {
  Camera camera;
  camera.name = "random";
  camera.projection = lattice.projection;
  camera.right = (1.0 / lattice.half) * lattice.right;
  camera.up = (1.0 / lattice.half) * lattice.up;
  camera.forward = lattice.forward;
  camera.origin = origin;
  camera.eye = {origin, 1};
  if (lattice.projection == Projection::orthographic) camera.eye = {-1.0 * lattice.forward, 0};
  return camera;
}

std::vector<int> random_depths(Projection projection, bool behind, Dice& dice) {
  if (projection == Projection::orthographic) return {0, 1, 2, 3};
  if (behind) return {-1, 0, 1, 1, 2};
  return dice.one_in(2) ? std::vector<int>{1, 2, 4} : std::vector<int>{1, 2};
}

}  // namespace

Lattice random_lattice(Dice& dice) {
  Lattice lattice;
  lattice.projection = dice.one_in(2) ? Projection::orthographic : Projection::perspective;
  lattice.half = dice.any_of(std::array{2, 2, 4, 8});
  const bool clipped = dice.one_in(4);
  lattice.reach = clipped ? 2 * lattice.half : dice.any_of(std::array{1, 1, 1, 2});
  lattice.depths = random_depths(lattice.projection, clipped && dice.one_in(2), dice);
  const int first = dice.between(0, 2);
  const int second = (first + dice.between(1, 2)) % 3;
  lattice.right = axis(first, dice.one_in(2) ? 1 : -1);
  lattice.up = axis(second, dice.one_in(2) ? 1 : -1);
  lattice.forward = lattice.up.cross(lattice.right);
  const auto step = [&] { return static_cast<double>(dice.between(-3, 3)); };
  lattice.camera = camera_of(lattice, {step(), step(), step()});
  return lattice;
}

LatticePoint random_point(const Lattice& lattice, Dice& dice) {
  const int depth = dice.any_of(lattice.depths);
  const int scale = spread(lattice, depth);
  if (dice.one_in(24)) {
    const int reach = lattice.reach * scale;
    return {dice.between(-reach, reach), dice.between(-reach, reach), depth};
  }
  return {dice.between(-lattice.reach, lattice.reach) * scale, dice.between(-lattice.reach, lattice.reach) * scale,
          depth};
}

LatticePoint at_image(const Lattice& lattice, int x, int y, int depth) {
  return {x * spread(lattice, depth), y * spread(lattice, depth), depth};
}

LatticePoint at_depth(const Lattice& lattice, const LatticePoint& p, int depth) {
  const int from = spread(lattice, p.depth);
  const int to = spread(lattice, depth);
  if (p.x * to % from != 0 || p.y * to % from != 0) return p;
  return {p.x * to / from, p.y * to / from, depth};
}

LatticePoint in_line(const Lattice& lattice, const LatticePoint& p, Dice& dice) {
  return at_depth(lattice, p, dice.any_of(lattice.depths));
}

LatticePoint between(const Lattice& lattice, const LatticePoint& p, const LatticePoint& q) {
  const LatticePoint sum{p.x + q.x, p.y + q.y, p.depth + q.depth};
  if (sum.x % 2 != 0 || sum.y % 2 != 0 || sum.depth % 2 != 0) return p;
  const LatticePoint middle{sum.x / 2, sum.y / 2, sum.depth / 2};
  const bool known = std::find(lattice.depths.begin(), lattice.depths.end(), middle.depth) != lattice.depths.end();
  return known ? middle : p;
}

Point3 position(const Lattice& lattice, const LatticePoint& p) {
  return lattice.camera.origin +
         (static_cast<double>(p.x) * lattice.right +
          (static_cast<double>(p.y) * lattice.up + static_cast<double>(p.depth) * lattice.forward));
}

std::vector<LatticePoint> all_points(const Lattice& lattice) {
  std::vector<LatticePoint> result;
  for (const int depth : lattice.depths) {
    const int scale = spread(lattice, depth);
    for (int x = -lattice.reach; x <= lattice.reach; ++x) {
      for (int y = -lattice.reach; y <= lattice.reach; ++y) result.push_back({x * scale, y * scale, depth});
    }
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

}  // namespace sightline::lattice
