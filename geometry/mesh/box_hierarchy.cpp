#include "geometry/mesh/box_hierarchy.h"

#include <tuple>

namespace sightline::inline geometry {
namespace {

// Leaves are so small that testing all pairs of one costs less than another level of nodes.
constexpr std::uint32_t leaf_size = 4;

using Item = BoxHierarchy::Item;

Box hull_of(std::span<const Item> items) {
  Box box = items.front().box;
  for (const Item& item : items) box = hull(box, item.box);
  return box;
}

// Both are halved first, so that no sum overflows.
double centre(const Box& box, int axis) { return box.low[axis] / 2 + box.high[axis] / 2; }

int longest_axis(const Box& box) {
  const Vector3 size = 0.5 * box.high - 0.5 * box.low;
  if (size.x() >= size.y() && size.x() >= size.z()) return 0;
  return size.y() >= size.z() ? 1 : 2;
}

// Puts the lower half of the items, by their centres along the longest axis, before the upper half.
void split_at_median(std::span<Item> items, const Box& box) {
  const int axis = longest_axis(box);
  const auto middle = items.begin() + static_cast<std::ptrdiff_t>(items.size() / 2);
  std::nth_element(items.begin(), middle, items.end(), [axis](const Item& a, const Item& b) {
    return std::tuple(centre(a.box, axis), a.index) < std::tuple(centre(b.box, axis), b.index);
  });
}

std::uint32_t build_node(BoxHierarchy& hierarchy, std::uint32_t first, std::uint32_t end) {
  const auto items = std::span(hierarchy.items).subspan(first, end - first);
  const Box box = hull_of(items);
  const auto node = static_cast<std::uint32_t>(hierarchy.nodes.size());
  hierarchy.nodes.push_back({box, first, end, 0});
  if (items.size() <= leaf_size) return node;
  split_at_median(items, box);
  const std::uint32_t middle = first + (end - first) / 2;
  build_node(hierarchy, first, middle);
  hierarchy.nodes[node].right = build_node(hierarchy, middle, end);
  return node;
}

}  // namespace

BoxHierarchy build_hierarchy(std::span<const Box> boxes) {
  BoxHierarchy hierarchy;
  hierarchy.items.reserve(boxes.size());
  for (std::uint32_t i = 0; i < boxes.size(); ++i) hierarchy.items.push_back({boxes[i], i});
  if (!boxes.empty()) build_node(hierarchy, 0, static_cast<std::uint32_t>(boxes.size()));
  return hierarchy;
}

}  // namespace sightline::inline geometry
