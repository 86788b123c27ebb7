// BSP tree: a tree of the polygons from which an order to paint them in can be read for any eye.
//
// In:  the flat scene. Out: the tree; its polygons back to front; the item buffer painted that way.
// makeBSP: choose a polygon F from the list; split all polygons in the list according to F's plane; those on the front
// side of F make the front child, those on its back side the back child. displayBSP: the child on the other side of F
// than the viewer, then F, then the child on the viewer's side.
// Holds: front is where the polygon's front side looks. Polygons in F's plane stay at F's node, and of these what
// is_in_front_in_plane puts in front is painted last. Every polygon, or all of its parts, is in one node; no part is
// across the plane of a node above it. Neither building nor displaying recurses, so that a tree may be as high as there
// are polygons.
// Choice of F: of eight polygons, evenly spaced in the list, the one with the least of 8 * splits + |front - back|
// among 64 polygons, evenly spaced, too. A split costs as much as eight polygons out of balance.
// Precision: order at object precision, in doubles; polygons nearer to each other's planes than polygon_split.h's
// tolerance count as in the plane. Painting at image precision.
// Departures: slides 001 hang the polygons on F's front side on backChild and those on its back side on frontChild;
// displayBSP, there and in 003, needs them the other way round, as here. The slides' node has one polygon. The tree is
// of what one camera sees, after its projection, so it serves one eye only: the viewer is at depth minus infinity.
// Cost: O(n log n) where trees are balanced and nothing is split; O(n^2) for convex bodies, whose every polygon has all
// others on one side; the parts may be O(n^2).
// Errors: none. Source: slides 001 (BSP trees), 003 (BSP_display).
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/numbers/ids.h"
#include "peers/painters/painting.h"
#include "peers/scene/peer.h"

namespace sightline::peers {

using BspNodeId = Id<struct BspNodeTag>;

struct BspNode {
  std::vector<FlatPolygon> root;  // F, and what lies in its plane, the highest face index first
  bool viewer_is_in_front = true;
  BspNodeId front_child;  // invalid: an empty list
  BspNodeId back_child;
};

struct BspTree {
  std::vector<BspNode> nodes;  // the first one is the tree's root
  std::uint64_t splits = 0;
  std::size_t height = 0;
};

[[nodiscard]] BspTree make_bsp(const std::vector<FlatPolygon>& list);

[[nodiscard]] BackToFront display_bsp(const BspTree& tree);

[[nodiscard]] Peer bsp_tree();

}  // namespace sightline::peers
