#include <algorithm>
#include <cmath>

#include "geometry/faces/face_shape.h"
#include "geometry/mesh/mesh.h"
#include "geometry/mesh/validate_facets.h"
#include "geometry/numbers/id_names.h"

namespace sightline::inline geometry {

namespace {

using Messages = std::vector<std::string>;

bool is_list(const PolygonList& polygons, std::size_t vertex_count) {
  return !polygons.begin.empty() && polygons.begin.front() == 0 && std::ranges::is_sorted(polygons.begin) &&
         polygons.begin.back() == polygons.corners.size() &&
         std::ranges::all_of(polygons.corners, [&](VertexId v) { return v.index() < vertex_count; });
}

void check_vertices(const PolygonMesh& mesh, Messages& messages) {
  std::vector<VertexId> order;
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Point3& p = mesh.vertices[i];
    if (!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
      messages.push_back(name(VertexId(i)) + " is not finite");
    order.emplace_back(i);
  }
  std::ranges::stable_sort(
      order, [&](VertexId a, VertexId b) { return lexicographically_less(mesh.position(a), mesh.position(b)); });
  VertexId first;
  for (const VertexId v : order) {
    if (!first.valid() || mesh.position(first) != mesh.position(v)) first = v;
    if (mesh.weld[v.index()] != first)
      messages.push_back(name(v) + " is not welded to the first vertex with its position");
  }
}

void check_edges(const PolygonMesh& mesh, Messages& messages) {
  const auto key = [&](std::size_t e) {
    return std::pair(mesh.position(mesh.edges[e][0]), mesh.position(mesh.edges[e][1]));
  };
  const auto less = [](const auto& a, const auto& b) {
    return a.first == b.first ? lexicographically_less(a.second, b.second) : lexicographically_less(a.first, b.first);
  };
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const auto [a, b] = mesh.edges[e];
    const bool welded = mesh.weld[a.index()] == a && mesh.weld[b.index()] == b;
    if (!welded) messages.push_back(name(MeshEdgeId(e)) + " has an end that is not welded");
    if (!lexicographically_less(mesh.position(a), mesh.position(b)))
      messages.push_back(name(MeshEdgeId(e)) + " has its ends out of order");
    if (e > 0 && !less(key(e - 1), key(e))) messages.push_back(name(MeshEdgeId(e)) + " is repeated or out of order");
  }
}

void check_defects(const PolygonMesh& mesh, Messages& messages) {
  std::vector<bool> skipped(mesh.face_count());
  for (std::size_t i = 0; i < mesh.defects.size(); ++i) {
    const auto [face, defect] = mesh.defects[i];
    if (i > 0 && !(mesh.defects[i - 1].face < face))
      messages.push_back(name(face) + ": defects are repeated or out of order");
    skipped[face.index()] = is_skipped(defect);
  }
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const bool drawn = mesh.first_facet(FaceId(f)) < mesh.end_facet(FaceId(f));
    if (drawn == skipped[f])
      messages.push_back(name(FaceId(f)) + (drawn ? " is skipped but has facets" : " has no facet and no defect"));
  }
}

}  // namespace

// Sizes and ranges come first: the other checks need them in order to look at anything.
Messages check_arrays(const PolygonMesh& mesh) {
  Messages messages;
  const auto require = [&](bool holds, const char* what) {
    if (!holds) messages.emplace_back(what);
  };
  require(is_list(mesh.faces, mesh.vertices.size()), "faces: not a list of polygons over the vertices");
  require(is_list(mesh.facets, mesh.vertices.size()), "facets: not a list of polygons over the vertices");
  if (!messages.empty()) return messages;
  const auto below = [](std::size_t end) { return [end](auto id) { return id.index() < end; }; };
  require(mesh.facet_face.size() == mesh.facets.size(), "facet_face: not one entry per facet");
  require(mesh.face_facet.size() == mesh.faces.size() + 1, "face_facet: not one entry per face and one more");
  require(mesh.face_planar.size() == mesh.faces.size(), "face_planar: not one entry per face");
  require(mesh.weld.size() == mesh.vertices.size(), "weld: not one entry per vertex");
  require(mesh.facet_edges.size() == mesh.facets.corners.size(), "facet_edges: not one entry per corner of a facet");
  require(std::ranges::all_of(mesh.facet_face, below(mesh.faces.size())), "facet_face: names no face");
  require(std::ranges::all_of(mesh.face_facet, below(mesh.facets.size() + 1)), "face_facet: names no facet");
  require(std::ranges::all_of(mesh.weld, below(mesh.vertices.size())), "weld: names no vertex");
  require(std::ranges::all_of(mesh.facet_edges, below(mesh.edges.size())), "facet_edges: names no mesh edge");
  for (const auto& ends : mesh.edges)
    require(std::ranges::all_of(ends, below(mesh.vertices.size())), "edges: names no vertex");
  for (const FaceDefect& d : mesh.defects) require(d.face.index() < mesh.faces.size(), "defects: names no face");
  return messages;
}

void check_facet_edges(const PolygonMesh& mesh, Messages& messages) {
  std::vector<bool> used(mesh.edges.size());
  for (std::size_t f = 0; f < mesh.facets.size(); ++f) {
    const auto corners = mesh.facets[f];
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const MeshEdgeId edge = mesh.edges_of(FacetId(f))[i];
      used[edge.index()] = true;
      const VertexId a = mesh.weld[corners[i].index()];
      const VertexId b = mesh.weld[corners[(i + 1) % corners.size()].index()];
      const auto& ends = mesh.edges[edge.index()];
      if (ends != std::array{a, b} && ends != std::array{b, a}) {
        messages.push_back(name(FacetId(f)) + ": " + name(edge) + " does not join its corners " + std::to_string(i) +
                           " and the next");
      }
    }
  }
  for (std::size_t e = 0; e < used.size(); ++e) {
    if (!used[e]) messages.push_back(name(MeshEdgeId(e)) + " belongs to no facet");
  }
}

void check_numbering(const PolygonMesh& mesh, Messages& messages) {
  if (mesh.face_facet.front() != FacetId(0) || mesh.face_facet.back() != FacetId(mesh.facet_count()) ||
      !std::ranges::is_sorted(mesh.face_facet)) {
    messages.emplace_back("face_facet does not run from 0 to the number of facets");
    return;
  }
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    for (std::size_t i = mesh.first_facet(FaceId(f)); i < mesh.end_facet(FaceId(f)); ++i) {
      if (mesh.facet_face[i] != FaceId(f))
        messages.push_back(name(FacetId(i)) + " is not listed with its " + name(mesh.facet_face[i]));
    }
  }
}

std::vector<std::string> validate(const Mesh& mesh) {
  Messages messages = check_arrays(mesh);
  if (!messages.empty()) return messages;
  check_vertices(mesh, messages);
  check_edges(mesh, messages);
  check_facet_edges(mesh, messages);
  check_numbering(mesh, messages);
  if (!messages.empty()) return messages;
  check_defects(mesh, messages);
  check_facets(mesh, messages);
  return messages;
}

}  // namespace sightline::inline geometry
