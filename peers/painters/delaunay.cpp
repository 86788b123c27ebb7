#include "peers/painters/delaunay.h"

#include <algorithm>

#include "reconstruct/triangulation/constrained_delaunay.h"

namespace sightline::peers {
namespace {

bool sweeps_before(const Point2& a, const Point2& b) { return a.y != b.y ? a.y > b.y : a.x < b.x; }

class ExactPoints : public PlanarPoints {
 public:
  explicit ExactPoints(std::vector<Point2> points) : points_(std::move(points)) {
    std::sort(points_.begin(), points_.end(), sweeps_before);
    points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
  }

  [[nodiscard]] const Point2& at(PlanarPointId p) const { return points_[p.index()]; }
  [[nodiscard]] std::size_t size() const override { return points_.size(); }
  [[nodiscard]] Sign orient(PlanarPointId a, PlanarPointId b, PlanarPointId c) const override {
    return orient2d(at(a), at(b), at(c));
  }
  [[nodiscard]] bool flip_improves(PlanarPointId a, PlanarPointId b, PlanarPointId c, PlanarPointId d) const override {
    return in_circle(at(a), at(b), at(c), at(d)) > 0;
  }

 private:
  std::vector<Point2> points_;
};

}  // namespace

std::vector<TriangleOfPoints> delaunay(std::vector<Point2> points) {
  const ExactPoints planar(std::move(points));
  const HalfEdgeTriangulation triangulation = constrained_delaunay(planar, {});
  std::vector<TriangleOfPoints> triangles;
  for (std::size_t t = 0; t < triangulation.triangle_count(); ++t) {
    const auto [a, b, c] = triangulation.corners(TriangleId(t));
    triangles.push_back({planar.at(a), planar.at(b), planar.at(c)});
  }
  return triangles;
}

}  // namespace sightline::peers
