// Random scenes whose projection is exact and where coincidences abound: everything lies on a small grid.
//
// In:  a seed (the same on every machine). Out: a scene of 3 to 12 faces.
// Holds:
//   - no two faces interpenetrate: where both are seen, one is nearer, or they are coplanar
//   (SceneNotes::coplanar_overlap);
//   - every corner of a face's image, clipped ones included, is exactly on the grid of the image;
//   - no face repeats another, and none is degenerate.
// Wanted: shared, equal and touching vertices, edges on edges, vertices on edges and on faces, coplanar overlap,
// edge-on faces, faces across the window's border and behind the eye, strips, fans, tetrahedra, boxes, polygons
// (concave, with straight corners), quadrangles that are not planar.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/mesh/mesh.h"
#include "geometry/projection/camera.h"
#include "geometry/projection/projected_scene.h"

namespace sightline::lattice {

struct SceneNotes {
  bool clipped = false;  // some corner lies outside the view volume
  bool behind = false;   // some corner is not in front of the eye
  bool concave = false;
  bool not_planar = false;
  bool coplanar_overlap = false;
  bool edge_on = false;
};

struct RandomScene {
  std::uint64_t seed = 0;
  Camera camera;
  Sides sides = Sides::both;
  std::vector<Point3> vertices;
  std::vector<std::vector<std::uint32_t>> faces;
  SceneNotes notes;
};

[[nodiscard]] RandomScene random_scene(std::uint64_t seed);

[[nodiscard]] Mesh mesh_of(const RandomScene& scene);

// Returns the scene as OBJ text with its camera, seed and sides as comments.
[[nodiscard]] std::string to_text(const RandomScene& scene);

}  // namespace sightline::lattice
