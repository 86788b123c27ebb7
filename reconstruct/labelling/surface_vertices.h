// The new vertices inside one surface after another: in its facets' interior, or where the view volume's border cuts
// them.
//
// In:  points of the image on the surface.
// Out: vertices of the labelled surface, one per point, lifted where the caller does not know the position.
// Errors: InternalError for a point that is on none of the surface's facets.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "reconstruct/labelling/facet_border.h"
#include "reconstruct/labelling/new_vertices.h"

namespace sightline::inline reconstruct {

class SurfaceVertices : public InnerVertices {
 public:
  // New vertices are added to `vertices`.
  SurfaceVertices(const ProjectedScene& scene, const ImagePoints& points, NewVertices& vertices)
      : mesh_(scene.mesh()), scene_(scene), points_(points), vertices_(vertices) {}

  void begin(FacetId surface);
  VertexId at(PointId p, std::optional<Point3> position) override;

 private:
  [[nodiscard]] Point3 lift(PointId p) const;

  const CutMesh& mesh_;
  const ProjectedScene& scene_;
  const ImagePoints& points_;
  NewVertices& vertices_;
  FacetId surface_;
  std::map<PointId, VertexId> known_;
};

}  // namespace sightline::inline reconstruct
