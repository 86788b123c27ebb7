#include "oracle/judging/labelled_laws.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace sightline::lattice {
namespace {

double area_of(const Point3& a, const Point3& b, const Point3& c) { return norm((b - a).cross(c - a)) / 2; }

double largest(const Point3& p) { return std::max({std::fabs(p.x()), std::fabs(p.y()), std::fabs(p.z())}); }

struct FaceExtent {
  double area = 0;
  double perimeter = 0;
  double coordinate = 0;  // the largest
};

FaceExtent extent_of(const PolygonMesh& mesh, FaceId face) {
  FaceExtent extent;
  for (std::size_t f = mesh.first_facet(face); f < mesh.end_facet(face); ++f) {
    const auto corners = mesh.corners(FacetId(f));
    Vector3 twice_area = Vector3::Zero();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Point3& p = mesh.position(corners[i]);
      const Point3& q = mesh.position(corners[(i + 1) % corners.size()]);
      const Point3& origin = mesh.position(corners[0]);
      twice_area = twice_area + (p - origin).cross(q - origin);
      extent.perimeter += norm(q - p);
      extent.coordinate = std::max(extent.coordinate, largest(p));
    }
    extent.area += norm(twice_area) / 2;
  }
  return extent;
}

using DirectedEdge = std::array<std::size_t, 2>;

// Returns, for every vertex, the first of those at its position (-0 and 0 are one).
std::vector<std::size_t> welded(const std::vector<Point3>& vertices) {
  std::vector<std::size_t> order(vertices.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto key = [&](std::size_t i) { return std::array{vertices[i].x(), vertices[i].y(), vertices[i].z()}; };
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
  std::vector<std::size_t> result(vertices.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && vertices[order[i]] == vertices[order[i - 1]];
    result[order[i]] = same ? result[order[i - 1]] : order[i];
  }
  return result;
}

bool balanced(std::vector<DirectedEdge> edges) {
  std::vector<DirectedEdge> reversed = edges;
  for (DirectedEdge& e : reversed) std::swap(e[0], e[1]);
  std::sort(edges.begin(), edges.end());
  std::sort(reversed.begin(), reversed.end());
  return edges == reversed;
}

template <class Corners>
void append_edges(std::vector<DirectedEdge>& edges, const Corners& corners, const std::vector<std::size_t>& weld) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    edges.push_back({weld[corners[i].index()], weld[corners[(i + 1) % corners.size()].index()]});
  }
}

Point2 image(const Camera& camera, const Point3& v) {
  const Vector3 offset = v - camera.origin;
  const double w = camera.projection == Projection::perspective ? camera.forward.dot(offset) : 1;
  return {camera.right.dot(offset) / w, camera.up.dot(offset) / w};
}

}  // namespace

Complaints input_vertices_kept(const PolygonMesh& mesh, const LabelledMesh& labelled) {
  const std::size_t bytes = mesh.vertices.size() * sizeof(Point3);
  const bool kept = labelled.vertices.size() >= mesh.vertices.size() &&
                    (bytes == 0 || std::memcmp(labelled.vertices.data(), mesh.vertices.data(), bytes) == 0);
  return kept ? Complaints{} : Complaints{"the first vertices are not the input's"};
}

Complaints areas_kept(const PolygonMesh& mesh, const LabelledMesh& labelled) {
  std::vector<double> area(mesh.face_count());
  for (const LabelledTriangle& t : labelled.triangles) {
    const auto at = [&](std::size_t i) { return labelled.vertices[t.corners[i].index()]; };
    area[t.face.index()] += area_of(at(0), at(1), at(2));
  }
  Complaints complaints;
  for (std::size_t f = 0; f < area.size(); ++f) {
    const FaceExtent extent = extent_of(mesh, FaceId(f));
    const double rounding = extent.perimeter * extent.coordinate * std::numeric_limits<double>::epsilon();
    if (std::fabs(area[f] - extent.area) <= std::max(1e-12 * extent.area, rounding)) continue;
    complaints.push_back("the triangles of face " + std::to_string(f) + " have area " + std::to_string(area[f]) +
                         ", the face has " + std::to_string(extent.area));
  }
  return complaints;
}

bool is_closed(const PolygonMesh& mesh) {
  const std::vector<std::size_t> weld = welded(mesh.vertices);
  std::vector<DirectedEdge> edges;
  for (std::size_t f = 0; f < mesh.facet_count(); ++f) append_edges(edges, mesh.corners(FacetId(f)), weld);
  return balanced(std::move(edges));
}

bool is_closed(const LabelledMesh& labelled) {
  const std::vector<std::size_t> weld = welded(labelled.vertices);
  std::vector<DirectedEdge> edges;
  for (const LabelledTriangle& t : labelled.triangles) append_edges(edges, t.corners, weld);
  return balanced(std::move(edges));
}

Complaints seen_areas_agree(const View& view, double tolerance) {
  const CutMesh& mesh = view.scene.mesh();
  std::vector<double> seen(mesh.face_count());
  for (const LabelledTriangle& t : view.labelled.triangles) {
    if (!t.seen) continue;
    const auto at = [&](std::size_t i) {
      return image(view.scene.camera, view.labelled.vertices[t.corners[i].index()]);
    };
    const Point2 a = at(0);
    const Point2 b = at(1);
    const Point2 c = at(2);
    seen[t.face.index()] += std::fabs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
  }
  std::vector<double> visible(mesh.face_count());
  for (const VisiblePolygon& p : view.polygons.polygons) visible[p.face.index()] += p.area;
  Complaints complaints;
  for (std::size_t f = 0; f < seen.size(); ++f) {
    if (std::fabs(seen[f] - visible[f]) <= tolerance) continue;
    complaints.push_back("the seen triangles of face " + std::to_string(f) + " cover " + std::to_string(seen[f]) +
                         " of the image, its visible polygons " + std::to_string(visible[f]));
  }
  return complaints;
}

}  // namespace sightline::lattice
