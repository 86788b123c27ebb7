// build_mesh is tested on the public models, and validate on meshes with one thing broken.
#include "geometry/mesh/mesh.h"
#include "geometry/mesh/shared_corners.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <stdexcept>

#include "geometry/mesh/mesh_topology.h"
#include "tests/tools/obj_case.h"

namespace sightline::tests::mesh_test {
namespace {

PolygonList polygons(const std::vector<std::vector<std::size_t>>& lists) {
  PolygonList result;
  for (const auto& list : lists) {
    std::vector<VertexId> corners;
    for (const std::size_t v : list) corners.emplace_back(v);
    result.push_back(corners);
  }
  return result;
}

// The example has a planar quad, a concave pentagon of three facets on its right edge, a skipped face, and a warped
// quad; the vertices 4 and 1, and 5 and 2, are equal.
Mesh example() {
  return build_mesh({{0, 0, 0},
                     {2, 0, 0},
                     {2, 2, 0},
                     {0, 2, 0},
                     {2, 0, 0},
                     {2, 2, 0},
                     {3, 1, 0},
                     {5, 2, 0},
                     {5, 0, 0},
                     {0, 2, 5},
                     {2, 3, 5}},
                    polygons({{0, 1, 2, 3}, {4, 8, 7, 6, 5}, {0, 1, 1}, {3, 2, 10, 9}}));
}

TEST_CASE("vertices are welded, facets and edges numbered in order") {
  const Mesh mesh = example();
  CHECK(validate(mesh) == std::vector<std::string>{});
  CHECK(mesh.face_planar == std::vector<std::uint8_t>{1, 1, 1, 0});
  CHECK(mesh.facet_face == std::vector<FaceId>{FaceId(0), FaceId(1), FaceId(1), FaceId(1), FaceId(3), FaceId(3)});
  CHECK(mesh.face_facet == std::vector<FacetId>{FacetId(0), FacetId(1), FacetId(4), FacetId(4), FacetId(6)});
  CHECK(mesh.weld[4] == VertexId(1));
  CHECK(mesh.weld[5] == VertexId(2));
  CHECK(mesh.edges.front() == std::array{VertexId(0), VertexId(3)});
  // The quad has 4, the pentagon 4 + 2 more, the warped quad 3 + 1 more.
  CHECK(mesh.edges.size() == 4 + 4 + 2 + 3 + 1);
}

TEST_CASE("an empty mesh is valid") { CHECK(validate(build_mesh({}, {})) == std::vector<std::string>{}); }

TEST_CASE("corners that name no vertex and coordinates that are not finite are refused") {
  CHECK_THROWS_AS((void)build_mesh({{0, 0, 0}}, polygons({{0, 1, 0}})), std::invalid_argument);
  CHECK_THROWS_AS((void)build_mesh({{0, std::numeric_limits<double>::infinity(), 0}}, {}), std::invalid_argument);
  CHECK_THROWS_AS((void)build_mesh({{0, 0, std::numeric_limits<double>::quiet_NaN()}}, {}), std::invalid_argument);
}

TEST_CASE("facets keep the vertices that the face names, not those they are welded to") {
  const Mesh mesh = example();
  for (std::size_t f = 1; f < 4; ++f) {
    for (const VertexId v : mesh.facets[f]) CHECK(v.index() >= 4);
  }
}

TEST_CASE("an edge has the corners of its own face that lie on it, for its other face too") {
  // Corner 3 of the first face touches its edge from 0 to 1.
  const Mesh mesh = build_mesh({{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {2, 0, 0}, {0, 2, 0}, {2, -2, 1}},
                               polygons({{0, 1, 2, 3, 4}, {1, 0, 5}}));
  CHECK(validate(mesh) == std::vector<std::string>{});
  CHECK(mesh.facet_count() == 3);
  const auto neighbour = mesh.corners(FacetId(2));
  CHECK(std::vector(neighbour.begin(), neighbour.end()) ==
        std::vector{VertexId(1), VertexId(3), VertexId(0), VertexId(5)});
  CHECK(std::ranges::count(mesh.edges, std::array{VertexId(0), VertexId(1)}) == 0);
  CHECK(mesh.edges.size() == 6 + 2);
}

struct Mutation {
  std::string part_of_message;
  std::function<void(Mesh&)> break_it;
};

// The facets of the example are 0 of the quad, 1 to 3 of the pentagon, 4 and 5 of the warped quad.
const std::vector<Mutation> mutations{
    {"facet_face: names no face", [](Mesh& m) { m.facet_face[0] = FaceId(99); }},
    {"facet_face: not one entry", [](Mesh& m) { m.facet_face.pop_back(); }},
    {"facets: not a list", [](Mesh& m) { m.facets.corners[0] = VertexId(99); }},
    {"faces: not a list", [](Mesh& m) { m.faces.begin.back() += 1; }},
    {"facet_edges: names no mesh edge", [](Mesh& m) { m.facet_edges[0] = MeshEdgeId(99); }},
    {"vertex 0 is not finite", [](Mesh& m) { m.vertices[0].x() = std::numeric_limits<double>::infinity(); }},
    {"vertex 4 is not welded", [](Mesh& m) { m.weld[4] = VertexId(4); }},
    {"vertex 0 is not welded", [](Mesh& m) { m.weld[0] = VertexId(3); }},
    {"mesh edge 0 has its ends out of order", [](Mesh& m) { std::swap(m.edges[0][0], m.edges[0][1]); }},
    {"mesh edge 1 is repeated or out of order", [](Mesh& m) { m.edges[1] = m.edges[0]; }},
    {"has an end that is not welded",
     [](Mesh& m) { std::ranges::replace(m.edges.back(), m.edges.back()[1], VertexId(4)); }},
    {"facet 0: mesh edge", [](Mesh& m) { std::swap(m.facet_edges[0], m.facet_edges[1]); }},
    {"belongs to no facet",
     [](Mesh& m) {
       m.edges.push_back({VertexId(7), VertexId(7)});
     }},
    {"facet 1 is not listed with its face 0", [](Mesh& m) { m.facet_face[1] = FaceId(0); }},
    {"face_facet does not run", [](Mesh& m) { m.face_facet.front() = FacetId(1); }},
    {"face 2 has no facet and no defect", [](Mesh& m) { m.defects.clear(); }},
    {"face 0 is skipped but has facets",
     [](Mesh& m) {
       m.defects.insert(m.defects.begin(), {FaceId(0), Defect::zero_area});
     }},
    {"defects are repeated", [](Mesh& m) { m.defects.push_back(m.defects.front()); }},
    {"face 3 is not planar", [](Mesh& m) { m.face_planar[3] = 1; }},
    {"face 0 is planar", [](Mesh& m) { m.face_planar[0] = 0; }},
};

void check_reported(const Mesh& mesh, const std::string& part) {
  const auto messages = validate(mesh);
  INFO("expected: " << part << ", got: " << (messages.empty() ? "nothing" : messages.front()));
  CHECK(std::ranges::any_of(messages, [&](const std::string& m) { return m.find(part) != std::string::npos; }));
}

TEST_CASE("validate reports a broken array with the ids") {
  for (const auto& [part, break_it] : mutations) {
    Mesh mesh = example();
    break_it(mesh);
    check_reported(mesh, part);
  }
}

// Returns the example with other facets, and edges to match, so that only the shapes are wrong.
Mesh with_facets(const std::vector<std::vector<std::size_t>>& facets, std::vector<std::size_t> first_of_face) {
  Mesh mesh = example();
  mesh.facets = polygons(facets);
  MeshEdges edges = make_mesh_edges(mesh.facets, weld_vertices(mesh.vertices));
  mesh.edges = std::move(edges.ends);
  mesh.facet_edges = std::move(edges.of_corner);
  mesh.facet_face.clear();
  mesh.face_facet.clear();
  for (const std::size_t f : first_of_face) mesh.face_facet.emplace_back(f);
  for (std::size_t f = 0; f < mesh.face_count(); ++f) mesh.facet_face.resize(first_of_face[f + 1], FaceId(f));
  return mesh;
}

TEST_CASE("validate reports facets of the wrong shape") {
  const std::vector<std::size_t> quad{0, 1, 2, 3};
  const std::vector<std::size_t> first{0, 1, 4, 4, 6};
  CHECK(validate(with_facets({quad, {4, 8, 6}, {8, 7, 6}, {6, 5, 4}, {3, 2, 10}, {3, 10, 9}}, first)) ==
        std::vector<std::string>{});
  // The quad is a triangle.
  check_reported(with_facets({{0, 1, 2}, {4, 8, 6}, {8, 7, 6}, {6, 5, 4}, {3, 2, 10}, {3, 10, 9}}, first),
                 "face 0 is not covered");
  // The quad is turned over.
  check_reported(with_facets({{3, 2, 1, 0}, {4, 8, 6}, {8, 7, 6}, {6, 5, 4}, {3, 2, 10}, {3, 10, 9}}, first),
                 "face 0 is not covered");
  // Two corners are exchanged.
  check_reported(with_facets({quad, {8, 4, 6}, {8, 7, 6}, {6, 5, 4}, {3, 2, 10}, {3, 10, 9}}, first),
                 "face 1 is not covered");
  // A fan goes round a corner that does not see the others: the boundary is right, a triangle is turned over.
  check_reported(with_facets({quad, {5, 4, 8}, {5, 8, 7}, {5, 7, 6}, {3, 2, 10}, {3, 10, 9}}, first),
                 "face 1 has facets that overlap");
  // The warped quad is in one piece, and so is the pentagon.
  check_reported(with_facets({quad, {4, 8, 6}, {8, 7, 6}, {6, 5, 4}, {3, 2, 10, 9}}, {0, 1, 4, 4, 5}),
                 "facet 4 is not planar");
  check_reported(with_facets({quad, {4, 8, 7, 6, 5}, {3, 2, 10}, {3, 10, 9}}, {0, 1, 2, 2, 4}),
                 "facet 1 is not convex");
}

// A row of the models' README has triangles after fanning, vertices, boundary edges, and edges with more than two
// faces.
struct Model {
  std::string file;
  std::size_t triangles;
  std::size_t vertices;
  std::size_t boundary;
  std::size_t non_manifold;
};

const std::vector<Model> models{
    {"CornellBox-Mirror.obj", 36, 72, 14, 6},
    {"suzanne.obj", 968, 507, 42, 0},
    {"openscad-nonmanifold-crash.obj", 1442, 717, 0, 18},
    {"beetle.obj", 2053, 1148, 296, 47},
    {"featuretype.obj", 3476, 2010, 576, 0},
    {"holodeck.obj", 4015, 2089, 139, 0},
    {"spot.obj", 5856, 2930, 0, 0},
    {"teapot.obj", 6320, 3644, 160, 0},
    {"self_intersectA.obj", 17160, 8582, 0, 0},
    {"mountain.obj", 50562, 25600, 636, 0},
    {"stanford-bunny.obj", 69451, 35947, 223, 0},
    {"lion_vase_poly.obj", 92408, 46206, 0, 0},
    {"lost_empire.obj", 224998, 97077, 2184, 15841},
    {"armadillo.obj", 345944, 172974, 0, 0},
};

// Returns, for each edge of the faces as given, ends welded, how many faces use it.
std::vector<std::size_t> faces_per_edge(const Mesh& mesh) {
  std::vector<std::pair<VertexId, VertexId>> edges;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto corners = mesh.faces[f];
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const VertexId a = mesh.weld[corners[i].index()];
      const VertexId b = mesh.weld[corners[(i + 1) % corners.size()].index()];
      if (a != b) edges.emplace_back(std::minmax(a, b));
    }
  }
  std::ranges::sort(edges);
  std::vector<std::size_t> uses;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (i == 0 || edges[i] != edges[i - 1]) uses.push_back(0);
    ++uses.back();
  }
  return uses;
}

std::vector<std::size_t> facets_per_edge(const Mesh& mesh) {
  std::vector<std::size_t> uses(mesh.edges.size());
  for (const MeshEdgeId e : mesh.facet_edges) ++uses[e.index()];
  return uses;
}

std::size_t boundary_edges(const std::vector<std::size_t>& uses) {
  return static_cast<std::size_t>(std::ranges::count(uses, 1));
}

std::size_t non_manifold_edges(const std::vector<std::size_t>& uses) {
  return static_cast<std::size_t>(std::ranges::count_if(uses, [](std::size_t n) { return n > 2; }));
}

TEST_CASE("the public models have the edges that their table says") {
  const auto folder = shared_folder("models");
  if (folder.empty()) {
    MESSAGE("skipped: no folder of models");
    return;
  }
  for (const Model& model : models) {
    INFO("file: " << model.file);
    const Mesh mesh = read_obj(folder / model.file).mesh;
    CHECK(validate(mesh) == std::vector<std::string>{});
    CHECK(mesh.vertices.size() == model.vertices);
    CHECK(mesh.faces.corners.size() - 2 * mesh.face_count() == model.triangles);
    const std::vector<std::size_t> uses = faces_per_edge(mesh);
    CHECK(boundary_edges(uses) == model.boundary);
    CHECK(non_manifold_edges(uses) == model.non_manifold);
    if (!mesh.defects.empty() || mesh.facet_count() != mesh.face_count()) continue;
    CHECK(boundary_edges(facets_per_edge(mesh)) == model.boundary);
    CHECK(non_manifold_edges(facets_per_edge(mesh)) == model.non_manifold);
  }
}

}  // namespace

TEST_CASE("corners on one way of a slit come on the other way, too, in that way's direction") {
  const std::vector<Point3> vertices{{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}, {0, 4, 0}, {1, 4, 0},
                                     {2, 4, 0}, {3, 4, 0}, {4, 5, 0}, {5, 4, 0}, {4, 3, 0}};
  const auto corners_of = [&](std::initializer_list<std::size_t> outline) {
    std::vector<VertexId> corners;
    for (const std::size_t v : outline) corners.emplace_back(v);
    PolygonList outlines;
    outlines.push_back(corners);
    share_corners(outlines, vertices, weld_vertices(vertices));
    std::vector<std::size_t> result;
    for (const VertexId v : outlines[0]) result.push_back(v.index());
    return result;
  };
  const std::vector<std::size_t> both_ways{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 7, 6, 5, 4};
  CHECK(corners_of({0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 7, 4}) == both_ways);
  CHECK(corners_of({0, 1, 2, 3, 4, 7, 8, 9, 10, 7, 6, 5, 4}) == both_ways);
}

}  // namespace sightline::tests::mesh_test
