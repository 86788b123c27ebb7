// The limits say what a reader of meshes is asked for, and how much it may take; each reader's header says what is read and refused.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "geometry/numbers/export.h"

namespace sightline::inline formats {

// A file that needs more is refused at the statement where that shows.
struct ReadLimits {
  std::uint64_t memory = std::numeric_limits<std::uint64_t>::max();  // in bytes; see memory_for_mesh
};

enum class Normals : std::uint8_t { passed_over, read };

// No face has more corners: one that is not convex is triangulated in O(k^2), and a star of so many corners takes a
// quarter of a minute.
constexpr std::size_t most_corners = 10000;

// Returns what memory it takes to hold the statements, to build a mesh of them, to look for facets that meet, and to project it: a
// measured upper bound (obj_statements.cpp says how) where no more facets meet than there are.
[[nodiscard]] SIGHTLINE_EXPORT std::uint64_t memory_for_mesh(std::uint64_t vertices, std::uint64_t corners,
                                                             std::uint64_t faces);

}  // namespace sightline::inline formats
