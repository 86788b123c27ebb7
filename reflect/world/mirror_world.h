// The world is everything that can be reflected or be in the way, prepared once for all cameras.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "geometry/mesh/box_hierarchy.h"
#include "geometry/mesh/cut_mesh.h"
#include "geometry/numbers/exact_position.h"
#include "geometry/numbers/export.h"
#include "reflect/world/panel.h"
#include "reflect/world/reflection_options.h"

namespace sightline::inline reflect {

// The facets of the surface, and panels, may stand between a mirror and a panel. The hierarchy is built in O(n log n);
// a pyramid (pyramid.h) costs what it touches of it.
class Obstacles {
 public:
  Obstacles() = default;
  // A mesh that was cut along common lines has the facets before the cut as obstacles. Which pieces they are in is of
  // no interest here.
  explicit Obstacles(const CutMesh& mesh);

  // `may_touch` is false where a box has no point in the pyramid.
  [[nodiscard]] std::vector<UncutFacetId> in(const std::function<bool(const Box&)>& may_touch) const;

 private:
  BoxHierarchy hierarchy_;
};

struct MirrorWorld {
  std::shared_ptr<const CutMesh> surface;  // a world keeps it alive
  std::vector<Panel> panels;
  ReflectionOptions options;
  std::vector<CutMesh> panel_meshes;  // one face each
  std::vector<ExactPlane> panel_planes;
  std::vector<Box> panel_boxes;
  // Per panel those that lie in its plane, exactly, and come before it: where they overlap, they are in front, as the lower face
  // index is of the surface's faces.
  std::vector<std::vector<std::size_t>> panels_over;
  Obstacles obstacles;
  double scale = 1;              // unit_scale of the surface's vertices
  std::vector<Vector3> normals;  // where the options need them: vertex_normals(surface)
  std::optional<Box> closed;  // a box around the surface, where mirrors are smooth and it is closed (closed_surface.h)
};

// `given_normals` are as for vertex_normals. Errors: PanelError.
[[nodiscard]] SIGHTLINE_EXPORT MirrorWorld make_mirror_world(std::shared_ptr<const CutMesh> surface,
                                                             std::vector<Panel> panels,
                                                             const ReflectionOptions& options = {},
                                                             const std::vector<Vector3>& given_normals = {});

struct ReflectionStatistics {
  std::uint64_t pyramids = 0;   // pairs of a panel and what may reflect it: a visible polygon, a triangle, a cell
  std::uint64_t obstacles = 0;  // facets, or for triangles vertices, that were looked at in them
  std::uint64_t blocked = 0;    // pyramids in which an obstacle casts a shadow on the panel's image, or is in the way
};

}  // namespace sightline::inline reflect
