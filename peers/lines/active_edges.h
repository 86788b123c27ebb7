// Where lines cross active edges that are nearer to the eye.
//
// In:  the lines of a scene.
// Out: for a line its intersections with active edges inside its view triangle (eye, from, to), in order, and by how
//      much the quantitative invisibility Q_v changes at each.
// An edge is active where more polygons lie on one of its sides in the image than on the other: the slides'
// silhouette edges, shared by a front and a back face, and in open meshes the boundary edges, too, which have one
// face only. An intersection is inside the view triangle where the lines cross in the image and the active edge is
// nearer there. Lines that share a vertex do not cross. Whether lines cross is decided exactly; where, and which is
// nearer, in double.
// Complexity: O(a) for a line and a active edges (the slides' extents discard most), and sorting.
// Source: slides 004, "Quantitative Invisibility".
#pragma once

#include <span>
#include <vector>

#include "peers/lines/scene_lines.h"

namespace sightline::peers {

struct ActiveCrossing {
  double t = 0;    // of the line, 0 to 1
  int change = 0;  // of Q_v
};

class ActiveEdges {
 public:
  explicit ActiveEdges(std::span<const SceneLine> lines);

  [[nodiscard]] std::vector<ActiveCrossing> crossings_of(const SceneLine& line) const;
  [[nodiscard]] std::size_t size() const { return edges_.size(); }

 private:
  std::vector<const SceneLine*> edges_;
};

}  // namespace sightline::peers
