// The options say how reflections are found.
//
// exact:     every face is the flat mirror that it is; what reflects is cut out, exactly (mirror.h).
// triangles: Koucky's test as published: a triangle reflects or not (reflecting_triangles.h).
// smooth:    the surface as its vertex normals have it, bent between its corners; what reflects is cut out, up to a
//            tolerance (smooth_mirror.h).
#pragma once

#include <cstdint>

#include "geometry/numbers/export.h"

namespace sightline::inline reflect {

enum class ReflectionMode : std::uint8_t { exact, triangles, smooth };
[[nodiscard]] SIGHTLINE_EXPORT const char* to_string(ReflectionMode mode);

// A ray is mirrored, at a corner of a triangle, at one of these normals.
enum class MirrorNormals : std::uint8_t { face, vertex };
[[nodiscard]] SIGHTLINE_EXPORT const char* to_string(MirrorNormals normals);

struct ReflectionOptions {
  ReflectionMode mode = ReflectionMode::exact;
  MirrorNormals normals = MirrorNormals::vertex;  // for triangles: exact has those of faces, smooth those of vertices
  // With smooth, a part of the image is not divided further where dividing it changes the area that reflects by no more
  // than this share of the part.
  double tolerance = 1e-3;

  [[nodiscard]] bool needs_vertex_normals() const {
    return mode == ReflectionMode::smooth || (mode == ReflectionMode::triangles && normals == MirrorNormals::vertex);
  }
};

}  // namespace sightline::inline reflect
