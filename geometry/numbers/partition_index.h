// Binary search among numbers.
//
// In:  a range [begin, end) and a predicate that is true for a first part of it.
// Out: the first number for which it is not; end where there is none.
// Complexity: O(log n) calls.
#pragma once

#include <cstddef>

namespace sightline::inline geometry {

template <class Predicate>
[[nodiscard]] std::size_t partition_index(std::size_t begin, std::size_t end, Predicate is_before) {
  while (begin < end) {
    const std::size_t middle = begin + (end - begin) / 2;
    if (is_before(middle)) {
      begin = middle + 1;
    } else {
      end = middle;
    }
  }
  return begin;
}

}  // namespace sightline::inline geometry
