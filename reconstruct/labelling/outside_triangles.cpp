#include "reconstruct/labelling/outside_triangles.h"

#include <algorithm>

#include "geometry/mesh/facet_plane.h"
#include "geometry/projection/clipping.h"
#include "reconstruct/triangulation/constrained_delaunay.h"

namespace sightline::inline reconstruct {
namespace {

// This is a corner of the facet or of its clipped polygon, in a plane of input coordinates: (x / one, y / one).
struct FlatPoint {
  BigInteger x, y, one;
  VertexId vertex;
  std::size_t clipped = npos;  // which corner of the clipped polygon it is
  static constexpr std::size_t npos = static_cast<std::size_t>(-1);
};

Sign sweep_compare(const FlatPoint& a, const FlatPoint& b) {
  const Sign y = sign_of(BigInteger(b.y * a.one - a.y * b.one));
  return y != 0 ? y : sign_of(BigInteger(a.x * b.one - b.x * a.one));
}

// The plane is space without one axis, mirrored where the facet would be clockwise in it.
class FlatPoints : public PlanarPoints {
 public:
  FlatPoints(const CutMesh& mesh, FacetId facet) {
    const auto [a, b, c] = plane_corners(mesh, facet);
    for (axis_ = 0; turn_ == 0; ++axis_) {
      turn_ = orient2d(drop_axis(mesh.position(a), axis_), drop_axis(mesh.position(b), axis_),
                       drop_axis(mesh.position(c), axis_));
    }
    --axis_;
  }

  void add(const ExactCorner& corner, VertexId vertex, std::size_t clipped) {
    const std::array coordinates{&corner.px, &corner.py, &corner.pz};
    const auto first = static_cast<std::size_t>((axis_ + 1) % 3);
    const auto second = static_cast<std::size_t>((axis_ + 2) % 3);
    points_.push_back({*coordinates[first] * turn_, *coordinates[second], corner.one, vertex, clipped});
  }

  // A vertex is both a corner of the facet and one of its clipped polygon; it is kept as the latter.
  void sort() {
    std::sort(points_.begin(), points_.end(), [](const FlatPoint& a, const FlatPoint& b) {
      const Sign order = sweep_compare(a, b);
      return order != 0 ? order < 0 : a.clipped < b.clipped;
    });
    points_.erase(std::unique(points_.begin(), points_.end(),
                              [](const FlatPoint& a, const FlatPoint& b) { return sweep_compare(a, b) == 0; }),
                  points_.end());
  }

  [[nodiscard]] const FlatPoint& operator[](PlanarPointId p) const { return points_[p.index()]; }

  [[nodiscard]] PlanarPointId of_clipped(std::size_t corner) const {
    const auto found =
        std::find_if(points_.begin(), points_.end(), [&](const FlatPoint& p) { return p.clipped == corner; });
    return PlanarPointId(static_cast<std::size_t>(found - points_.begin()));
  }

  [[nodiscard]] std::size_t size() const override { return points_.size(); }

  [[nodiscard]] Sign orient(PlanarPointId a, PlanarPointId b, PlanarPointId c) const override {
    const FlatPoint& p = points_[a.index()];
    const FlatPoint& q = points_[b.index()];
    const FlatPoint& r = points_[c.index()];
    const auto minor = [](const FlatPoint& u, const FlatPoint& v) { return BigInteger(u.x * v.y - u.y * v.x); };
    return sign_of(BigInteger(minor(p, q) * r.one + minor(q, r) * p.one + minor(r, p) * q.one));
  }

 private:
  std::vector<FlatPoint> points_;
  int axis_ = 0;
  Sign turn_ = 0;
};

class OutsideTriangles {
 public:
  OutsideTriangles(const LabelSources& from, FacetId facet, std::span<const EdgeSplit> splits, InnerVertices& inner)
      : from_(from), facet_(facet), splits_(splits), inner_(inner), flat_(from.mesh, facet) {
    const ProjectedScene& scene = from.scene;
    const CutMesh& mesh = from.mesh;
    const auto polygon = clip(mesh, scene.camera, facet);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      flat_.add(polygon[i], corner_vertex(from, scene.polygon(facet)[i], inner), i);
      if (!polygon[i].edge_after.valid()) border_lines_.push_back(i);
    }
    for (const VertexId v : mesh.corners(facet)) flat_.add(exact_corner(mesh, v, scene.camera), v, FlatPoint::npos);
    flat_.sort();
    corner_count_ = polygon.size();
  }

  std::vector<std::array<VertexId, 3>> run() {
    std::vector<Constraint> constraints;
    for (const std::size_t i : border_lines_)
      constraints.push_back({flat_.of_clipped(i), flat_.of_clipped(next_corner(i))});
    const HalfEdgeTriangulation triangulation = constrained_delaunay(flat_, constraints);
    const Regions regions = flood_regions(triangulation);
    const std::vector<std::uint8_t> in_view = regions_in_view(triangulation, regions, constraints);
    std::vector<std::array<VertexId, 3>> result;
    for (std::size_t t = 0; t < triangulation.triangle_count(); ++t) {
      if (in_view[regions.of_triangle[t].index()] == 0) add_triangle(triangulation, TriangleId(t), result);
    }
    return result;
  }

 private:
  [[nodiscard]] std::size_t next_corner(std::size_t i) const { return i + 1 == corner_count_ ? 0 : i + 1; }

  // The clipped polygon is counter-clockwise here, so what is in view lies left of its lines.
  [[nodiscard]] static std::vector<std::uint8_t> regions_in_view(const HalfEdgeTriangulation& triangulation,
                                                                 const Regions& regions,
                                                                 const std::vector<Constraint>& constraints) {
    std::vector<std::uint8_t> in_view(regions.count, 0);
    for (std::size_t h = 0; h < triangulation.origin.size(); ++h) {
      const Constraint line{triangulation.from(HalfEdgeId(h)), triangulation.to(HalfEdgeId(h))};
      if (std::find(constraints.begin(), constraints.end(), line) == constraints.end()) continue;
      in_view[regions.of_triangle[h / 3].index()] = 1;
    }
    return in_view;
  }

  void add_triangle(const HalfEdgeTriangulation& triangulation, TriangleId t,
                    std::vector<std::array<VertexId, 3>>& result) {
    std::vector<BorderPoint> border;
    for (std::uint32_t side = 0; side < 3; ++side) {
      const HalfEdgeId h = half_edge(t, side);
      border.push_back({flat_[triangulation.from(h)].vertex, side});
      add_splits(flat_[triangulation.from(h)], flat_[triangulation.to(h)], side, border);
    }
    const auto corner = [&border](std::size_t i) { return border[i].vertex; };
    if (border.size() == 3 && (corner(0) == corner(1) || corner(1) == corner(2) || corner(2) == corner(0))) return;
    const auto triangles = convex_triangles(border);
    result.insert(result.end(), triangles.begin(), triangles.end());
  }

  // Seen from outside, the lines of the clipped polygon run backwards.
  void add_splits(const FlatPoint& from, const FlatPoint& to, std::uint32_t side, std::vector<BorderPoint>& border) {
    if (to.clipped == FlatPoint::npos || next_corner(to.clipped) != from.clipped) return;
    if (std::find(border_lines_.begin(), border_lines_.end(), to.clipped) == border_lines_.end()) return;
    auto splits = splits_between(from_, facet_, to.clipped, splits_);
    std::reverse(splits.begin(), splits.end());
    for (const PointId p : splits) border.push_back({inner_.vertex_at(p, std::nullopt), side});
  }

  const LabelSources& from_;
  const FacetId facet_;
  const std::span<const EdgeSplit> splits_;
  InnerVertices& inner_;
  FlatPoints flat_;
  std::size_t corner_count_ = 0;
  std::vector<std::size_t>
      border_lines_;  // corners of the clipped polygon from which a line along the view volume's border starts
};

}  // namespace

std::vector<std::array<VertexId, 3>> outside_triangles(const LabelSources& from, FacetId facet,
                                                       std::span<const EdgeSplit> splits_of_view_border,
                                                       InnerVertices& inner) {
  return OutsideTriangles(from, facet, splits_of_view_border, inner).run();
}

}  // namespace sightline::inline reconstruct
