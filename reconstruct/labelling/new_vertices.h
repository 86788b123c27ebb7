// The new vertices of the labelled surface: those that one part of it adds, and among them those inside one surface.
//
// In:  positions; points of the image on a surface.
// Out: vertices of the labelled surface. A part's own vertices get the ids behind the common ones; where parts are put
//      together they move up (labelled_mesh.cpp). A point gets one vertex, lifted where the caller does not know the
//      position.
// Errors: InternalError for a point that is on none of the surface's facets.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "reconstruct/labelling/exact_lift.h"
#include "reconstruct/labelling/facet_border.h"

namespace sightline::inline reconstruct {

class NewVertices {
 public:
  explicit NewVertices(const std::vector<Point3>& common) : common_(common) {}

  [[nodiscard]] const Point3& operator[](VertexId v) const {
    return v.index() < common_.size() ? common_[v.index()] : added_[v.index() - common_.size()];
  }
  VertexId add(const Point3& position) {
    added_.push_back(position);
    return VertexId(common_.size() + added_.size() - 1);
  }
  [[nodiscard]] const std::vector<Point3>& added() const { return added_; }

 private:
  const std::vector<Point3>& common_;
  std::vector<Point3> added_;
};

// These are the new vertices inside one surface after another: in its facets' interior, or where the view volume's
// border cuts them.
class SurfaceVertices : public InnerVertices {
 public:
  // New vertices are added to `vertices`.
  SurfaceVertices(const ProjectedScene& scene, const ImagePoints& points, NewVertices& vertices)
      : mesh_(scene.mesh()), scene_(scene), points_(points), vertices_(vertices), exact_lift_(points) {}

  void begin(FacetId surface);
  VertexId vertex_at(PointId p, std::optional<Point3> position) override;

 private:
  [[nodiscard]] Point3 lift(PointId p);

  const CutMesh& mesh_;
  const ProjectedScene& scene_;
  const ImagePoints& points_;
  NewVertices& vertices_;
  FacetId surface_;
  std::map<PointId, VertexId> known_;
  PlaneLift exact_lift_;  // where nothing is rounded
};

}  // namespace sightline::inline reconstruct
