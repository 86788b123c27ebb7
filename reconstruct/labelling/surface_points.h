// The points of one surface, as the constrained Delaunay triangulation wants them.
//
// In:  image points with the vertices that lie there, and the surface's plane.
// Out: PlanarPoints in sweep order. Their orientation is that of the image, exact. Which of two triangulations is
//      better is judged in the surface's own plane, by an exact in-circle test on rounded coordinates: it only chooses
//      shapes.
// Holds (after sort): points are distinct; of several vertices at one point, the lowest stands for all.
#pragma once

#include <vector>

#include "reconstruct/labelling/new_vertices.h"
#include "reconstruct/triangulation/constrained_delaunay.h"
#include "sweep/segments/image_points.h"

namespace sightline::inline reconstruct {

class SurfacePoints : public PlanarPoints {
 public:
  struct Entry {
    PointId point;
    VertexId vertex;  // the one that stands for all at this point
    Point2 in_plane;
  };

  // With `mirrored` the surface is seen from behind, so that it turns the other way in the image than in its plane.
  SurfacePoints(const ImagePoints& image, bool mirrored) : image_(image), turn_(mirrored ? -1 : 1) {}

  void add(PointId point, VertexId vertex) { entries_.push_back({point, vertex, {}}); }
  void sort();

  // Gives the points orthonormal coordinates in the plane of a, b, c, in which these turn counter-clockwise. Without
  // them, or where they are not finite, no triangulation is better than another.
  void place_in_plane(const Point3& a, const Point3& b, const Point3& c, const NewVertices& vertices);

  [[nodiscard]] bool contains(PointId p) const;
  [[nodiscard]] PlanarPointId index(PointId p) const;  // precondition: contains(p)
  [[nodiscard]] const Entry& operator[](PlanarPointId p) const { return entries_[p.index()]; }

  [[nodiscard]] std::size_t size() const override { return entries_.size(); }
  [[nodiscard]] Sign orient(PlanarPointId a, PlanarPointId b, PlanarPointId c) const override;
  [[nodiscard]] bool flip_improves(PlanarPointId a, PlanarPointId b, PlanarPointId c, PlanarPointId d) const override;

 private:
  [[nodiscard]] std::vector<Entry>::const_iterator find(PointId p) const;

  const ImagePoints& image_;
  std::vector<Entry> entries_;
  Sign turn_;
  bool placed_ = false;
};

}  // namespace sightline::inline reconstruct
