// The options say how reflections are found.
//
// exact:     every face is the flat mirror that it is; what reflects is cut out, exactly (mirror.h).
// triangles: Koucky's test as published: a triangle reflects or not (reflecting_triangles.h).
// smooth:    the surface as its vertex normals have it, bent between its corners; what reflects is cut out, up to a
//            tolerance (smooth_mirror.h).
#pragma once

#include <cstdint>
#include <optional>

#include "geometry/mesh/vertex_normals.h"
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
  // With smooth: of what reflects a panel, no larger share of its area in the image may be wrong, and no border further from where it
  // should be, in halves of the window.
  double tolerance = 1e-3;
  // How normals that the file does not give are means of those of faces; where it is not said, weighted by area for smooth, and
  // plain, as published, for triangles.
  std::optional<NormalMeans> means = std::nullopt;
  std::optional<double> crease_angle_degrees = std::nullopt;
  // Panels and faces that lie on a face, or on each other, no further apart than this share of the surface's size, are found; where
  // `snaps` they count as in one plane: panels win over the surface, the first one over others, and of faces those that the rule of
  // coplanar faces says.
  double coincidence = 1e-9;
  bool snaps = false;

  [[nodiscard]] bool needs_vertex_normals() const {
    return mode == ReflectionMode::smooth || (mode == ReflectionMode::triangles && normals == MirrorNormals::vertex);
  }
  [[nodiscard]] NormalOptions normal_options() const {
    const NormalMeans usual = mode == ReflectionMode::triangles ? NormalMeans::plain : NormalMeans::area;
    return {means.value_or(usual), crease_angle_degrees};
  }
};

}  // namespace sightline::inline reflect
