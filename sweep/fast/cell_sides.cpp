#include "sweep/fast/cell_sides.h"

#include <cmath>
#include <cstdlib>

namespace sightline::inline sweep {

// The centre of a cell has fewer than 53 bits.
Sign CellSides::unrounded_orientation(PointId a, PointId b, const ImagePoint& centre) const {
  const auto window = [this](std::int64_t c) { return std::ldexp(static_cast<double>(c), -scene_.grid_bits); };
  const auto sign =
      certain_orientation(points_.certified(a), points_.certified(b), {window(centre.x), window(centre.y), 0});
  if (sign) return *sign;
  return geometry::orientation(points_.exact(a), points_.exact(b),
                               {centre.x, centre.y, BigInteger(1) << static_cast<unsigned>(scene_.grid_bits)});
}

// What is exactly on one side of the border is so on the grid, too.
bool CellSides::is_on_border(PointId a, PointId b) const {
  const std::int64_t half_window = std::int64_t{1} << scene_.grid_bits;
  const ImagePoint& p = scene_.point(a);
  const ImagePoint& q = scene_.point(b);
  const bool along_y = p.x == q.x && std::abs(p.x) == half_window;
  const bool along_x = p.y == q.y && std::abs(p.y) == half_window;
  if (!scene_.is_unrounded() || (!along_x && !along_y)) return along_x || along_y;
  const ExactPlace from = points_.exact(a);
  const ExactPlace to = points_.exact(b);
  return (along_y && abs(from.x) == from.w && abs(to.x) == to.w) ||
         (along_x && abs(from.y) == from.w && abs(to.y) == to.w);
}

}  // namespace sightline::inline sweep
