// A hierarchy of axis-aligned boxes, to find the pairs that overlap.
//
// In:  boxes of finite coordinates, low <= high in each.
// Out: a binary tree over them (build_hierarchy), and every pair of them that overlaps, once
//      (for_each_overlapping_pair). Boxes are closed: boxes that share one point overlap. Comparisons of doubles are
//      exact, so no overlap is missed.
// Holds: nodes are in preorder (the left child follows its parent); a node's box is the hull of its items' boxes.
// Complexity: O(n log n) time and O(n) space to build; the pairs O(n log n + pairs) for surfaces.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/numbers/export.h"
#include "geometry/numbers/vector3.h"

namespace sightline::inline geometry {

struct Box {
  Point3 low = Point3::Zero();
  Point3 high = Point3::Zero();
};

[[nodiscard]] inline bool overlap(const Box& a, const Box& b) {
  return a.low.x() <= b.high.x() && b.low.x() <= a.high.x() && a.low.y() <= b.high.y() && b.low.y() <= a.high.y() &&
         a.low.z() <= b.high.z() && b.low.z() <= a.high.z();
}

[[nodiscard]] inline bool contains(const Box& box, const Point3& p) { return overlap(box, Box{p, p}); }

[[nodiscard]] inline Box hull(const Box& a, const Box& b) { return {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)}; }

struct BoxHierarchy {
  struct Item {
    Box box;
    std::uint32_t index = 0;  // of the box as given
  };
  struct Node {
    Box box;
    std::uint32_t first = 0;  // its items: [first, end)
    std::uint32_t end = 0;
    std::uint32_t right = 0;  // its right child; 0: a leaf
  };
  std::vector<Item> items;
  std::vector<Node> nodes;
};

[[nodiscard]] SIGHTLINE_EXPORT BoxHierarchy build_hierarchy(std::span<const Box> boxes);

// Calls visit(item) for the items whose boxes, and those of the nodes above them, are not excluded by may_touch(box).
template <class MayTouch, class Visit>
void for_each_touched_item(const BoxHierarchy& hierarchy, MayTouch may_touch, Visit visit) {
  std::vector<std::uint32_t> open;
  if (!hierarchy.nodes.empty()) open.push_back(0);
  while (!open.empty()) {
    const std::uint32_t n = open.back();
    open.pop_back();
    const BoxHierarchy::Node& node = hierarchy.nodes[n];
    if (!may_touch(node.box)) continue;
    if (node.right != 0) {
      open.insert(open.end(), {node.right, n + 1});
      continue;
    }
    for (std::uint32_t i = node.first; i < node.end; ++i) {
      if (may_touch(hierarchy.items[i].box)) visit(hierarchy.items[i]);
    }
  }
}

namespace detail {

// Two nodes are descended at once: both nodes' items are held against each other, or one node's items against
// themselves.
template <class Visit>
class PairDescent {
 public:
  PairDescent(const BoxHierarchy& hierarchy, Visit& visit) : hierarchy_(hierarchy), visit_(visit) {}

  void within(std::uint32_t node) {
    const auto& n = hierarchy_.nodes[node];
    if (n.right == 0) return leaf(n);
    within(node + 1);
    within(n.right);
    between(node + 1, n.right);
  }

 private:
  void between(std::uint32_t a, std::uint32_t b) {
    const auto& left = hierarchy_.nodes[a];
    const auto& right = hierarchy_.nodes[b];
    if (!overlap(left.box, right.box)) return;
    if (left.right == 0 && right.right == 0) return leaves(left, right);
    const bool split_left = right.right == 0 || (left.right != 0 && left.end - left.first >= right.end - right.first);
    between(split_left ? a + 1 : a, split_left ? b : b + 1);
    between(split_left ? left.right : a, split_left ? b : right.right);
  }

  void leaf(const BoxHierarchy::Node& n) {
    for (std::uint32_t i = n.first; i < n.end; ++i) {
      for (std::uint32_t j = i + 1; j < n.end; ++j) pair(hierarchy_.items[i], hierarchy_.items[j]);
    }
  }

  void leaves(const BoxHierarchy::Node& a, const BoxHierarchy::Node& b) {
    for (std::uint32_t i = a.first; i < a.end; ++i) {
      if (!overlap(hierarchy_.items[i].box, b.box)) continue;
      for (std::uint32_t j = b.first; j < b.end; ++j) pair(hierarchy_.items[i], hierarchy_.items[j]);
    }
  }

  void pair(const BoxHierarchy::Item& a, const BoxHierarchy::Item& b) {
    if (overlap(a.box, b.box)) visit_(std::min(a.index, b.index), std::max(a.index, b.index));
  }

  const BoxHierarchy& hierarchy_;
  Visit& visit_;
};

}  // namespace detail

// Calls visit(i, j), i < j, for every pair of boxes that overlap: each pair once, in no order of the indices.
template <class Visit>
void for_each_overlapping_pair(const BoxHierarchy& hierarchy, Visit visit) {
  if (!hierarchy.nodes.empty()) detail::PairDescent<Visit>(hierarchy, visit).within(0);
}

}  // namespace sightline::inline geometry
