// A mesh is made from polygons by places: it has one vertex per corner, in order.
#pragma once

#include <vector>

#include "geometry/mesh/mesh.h"

namespace sightline::tests {

using Corners = std::vector<Point3>;

[[nodiscard]] inline Mesh mesh_of(const std::vector<Corners>& polygons) {
  std::vector<Point3> vertices;
  PolygonList faces;
  for (const Corners& polygon : polygons) {
    std::vector<VertexId> corners;
    for (const Point3& p : polygon) {
      corners.emplace_back(vertices.size());
      vertices.push_back(p);
    }
    faces.push_back(corners);
  }
  return build_mesh(std::move(vertices), std::move(faces));
}

}  // namespace sightline::tests
