#include "peers/scene/flat_scene.h"

#include <algorithm>
#include <cmath>

namespace sightline::peers {
namespace {

// Returns Newell's normal (slides 001) of the corners, taken relative to the first of them.
Vector3 normal_of(const CutMesh& mesh, FacetId facet) {
  const auto corners = mesh.corners(facet);
  const Point3& first = mesh.position(corners.front());
  Vector3 normal = Vector3::Zero();
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    normal = normal + (mesh.position(corners[i]) - first).cross(mesh.position(corners[i + 1]) - first);
  }
  return normal;
}

// A frame has what a camera's rows undo: a point at (x, y) of the window and at W is origin + W (x across + y upwards +
// ahead), or, where orthographic and W is the distance, origin + x across + y upwards + W ahead.
struct Frame {
  Vector3 across = Vector3::Zero();
  Vector3 upwards = Vector3::Zero();
  Vector3 ahead = Vector3::Zero();
};

Frame frame_of(const Camera& camera) {
  const double volume = camera.right.dot(camera.up.cross(camera.forward));
  return {(1 / volume) * camera.up.cross(camera.forward), (1 / volume) * camera.forward.cross(camera.right),
          (1 / volume) * camera.right.cross(camera.up)};
}

// The plane follows from normal . (point - origin) = offset, with the point as the frame has it.
DepthPlane depth_plane(const Frame& frame, const Camera& camera, const Vector3& normal, double offset) {
  const double a = normal.dot(frame.across);
  const double b = normal.dot(frame.upwards);
  const double c = normal.dot(frame.ahead);
  if (camera.projection == Projection::orthographic) return {-a / c, -b / c, offset / c};
  return {-a / offset, -b / offset, -c / offset};  // 1 / W = (a x + b y + c) / offset
}

bool is_finite(const DepthPlane& plane) {
  return std::isfinite(plane.a) && std::isfinite(plane.b) && std::isfinite(plane.c);
}

std::vector<Corner> corners_of(const ProjectedScene& scene, FacetId facet, const DepthPlane& plane) {
  std::vector<Corner> corners;
  for (const ClippedCorner& clipped : scene.polygon(facet)) {
    const ImagePoint& p = scene.point(clipped.point);
    const double x = std::ldexp(static_cast<double>(p.x), -scene.grid_bits);
    const double y = std::ldexp(static_cast<double>(p.y), -scene.grid_bits);
    corners.push_back({x, y, plane.at(x, y)});
  }
  return corners;
}

}  // namespace

FlatScene flat_scene(const ProjectedScene& scene) {
  const CutMesh& mesh = scene.mesh();
  FlatScene flat{&mesh, &scene, {}};
  const Frame frame = frame_of(scene.camera);
  for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
    if (scene.status[f] != FacetStatus::in_view) continue;
    const FacetId facet{f};
    const Vector3 normal = normal_of(mesh, facet);
    const double offset = normal.dot(mesh.position(mesh.corners(facet).front()) - scene.camera.origin);
    FlatPolygon polygon{mesh.facet_face[f], facet, scene.facing[f] == FacetFacing::front, {}, {}};
    polygon.plane = depth_plane(frame, scene.camera, normal, offset);
    if (!is_finite(polygon.plane)) continue;
    polygon.corners = corners_of(scene, facet, polygon.plane);
    if (!polygon.is_front) std::reverse(polygon.corners.begin(), polygon.corners.end());
    flat.polygons.push_back(std::move(polygon));
  }
  return flat;
}

bool is_in_front_in_plane(const FlatPolygon& a, const FlatPolygon& b) {
  return a.is_front == b.is_front ? a.face < b.face : a.is_front;
}

Extent extent_of(const std::vector<Corner>& corners) {
  Extent extent{corners.front(), corners.front()};
  for (const Corner& c : corners) {
    extent.least = {std::min(extent.least.x, c.x), std::min(extent.least.y, c.y),
                    std::min(extent.least.depth, c.depth)};
    extent.most = {std::max(extent.most.x, c.x), std::max(extent.most.y, c.y), std::max(extent.most.depth, c.depth)};
  }
  return extent;
}

}  // namespace sightline::peers
