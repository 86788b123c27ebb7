#include "peers/scene/exact_lines.h"

#include <algorithm>
#include <array>

#include "sweep/segments/image_points.h"

namespace sightline::peers {
namespace {

// A piece of an edge has its upper point first in the order of the sweep.
struct Piece {
  EdgeId edge;
  PointId upper;
  PointId lower;
};

bool is_of_mesh(const ProjectedScene& scene, EdgeId edge) {
  const auto sides = scene.sides_of(edge);
  return std::any_of(sides.begin(), sides.end(), [](const EdgeSide& side) { return side.mesh_edge.valid(); });
}

std::vector<Piece> sorted_pieces(const ProjectedScene& scene, const VisibleSegments& segments,
                                 const SweepOrder& before) {
  std::vector<Piece> pieces;
  for (const VisibleSegment& s : segments.segments) {
    if (!is_of_mesh(scene, s.edge)) continue;
    const bool down = before(s.start, s.end);
    pieces.push_back({s.edge, down ? s.start : s.end, down ? s.end : s.start});
  }
  std::sort(pieces.begin(), pieces.end(), [&before](const Piece& p, const Piece& q) {
    return p.edge != q.edge ? p.edge < q.edge : before(p.upper, q.upper);
  });
  return pieces;
}

}  // namespace

VisibleLines exact_lines(const ProjectedScene& scene, const VisibleSegments& segments) {
  const SweepOrder before(scene, segments);
  const ImagePoints points(scene, segments);
  VisibleLines lines;
  Piece last;
  const auto end_last = [&] {
    if (last.edge.valid()) lines.push_back({points.in_window(last.upper), points.in_window(last.lower)});
  };
  for (const Piece& piece : sorted_pieces(scene, segments, before)) {
    if (piece.edge == last.edge && !before(last.lower, piece.upper)) {
      if (before(last.lower, piece.lower)) last.lower = piece.lower;
      continue;
    }
    end_last();
    last = piece;
  }
  end_last();
  return lines;
}

}  // namespace sightline::peers
