// A stable sort for ranges that are nearly always short: those allocate nothing.
//
// Complexity: O(n log n); O(n^2) up to `few` items.
#pragma once

#include <algorithm>
#include <span>

namespace sightline::inline geometry {

template <class Item, class Before>
void sort_few(std::span<Item> items, const Before& before) {
  constexpr std::size_t few = 16;
  if (items.size() > few) return std::stable_sort(items.begin(), items.end(), before);
  for (std::size_t i = 1; i < items.size(); ++i) {
    for (std::size_t k = i; k > 0 && before(items[k], items[k - 1]); --k) std::swap(items[k], items[k - 1]);
  }
}

}  // namespace sightline::inline geometry
