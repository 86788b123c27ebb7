#include "oracle/judging/scene_changes.h"

#include <algorithm>
#include <cstring>

namespace sightline::lattice {
namespace {

std::vector<std::vector<VertexId>> face_list(const PolygonMesh& mesh) {
  std::vector<std::vector<VertexId>> faces;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) faces.emplace_back(mesh.faces[f].begin(), mesh.faces[f].end());
  return faces;
}

Mesh rebuilt(std::vector<Point3> vertices, const std::vector<std::vector<VertexId>>& faces) {
  PolygonList list;
  for (const auto& corners : faces) list.push_back(corners);
  return build_mesh(std::move(vertices), std::move(list));
}

Vector3 flipped(const Vector3& v) { return {-v.x(), v.y(), v.z()}; }

template <class Value>
void expect_same(Complaints& complaints, const std::string& what, const Value& before, const Value& after) {
  if (before != after) complaints.push_back(what + " before and after differ");
}

bool same_bits(const Point3& a, const Point3& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

bool same(const VisibleSegment& a, const VisibleSegment& b) {
  return a.start == b.start && a.end == b.end && a.facet == b.facet && a.other == b.other && a.edge == b.edge;
}

bool same(const LabelledTriangle& a, const LabelledTriangle& b) {
  return a.corners == b.corners && a.face == b.face && a.label == b.label && a.seen == b.seen;
}

bool same(const Crossing& a, const Crossing& b) { return a.a == b.a && a.b == b.b && a.after == b.after; }

}  // namespace

Shuffled with_faces_shuffled(const PolygonMesh& mesh, Dice& dice) {
  const auto faces = face_list(mesh);
  std::vector<std::size_t> order(faces.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  for (std::size_t i = order.size(); i-- > 1;) {
    std::swap(order[i], order[static_cast<std::size_t>(dice.between(0, static_cast<int>(i)))]);
  }
  std::vector<std::vector<VertexId>> shuffled;
  for (const std::size_t old : order) shuffled.push_back(faces[old]);
  return {rebuilt(mesh.vertices, shuffled), order};
}

Mesh with_corners_rotated(const PolygonMesh& mesh, Dice& dice) {
  auto faces = face_list(mesh);
  for (auto& corners : faces) {
    const int shift = dice.between(0, static_cast<int>(corners.size()) - 1);
    std::rotate(corners.begin(), corners.begin() + shift, corners.end());
  }
  return rebuilt(mesh.vertices, faces);
}

Mesh mirrored(const PolygonMesh& mesh) {
  std::vector<Point3> vertices;
  for (const Point3& p : mesh.vertices) vertices.push_back(flipped(p));
  auto faces = face_list(mesh);
  for (auto& corners : faces) std::reverse(corners.begin(), corners.end());
  return rebuilt(std::move(vertices), faces);
}

Camera mirrored(const Camera& camera) {
  Camera result = camera;
  result.right = -1.0 * flipped(camera.right);
  result.up = flipped(camera.up);
  result.forward = flipped(camera.forward);
  result.origin = flipped(camera.origin);
  result.eye.xyz = flipped(camera.eye.xyz);
  return result;
}

Camera rolled(const Camera& camera) {
  Camera result = camera;
  result.right = -1.0 * camera.up;
  result.up = camera.right;
  return result;
}

Outcome outcome(const View& view) {
  return {visible_areas(view), view.segments.segments.size(), view.polygons.polygons.size(),
          view.polygons.ring_count()};
}

Complaints differences(const Outcome& before, const Outcome& after) {
  Complaints complaints;
  expect_same(complaints, "numbers of segments", before.segments, after.segments);
  expect_same(complaints, "numbers of polygons", before.polygons, after.polygons);
  expect_same(complaints, "numbers of rings", before.rings, after.rings);
  for (std::size_t f = 0; f < before.areas.size(); ++f) {
    expect_same(complaints, "visible areas of face " + std::to_string(f), before.areas[f], after.areas[f]);
  }
  return complaints;
}

bool identical(const View& a, const View& b) {
  const auto equal = [](const auto& x, const auto& y, auto same_element) {
    return std::equal(x.begin(), x.end(), y.begin(), y.end(), same_element);
  };
  const auto same_value = [](const auto& x, const auto& y) { return same(x, y); };
  return a.scene.points == b.scene.points && equal(a.segments.crossings, b.segments.crossings, same_value) &&
         equal(a.segments.segments, b.segments.segments, same_value) && a.segments.splits == b.segments.splits &&
         a.polygons.ring_begin == b.polygons.ring_begin && a.polygons.ring_segments == b.polygons.ring_segments &&
         equal(a.labelled.vertices, b.labelled.vertices, same_bits) &&
         equal(a.labelled.triangles, b.labelled.triangles, same_value);
}

}  // namespace sightline::lattice
