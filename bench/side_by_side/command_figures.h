// These figures say what two threads save, and what writing the results costs: of the folded sphere, from a mesh in
// memory to labels, and to the files of a camera's folder.
//
// In:  a number of triangles, limits. Out: figures. Threads are compared by the clock on the wall, and by the numbers
// of the visible segments and of the      labelled mesh; writing is processor time, with making the texts, and the
// system's share. Precondition of measure_threads: no thread has been started in this process, nor their number been
// limited. Complexity: of a few views. Errors: std::runtime_error where there can be no temporary folder; else what
// fails makes a      figure `failed`.
#pragma once

#include "bench/measuring/figure.h"

namespace sightline::bench {

struct ThreadFigures {
  Figure one;  // seconds
  Figure two;
  Figure same_bytes;  // 1: yes
};

[[nodiscard]] ThreadFigures measure_threads(std::size_t triangles, const RunLimits& limits);

struct WritingFigures {
  Figure visibility;  // seconds
  Figure writing;
  Figure megabytes;
};

[[nodiscard]] WritingFigures measure_writing(std::size_t triangles, const RunLimits& limits);

}  // namespace sightline::bench
