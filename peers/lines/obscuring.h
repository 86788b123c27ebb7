// Which polygons obscure a line: the brute force that a seed needs, and the polygons around a vertex.
//
// In:  a flat scene, lines of it.
// Out: at a point of a line, how many polygons lie before it; and at a vertex, how many of the polygons that have it
//      hide the beginning of a line from there.
// A polygon never obscures its own edges. The line is thought moved aside a little (scene_lines.h), and the point
// towards the line's end. On which side of a polygon's plane a line lies is decided exactly on the input's
// coordinates; where it passes through that plane, depths are compared in double.
// Complexity: count_at O(n); count_beside O(polygons at the vertex).
// Source: slides 004, "Quantitative Invisibility"; Foley and van Dam, 15.3.2, for the polygons around a vertex.
#pragma once

#include <vector>

#include "peers/lines/scene_lines.h"

namespace sightline::peers {

class Obscuring {
 public:
  explicit Obscuring(const FlatScene& scene);

  [[nodiscard]] int count_at(const SceneLine& line, double t) const;
  // `beginning` is one of the line's ends, and a vertex.
  [[nodiscard]] int count_beside(const SceneLine& line, const LineEnd& beginning) const;

 private:
  struct PolygonCorner {
    VertexId vertex;
    const FlatPolygon* polygon = nullptr;
    std::size_t corner = 0;
  };
  const FlatScene& scene_;
  std::vector<PolygonCorner> corners_;  // by vertex
};

}  // namespace sightline::peers
