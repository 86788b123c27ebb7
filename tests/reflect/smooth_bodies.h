// Bodies of triangles that stand for smooth ones, with the normals of these.
#pragma once

#include <random>
#include <vector>

#include "geometry/mesh/mesh.h"
#include "geometry/projection/camera.h"
#include "reflect/world/panel.h"

namespace sightline::tests {

struct SmoothBody {
  std::vector<Point3> vertices;
  std::vector<Vector3> vertex_normals;  // parallel to the vertices
  PolygonList faces;

  [[nodiscard]] Mesh mesh() const { return build_mesh(vertices, faces); }
  [[nodiscard]] std::vector<Vector3> normals() const;  // per corner
};

// The sphere of radius 1 has n rows of 2 n squares, halved; so has the cylinder of radius 1 and height 2, without its ends, of n
// sides; the torus has radii 1 and 0.4.
[[nodiscard]] SmoothBody sphere(int n);
[[nodiscard]] SmoothBody cylinder(int sides);
[[nodiscard]] SmoothBody torus(int n);

// A place in space: a turn, then a way.
struct Pose {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Vector3 way = Vector3::Zero();

  [[nodiscard]] Point3 operator()(const Point3& p) const { return turn * p + way; }
};

[[nodiscard]] Pose random_pose(std::mt19937_64& random);
[[nodiscard]] SmoothBody moved(SmoothBody body, const Pose& pose);
[[nodiscard]] Camera moved(const ViewPoint& view, double fov_y_degrees, const Pose& pose);
[[nodiscard]] Panel moved(Panel panel, const Pose& pose);

}  // namespace sightline::tests
