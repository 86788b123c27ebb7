#include "reflect/lit_region.h"

#include <algorithm>
#include <cmath>

#include "sweep/sweep.h"

namespace sightline {
namespace {

ImageLine line_between(const ImagePoint& p, const ImagePoint& q) {
  return sweeps_before(p, q) ? ImageLine{p, q} : ImageLine{q, p};
}

// Twice the signed area.
Int128 twice_area(const ImagePolygon& polygon) {
  Int128 sum = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) sum += twice_area(polygon[0], polygon[i], polygon[i + 1]);
  return sum;
}

// Counter-clockwise.
void add_border(RegionBorder& border, ImagePolygon polygon) {
  if (twice_area(polygon) < 0) std::ranges::reverse(polygon);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const ImagePoint& p = polygon[i];
    const ImagePoint& q = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    border.push_back({grid_place(p), grid_place(q), line_between(p, q)});
  }
}

// The sheets, in triangles; a corner of the grid as a point at some height over the window.
class Sheets {
 public:
  explicit Sheets(int grid_bits) : grid_bits_(grid_bits) {}

  void add(const std::vector<ImagePolygon>& polygons, double height) {
    for (const ImagePolygon& polygon : polygons) {
      for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        const std::array corners{corner(polygon[0], height), corner(polygon[i], height),
                                 corner(polygon[i + 1], height)};
        faces_.push_back(corners);
      }
    }
  }

  [[nodiscard]] std::size_t count() const { return faces_.size(); }
  [[nodiscard]] Mesh mesh() { return build_mesh(std::move(vertices_), std::move(faces_)); }

 private:
  VertexId corner(const ImagePoint& p, double height) {
    vertices_.push_back({coordinate(p.x), coordinate(p.y), height});
    return VertexId(vertices_.size() - 1);
  }
  [[nodiscard]] double coordinate(std::int64_t grid) const {
    return std::ldexp(static_cast<double>(grid), -grid_bits_);
  }

  int grid_bits_;
  std::vector<Point3> vertices_;
  PolygonList faces_;
};

// Straight down on the window: a point's image is its own x and y.
Camera straight_down() {
  Camera camera;
  camera.name = "straight down";
  camera.projection = Projection::orthographic;
  camera.right = {1, 0, 0};
  camera.up = {0, 1, 0};
  camera.forward = {0, 0, -1};
  camera.eye = {{0, 0, 1}, 0};
  return camera;
}

ImagePlace place_of(const ProjectedScene& scene, const VisibleSegments& segments, PointId p) {
  if (p.index() < scene.points.size()) return grid_place(scene.point(p));
  const Crossing& crossing = segments.crossings[p.index() - scene.points.size()];
  const auto line = [&](EdgeId e) {
    return ImageLine{scene.point(scene.edge(e).top), scene.point(scene.edge(e).bottom)};
  };
  return crossing_place(line(crossing.a), line(crossing.b));
}

}  // namespace

BorderPiece border_piece(const ProjectedScene& scene, const VisibleSegments& segments, const VisibleSegment& segment) {
  const SceneEdge& edge = scene.edge(segment.edge);
  return {place_of(scene, segments, segment.start),
          place_of(scene, segments, segment.end),
          {scene.point(edge.top), scene.point(edge.bottom)}};
}

RegionBorder lit_region(const std::vector<ImagePolygon>& panel, const std::vector<ImagePolygon>& shadows,
                        int grid_bits) {
  RegionBorder border;
  if (shadows.empty()) {
    for (const ImagePolygon& polygon : panel) add_border(border, polygon);
    return border;
  }
  Sheets sheets(grid_bits);
  sheets.add(panel, 0);
  const std::size_t lit = sheets.count();
  sheets.add(shadows, 1);
  const Mesh mesh = sheets.mesh();
  const ProjectedScene scene = project(mesh, straight_down(), Sides::both, {Arithmetic::exact, grid_bits});
  const VisibleSegments segments = sweep(mesh, scene);
  for (const VisibleSegment& segment : segments.segments) {
    if (mesh.facet_face[segment.facet.index()].index() < lit) border.push_back(border_piece(scene, segments, segment));
  }
  return border;
}

}  // namespace sightline
