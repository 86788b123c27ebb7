#include "geometry/mesh/mesh.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "geometry/faces/face_shape.h"
#include "geometry/faces/face_triangulation.h"
#include "geometry/mesh/mesh_topology.h"
#include "geometry/mesh/shared_corners.h"
#include "geometry/numbers/predicates.h"

namespace sightline::inline geometry {

namespace {

using FaceDefects = std::vector<std::optional<Defect>>;  // per face

void require_usable(const std::vector<Point3>& vertices, const PolygonList& faces) {
  for (const Point3& p : vertices) {
    if (!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z())) {
      throw std::invalid_argument("build_mesh: a coordinate is not finite");
    }
  }
  for (const VertexId v : faces.corners) {
    if (v.index() >= vertices.size()) throw std::invalid_argument("build_mesh: a corner names no vertex");
  }
}

bool has_three_positions(std::span<const VertexId> corners, const Welding& welding) {
  if (corners.size() < 3) return false;
  const auto position = [&](VertexId v) { return welding.weld[v.index()]; };
  const VertexId first = position(corners[0]);
  const auto second = std::ranges::find_if(corners, [&](VertexId v) { return position(v) != first; });
  return std::any_of(second, corners.end(),
                     [&](VertexId v) { return position(v) != first && position(v) != position(*second); });
}

// Leaves in `outline` the corners that bound the face; there are none if the face is skipped.
std::optional<Defect> trim_outline(std::vector<VertexId>& outline, std::span<const Point3> vertices,
                                   const Welding& welding) {
  const std::size_t corner_count = outline.size();
  std::optional<Defect> defect;
  if (!has_three_positions(outline, welding)) {
    defect = Defect::too_few_corners;
  } else if (!corners_off_line({outline, vertices})) {
    defect = Defect::zero_area;
  } else if (corner_count > 3) {
    remove_spikes(outline, vertices);
    if (outline.size() < 3)
      defect = Defect::zero_area;
    else if (outline.size() < corner_count)
      defect = Defect::repeated_corner;
  }
  if (defect && is_skipped(*defect)) outline.clear();
  return defect;
}

// Returns the faces without what bounds nothing; those that are skipped are empty.
PolygonList outline_faces(const PolygonMesh& mesh, const Welding& welding, FaceDefects& defects) {
  PolygonList outlines;
  outlines.corners.reserve(mesh.faces.corners.size());
  std::vector<VertexId> outline;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    outline.assign(mesh.faces[f].begin(), mesh.faces[f].end());
    defects[f] = trim_outline(outline, mesh.vertices, welding);
    outlines.push_back(outline);
  }
  return outlines;
}

// Adds the facets of one face; returns false if it has none because its boundary crosses itself.
bool add_facets(PolygonList& facets, const PolygonView& outline, bool planar) {
  if (outline.size() == 3 || (planar && is_convex(outline))) {
    facets.push_back(outline.corners);
    return true;
  }
  const auto triangles = triangulate(outline);
  if (!triangles) return false;
  for (const Triangle& triangle : *triangles) facets.push_back(triangle);
  return true;
}

void make_facets(Mesh& mesh, const PolygonList& outlines, FaceDefects& defects) {
  mesh.facets.corners.reserve(outlines.corners.size());
  for (std::size_t f = 0; f < outlines.size(); ++f) {
    const bool planar = is_planar({mesh.faces[f], mesh.vertices});
    mesh.face_facet.emplace_back(mesh.facets.size());
    mesh.face_planar.push_back(planar ? 1 : 0);
    if (defects[f] && is_skipped(*defects[f])) continue;
    const PolygonView outline{outlines[f], mesh.vertices};
    const bool outline_planar = planar || (defects[f] && is_planar(outline));
    if (!add_facets(mesh.facets, outline, outline_planar)) defects[f] = Defect::self_crossing;
    mesh.facet_face.resize(mesh.facets.size(), FaceId(f));
  }
  mesh.face_facet.emplace_back(mesh.facets.size());
}

void list_defects(Mesh& mesh, const FaceDefects& defects) {
  for (std::size_t f = 0; f < defects.size(); ++f) {
    if (defects[f]) mesh.defects.push_back({FaceId(f), *defects[f]});
  }
}

}  // namespace

const char* to_string(Defect defect) {
  switch (defect) {
    case Defect::too_few_corners:
      return "too few corners";
    case Defect::zero_area:
      return "zero area";
    case Defect::self_crossing:
      return "self-crossing boundary";
    case Defect::repeated_face:
      return "repeated face";
    case Defect::repeated_corner:
      return "repeated corner";
  }
  return "unknown defect";
}

bool is_skipped(Defect defect) { return defect != Defect::repeated_corner; }

Mesh build_mesh(std::vector<Point3> vertices, PolygonList faces) {
  require_usable(vertices, faces);
  Mesh mesh;
  mesh.vertices = std::move(vertices);
  mesh.faces = std::move(faces);
  Welding welding = weld_vertices(mesh.vertices);
  FaceDefects defects(mesh.faces.size());
  PolygonList outlines = outline_faces(mesh, welding, defects);
  const std::vector<bool> repeated = find_repeated(outlines, welding);
  for (std::size_t f = 0; f < repeated.size(); ++f) {
    if (repeated[f]) defects[f] = Defect::repeated_face;
  }
  share_corners(outlines, mesh.vertices, welding);
  make_facets(mesh, outlines, defects);
  list_defects(mesh, defects);
  MeshEdges edges = make_mesh_edges(mesh.facets, welding);
  mesh.weld = std::move(welding.weld);
  mesh.edges = std::move(edges.ends);
  mesh.facet_edges = std::move(edges.of_corner);
  return mesh;
}

}  // namespace sightline::inline geometry
