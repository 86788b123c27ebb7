// Appel's quantitative invisibility: the visible parts of the scene's lines.
//
// In:  a flat scene.
// Out: of every mesh edge, common lines included, the parts that no polygon hides. Not drawn: edges inside a planar
//      face, edges seen end-on, and edges along the window's border.
// Every line has a quantitative invisibility Q_v, the number of polygons that obscure it. Q_v changes only where the
// line passes behind an active edge (active_edges.h). One point of a line, the seed, is tested by brute force; from
// there Q_v follows the line, and at its ends it propagates to the neighbouring lines: there it differs only by those
// polygons around the shared vertex that hide the beginning of a line (obscuring.h). A line that no other one reaches
// gets a seed of its own.
// Precision: object. Whether lines cross is decided exactly, where they cross is rounded.
// Cost: O(l a) for l lines and a active edges, O(n) for each seed.
// Cannot: faces that touch without sharing vertices and edges (a vertex on a face, faces that overlap in one plane).
// There a line may come out from behind a face, or go behind it, where it meets no active edge nearer than itself;
// and a wrong Q_v propagates. Line drawings only: no polygons.
// Errors: RefusedScene where the camera has near or far bounds that cut the scene: those cuts are no lines of the
// mesh.
// Departures: the boundary edges of open meshes are active, too, and back-facing polygons obscure as front-facing
// ones do, since either is the surface here; so a silhouette edge changes Q_v by 2. The seed is in the middle of the
// longest segment between two intersections. Lines that fall on others in the image are thought moved aside
// (scene_lines.h).
// Source: slides 004, "Quantitative Invisibility"; Appel 1967.
#pragma once

#include <cstdint>
#include <vector>

#include "peers/lines/scene_lines.h"
#include "peers/scene/peer.h"

namespace sightline::peers {

[[nodiscard]] Peer appel();

// A segment of a line lies between intersections with active edges.
struct LineSegment {
  std::size_t line = 0;
  double from = 0;  // of the line, 0 to 1
  double to = 1;
  int Q_v = 0;
};

struct InvisibilityCounts {
  std::uint64_t seeds = 0;
  std::uint64_t propagations = 0;
  std::uint64_t intersections = 0;
};

struct QuantitativeInvisibility {
  std::vector<LineSegment> segments;  // of all lines
  InvisibilityCounts counts;
};

// The lines are those of the scene.
[[nodiscard]] QuantitativeInvisibility quantitative_invisibility(const FlatScene& scene,
                                                                 const std::vector<SceneLine>& lines);

}  // namespace sightline::peers
