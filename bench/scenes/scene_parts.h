// The generators of scenes share these: random numbers that are the same in every run, coordinates as files have them,
// and triangles.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "geometry/mesh/mesh.h"
#include "geometry/numbers/mix.h"

namespace sightline::bench {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(mix(seed)) {}

  // The number is uniform in [0, 1).
  [[nodiscard]] double unit() { return static_cast<double>(next() >> 11U) * 0x1p-53; }

  // The number is uniform in [low, high).
  [[nodiscard]] double between(double low, double high) { return low + (high - low) * unit(); }

  // The number is uniform in 0, ..., count - 1, but for a bias of count / 2^53.
  [[nodiscard]] std::size_t below(std::size_t count) {
    return static_cast<std::size_t>(unit() * static_cast<double>(count));
  }

 private:
  std::uint64_t next() { return mix(state_++); }
  std::uint64_t state_;
};

// The coordinates are rounded to seven decimals: what "%.9g" writes of them, below 100, reads back as the same double.
[[nodiscard]] inline Point3 as_in_a_file(const Point3& p) {
  const auto rounded = [](double x) { return std::round(x * 1e7) / 1e7; };
  return {rounded(p.x()), rounded(p.y()), rounded(p.z())};
}

inline void add_triangle(PolygonList& faces, std::size_t a, std::size_t b, std::size_t c) {
  const std::array corners{VertexId(a), VertexId(b), VertexId(c)};
  faces.push_back(corners);
}

// Adds the two triangles of a cell of a grid whose rows have `row` vertices each, counter-clockwise where rows go down
// and columns to the right.
inline void add_cell(PolygonList& faces, std::size_t corner, std::size_t row) {
  add_triangle(faces, corner, corner + row, corner + 1);
  add_triangle(faces, corner + 1, corner + row, corner + row + 1);
}

}  // namespace sightline::bench
