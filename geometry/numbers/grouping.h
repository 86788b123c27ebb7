// Items by group: a counting sort on all threads.
//
// In:  how many groups; for_each(visit), which calls visit(group, item) for each item, and for the same ones whenever
//      it is called, from any threads.
// Out: the items of each group next to each other, in an order that the threads decide: whoever needs one sorts them.
// Complexity: O(groups + items).
#pragma once

#include <atomic>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace sightline::inline geometry {

template <class Item>
class Grouping {
 public:
  template <class ForEach>
  Grouping(std::size_t groups, const ForEach& for_each) : begin_(groups + 1, 0) {
    const auto count = [](std::uint32_t& counter) {
      return std::atomic_ref(counter).fetch_add(1, std::memory_order_relaxed);
    };
    for_each([&](std::size_t group, const Item&) { count(begin_[group + 1]); });
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    items_.resize(begin_.back());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for_each([&](std::size_t group, const Item& item) { items_[count(next[group])] = item; });
  }

  [[nodiscard]] std::size_t item_count() const { return items_.size(); }
  // Returns how many items all groups before this one have.
  [[nodiscard]] std::uint32_t items_before(std::size_t group) const { return begin_[group]; }
  [[nodiscard]] std::span<Item> of(std::size_t group) {
    return std::span(items_).subspan(begin_[group], begin_[group + 1] - begin_[group]);
  }
  [[nodiscard]] std::span<const Item> of(std::size_t group) const {
    return std::span(items_).subspan(begin_[group], begin_[group + 1] - begin_[group]);
  }

 private:
  std::vector<std::uint32_t> begin_;  // per group and one more
  std::vector<Item> items_;
};

}  // namespace sightline::inline geometry
