// The surface is refined where the pieces of a face meet, and where pieces of two faces do.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "oracle/lattice/lattice.h"
#include "tests/tools/analyzed.h"
#include "tests/tools/polygon_mesh.h"

namespace sightline::tests::refinement_test {
namespace {

Camera slanting() { return perspective_camera("slanting", {{1, -9, 6}, {0, 0, 0}, {0, 0, 1}, 1, {}, {}}, 50); }

// The angle is between a -> b and a -> c.
double angle(const Point3& a, const Point3& b, const Point3& c) {
  const Vector3 u = b - a;
  const Vector3 v = c - a;
  return std::atan2(norm(u.cross(v)), u.dot(v));
}

// Returns, per edge within one face and label, the sum of the angles opposite to it.
std::vector<double> opposite_angles(const LabelledMesh& labelled) {
  struct Edge {
    double sum = 0;
    int triangles = 0;
    bool is_inner = true;
    const LabelledTriangle* first = nullptr;
  };
  std::map<std::array<VertexId, 2>, Edge> edges;
  for (const LabelledTriangle& t : labelled.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexId a = t.corners[i];
      const VertexId b = t.corners[(i + 1) % 3];
      const VertexId tip = t.corners[(i + 2) % 3];
      Edge& edge = edges[{std::min(a, b), std::max(a, b)}];
      const auto at = [&](VertexId v) { return labelled.vertices[v.index()]; };
      edge.sum += angle(at(tip), at(a), at(b));
      ++edge.triangles;
      if (edge.first == nullptr) edge.first = &t;
      edge.is_inner = edge.is_inner && edge.first->face == t.face && edge.first->label == t.label;
    }
  }
  std::vector<double> angles;
  for (const auto& [ends, edge] : edges) {
    if (edge.is_inner && edge.triangles == 2) angles.push_back(edge.sum);
  }
  return angles;
}

// Two triangles have a common edge across the window, and before them a small one hides the edge's middle.
std::vector<Point3> splits_of_common_edge(lattice::Dice& dice, bool exchange) {
  const auto near = [&](double x, double y, double z) -> Vector3 {
    const auto off = [&] { return dice.between(-1000, 1000) / 3001.0; };
    return Point3{x + off(), y + off(), z + off()};
  };
  const Point3 a = near(-3, 0, 0);
  const Point3 b = near(3, 0, 0);
  std::vector<tests::Corners> faces{{a, b, near(0, 3, 0)}, {b, a, near(0, -3, 0)}};
  if (exchange) std::swap(faces[0], faces[1]);
  faces.push_back({near(-0.4, -3.6, 2), near(1, -3.6, 2), near(0.3, -2.2, 2)});
  const Mesh mesh = tests::mesh_of(faces);
  const LabelledMesh labelled = analyzed(mesh, slanting()).labelled;
  std::vector<Point3> added(labelled.vertices.begin() + static_cast<std::ptrdiff_t>(mesh.vertices.size()),
                            labelled.vertices.end());
  std::erase_if(added, [&](const Point3& p) { return norm((p - a).cross(b - a)) > 1e-9; });
  std::sort(added.begin(), added.end(), [](const Point3& p, const Point3& q) {
    return std::array{p.x(), p.y(), p.z()} < std::array{q.x(), q.y(), q.z()};
  });
  return added;
}

}  // namespace

TEST_CASE("the pieces of a face are Delaunay in its plane, however slanted it is seen") {
  const Mesh mesh = tests::mesh_of({{{-4, -3, 0}, {4, -3, 0}, {5, 4, 0}, {-3, 5, 0}},
                                    {{-1, -1, 1}, {0.5, -1.2, 1.3}, {0.2, 0.4, 1.1}},
                                    {{1, 0, 1}, {2.2, 0.3, 1.2}, {1.4, 1, 1.4}}});
  const std::vector<double> angles = opposite_angles(analyzed(mesh, slanting()).labelled);
  CHECK(angles.size() > 10);
  for (const double sum : angles) CHECK(sum <= std::numbers::pi + 1e-9);
}

TEST_CASE("a split of an edge is the same point whichever of its faces comes first") {
  constexpr std::uint64_t seed = 5;
  INFO("seed ", seed);
  for (std::uint64_t i = 0; i < 30; ++i) {
    CAPTURE(i);
    lattice::Dice first(seed + i);
    lattice::Dice second(seed + i);
    const std::vector<Point3> splits = splits_of_common_edge(first, false);
    CHECK(splits.size() == 2);
    CHECK(splits == splits_of_common_edge(second, true));
  }
}

}  // namespace sightline::tests::refinement_test
