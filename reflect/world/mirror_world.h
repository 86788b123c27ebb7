// The world is everything that can be reflected or be in the way, prepared once for all cameras.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "geometry/mesh/cut_mesh.h"
#include "geometry/numbers/exact_position.h"
#include "geometry/numbers/export.h"
#include "reflect/world/flush_panels.h"
#include "reflect/world/obstacles.h"
#include "reflect/world/panel.h"
#include "reflect/world/reflection_options.h"

namespace sightline::inline reflect {

struct MirrorWorld {
  std::shared_ptr<const CutMesh> surface;  // a world keeps it alive
  std::vector<Panel> panels;               // fitted
  ReflectionOptions options;
  std::vector<CutMesh> panel_meshes;  // one face each
  std::vector<ExactPlane> panel_planes;
  std::vector<Box> panel_boxes;
  // Per panel those that lie in its plane, exactly, and come before it: where they overlap, they are in front, as the lower face
  // index is of the surface's faces.
  std::vector<std::vector<std::size_t>> panels_over;
  // Per panel what lies on it, or all but. Where the options snap, that counts as in its plane.
  std::vector<Flush> flush;
  Obstacles obstacles;
  double scale = 1;              // unit_scale of the surface's vertices
  std::vector<Vector3> normals;  // where the options need them: vertex_normals(surface)
  // Per face 1 where it mirrors; empty: all do. What does not is in the way all the same.
  std::vector<std::uint8_t> mirror_faces;
  std::optional<Box> closed;  // a box around the surface, where mirrors are smooth and it is closed (closed_surface.h)

  // Returns whether the facet counts as in the panel's plane: then it does not hide the panel.
  [[nodiscard]] bool is_snapped(std::size_t panel, UncutFacetId facet) const;
  // Returns whether some facet of the surface does: then the surface does not mirror the panel.
  [[nodiscard]] bool is_snapped_surface(std::size_t panel, FacetId mirror) const;
  // Returns whether the facet counts as in the mirror's plane, though rounding has it off that: then it hides nothing that the
  // mirror shows (snapped_planes.h).
  [[nodiscard]] bool is_snapped_to_mirror(FacetId mirror, UncutFacetId facet) const;
  // Returns whether another panel counts as in the panel's plane, where of both the first one is in front: it is snapped, or has the
  // same corners. (Others are in the plane where their corners are, exactly.)
  [[nodiscard]] bool is_in_plane(std::size_t panel, std::size_t other) const;

  [[nodiscard]] bool mirrors(FaceId face) const { return mirror_faces.empty() || mirror_faces[face.index()] != 0; }
};

// `given_normals` are as for vertex_normals, `mirror_faces` as in the world. Errors: PanelError.
[[nodiscard]] SIGHTLINE_EXPORT MirrorWorld make_mirror_world(std::shared_ptr<const CutMesh> surface,
                                                             std::vector<Panel> panels,
                                                             const ReflectionOptions& options = {},
                                                             const std::vector<Vector3>& given_normals = {},
                                                             std::vector<std::uint8_t> mirror_faces = {});

struct ReflectionStatistics {
  std::uint64_t pyramids = 0;   // pairs of a panel and what may reflect it: a visible polygon, a triangle, a cell
  std::uint64_t obstacles = 0;  // facets, or for triangles vertices, that were looked at in them
  std::uint64_t blocked = 0;    // pyramids in which an obstacle casts a shadow on the panel's image, or is in the way
};

}  // namespace sightline::inline reflect
