#include "geometry/mesh/validate_facets.h"

#include <algorithm>
#include <map>

#include "geometry/faces/face_shape.h"
#include "geometry/faces/face_triangulation.h"
#include "geometry/numbers/id_names.h"

namespace sightline::inline geometry {

namespace {

using Messages = std::vector<std::string>;

void check_facet_shapes(const PolygonMesh& mesh, Messages& messages) {
  for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
    std::vector<VertexId> corners(mesh.facets[f].begin(), mesh.facets[f].end());
    remove_spikes(corners, mesh.vertices);
    const PolygonView polygon{mesh.facets[f], mesh.vertices};
    const std::size_t face = mesh.facet_face[f].index();
    const bool alone = mesh.face_facet[face + 1].index() - mesh.face_facet[face].index() == 1;
    if (corners.size() < 3 || corners.size() != polygon.size())
      messages.push_back(name(FacetId(f)) + " has corners that bound nothing");
    else if (!is_planar(polygon))
      messages.push_back(name(FacetId(f)) + " is not planar");
    else if (!is_convex(polygon))
      messages.push_back(name(FacetId(f)) + " is not convex");
    if (!alone && polygon.size() != 3) messages.push_back(name(FacetId(f)) + " is a part of a face, and no triangle");
  }
}

// A boundary counts how often it runs along each edge, less how often it runs back.
using Boundary = std::map<std::pair<VertexId, VertexId>, int>;

void add_edge(Boundary& boundary, VertexId a, VertexId b) {
  if (a == b) return;
  const bool up = a < b;
  const auto place = boundary.try_emplace(up ? std::pair(a, b) : std::pair(b, a)).first;
  place->second += up ? 1 : -1;
  if (place->second == 0) boundary.erase(place);
}

// Returns the welded corners of a face that lie inside the edge from a to b, with both ends, in order.
std::vector<VertexId> stops_between(const PolygonMesh& mesh, std::span<const VertexId> corners, VertexId a,
                                    VertexId b) {
  std::vector<VertexId> stops{a, b};
  for (const VertexId corner : corners) {
    const VertexId v = mesh.weld[corner.index()];
    const auto inside = [&] { return collinear(mesh.position(a), mesh.position(b), mesh.position(v)); };
    const bool up = lexicographically_less(mesh.position(a), mesh.position(v));
    const bool between = up == lexicographically_less(mesh.position(v), mesh.position(b)) &&
                         up == lexicographically_less(mesh.position(a), mesh.position(b));
    if (v != a && v != b && between && inside()) stops.push_back(v);
  }
  std::ranges::sort(stops,
                    [&](VertexId u, VertexId v) { return lexicographically_less(mesh.position(u), mesh.position(v)); });
  stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
  if (stops.front() != a) std::ranges::reverse(stops);
  return stops;
}

// With `divided`, edges are cut at all these corners.
void add_boundary(Boundary& boundary, const PolygonMesh& mesh, std::span<const VertexId> polygon,
                  std::span<const VertexId> corners, bool divided) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const VertexId a = mesh.weld[polygon[i].index()];
    const VertexId b = mesh.weld[polygon[(i + 1) % polygon.size()].index()];
    if (a == b) continue;
    const std::vector<VertexId> stops = divided ? stops_between(mesh, corners, a, b) : std::vector{a, b};
    for (std::size_t s = 0; s + 1 < stops.size(); ++s) add_edge(boundary, stops[s], stops[s + 1]);
  }
}

bool boundaries_agree(const PolygonMesh& mesh, FaceId f, bool divided) {
  const auto face = mesh.faces[f.index()];
  // The corners are those of the face, and those that it has of another face (shared_corners.h).
  std::vector<VertexId> corners(face.begin(), face.end());
  for (std::size_t i = mesh.first_facet(f); i < mesh.end_facet(f); ++i)
    corners.insert(corners.end(), mesh.facets[i].begin(), mesh.facets[i].end());
  Boundary of_face;
  Boundary of_facets;
  add_boundary(of_face, mesh, face, corners, divided);
  for (std::size_t i = mesh.first_facet(f); i < mesh.end_facet(f); ++i)
    add_boundary(of_facets, mesh, mesh.facets[i], corners, divided);
  return of_face == of_facets;
}

// Returns whether the triangles are counter-clockwise and apart in one view of the face. With equal boundaries they
// then cover it.
bool is_one_layer(const PolygonMesh& mesh, FaceId f) {
  std::vector<Triangle> triangles;
  for (std::size_t i = mesh.first_facet(f); i < mesh.end_facet(f); ++i) {
    const auto c = mesh.facets[i];
    if (c.size() == 3) triangles.push_back({c[0], c[1], c[2]});
  }
  std::vector<VertexId> outline(mesh.faces[f.index()].begin(), mesh.faces[f.index()].end());
  remove_spikes(outline, mesh.vertices);
  return std::ranges::any_of(face_views({outline, mesh.vertices}), [&](const FaceView& view) {
    const auto turns_left = [&](const Triangle& t) {
      return view.turn(mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2])) > 0;
    };
    return std::ranges::all_of(triangles, turns_left) && interiors_disjoint(view, triangles, mesh.vertices);
  });
}

void check_faces(const PolygonMesh& mesh, Messages& messages) {
  for (std::size_t i = 0; i < mesh.face_count(); ++i) {
    const FaceId f(i);
    const bool planar = is_planar({mesh.faces[i], mesh.vertices});
    if ((mesh.face_planar[i] != 0) != planar) messages.push_back(name(f) + (planar ? " is planar" : " is not planar"));
    const std::size_t count = mesh.end_facet(f) - mesh.first_facet(f);
    if (count == 0) continue;
    if (!boundaries_agree(mesh, f, false) && !boundaries_agree(mesh, f, true))
      messages.push_back(name(f) + " is not covered by its facets");
    if (count > 1 && !is_one_layer(mesh, f))
      messages.push_back(name(f) + " has facets that overlap or are turned over");
  }
}

}  // namespace

void check_facets(const PolygonMesh& mesh, std::vector<std::string>& messages) {
  check_facet_shapes(mesh, messages);
  check_faces(mesh, messages);
}

}  // namespace sightline::inline geometry
