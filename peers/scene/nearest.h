// The nearest of several polygons at one place.
//
// In:  polygons of a flat scene by number, each with its depth at the place, in any order.
// Out: the nearest; where computed depths are equal, the one that comes first in the flat scene, so with the lower face
// index.
#pragma once

#include <cstdint>
#include <limits>

namespace sightline::peers {

// A polygon's number is its position in the flat scene.
using PolygonNumber = std::uint32_t;
constexpr PolygonNumber no_polygon = std::numeric_limits<PolygonNumber>::max();

struct Nearest {
  PolygonNumber polygon = no_polygon;
  double depth = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool found() const { return polygon != no_polygon; }
  void consider(PolygonNumber other, double its_depth) {
    if (its_depth < depth || (its_depth == depth && other < polygon)) *this = {other, its_depth};
  }
};

}  // namespace sightline::peers
