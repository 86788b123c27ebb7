// Work that all threads share (oneTBB). How it is divided never changes a result: each item is worked on by itself.
//
// The number of threads is the caller's: that of the task arena it runs in, or tbb::global_control.
// Errors: what `work` throws, from one of the threads.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>

namespace sightline::inline geometry {

// Calls work(i) for each i below count, in no order, at least `grain` of them in a row on one thread.
template <class Work>
void parallel_for_each(std::size_t count, std::size_t grain, const Work& work) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t i = range.begin(); i != range.end(); ++i) work(i);
                    });
}

// This is for items that cost little each.
template <class Work>
void parallel_for_each(std::size_t count, const Work& work) {
  constexpr std::size_t grain = 4096;
  parallel_for_each(count, grain, work);
}

// The numbers below count are divided into ranges of this many, of which the last one may be shorter.
constexpr std::size_t items_per_range = 1 << 14;

// Calls work(range, begin, end) for each such range, in no order; range counts from 0.
template <class Work>
void parallel_for_ranges(std::size_t count, const Work& work) {
  const std::size_t ranges = (count + items_per_range - 1) / items_per_range;
  parallel_for_each(ranges, 1, [&](std::size_t range) {
    work(range, range * items_per_range, std::min(count, (range + 1) * items_per_range));
  });
}

[[nodiscard]] constexpr std::size_t range_count(std::size_t count) {
  return (count + items_per_range - 1) / items_per_range;
}

}  // namespace sightline::inline geometry
