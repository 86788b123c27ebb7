// Ids, labels and surfaces are checked here; face_areas.h has areas and orientation, conformity.h the rest.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "geometry/cutting/common_lines.h"
#include "geometry/mesh/facet_plane.h"
#include "geometry/numbers/id_names.h"
#include "reconstruct/labelling/conformity.h"
#include "reconstruct/labelling/face_areas.h"
#include "reconstruct/labelling/labelled_mesh.h"

namespace sightline::inline reconstruct {
namespace {

using Messages = std::vector<std::string>;

std::string triangle_name(std::size_t t) { return "triangle " + std::to_string(t); }

bool same_bits(const Point3& a, const Point3& b) {
  const auto bits = [](const Point3& p) {
    return std::array{std::bit_cast<std::uint64_t>(p.x()), std::bit_cast<std::uint64_t>(p.y()),
                      std::bit_cast<std::uint64_t>(p.z())};
  };
  return bits(a) == bits(b);
}

void check_vertices(const LabelledMesh& labelled, const CutMesh& mesh, Messages& messages) {
  if (labelled.vertices.size() < mesh.input_vertex_count()) {
    messages.emplace_back("vertices: fewer than the input's");
    return;
  }
  for (std::size_t v = 0; v < labelled.vertices.size(); ++v) {
    const Point3& p = labelled.vertices[v];
    if (!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
      messages.push_back(name(VertexId(v)) + " is not finite");
    if (v < mesh.input_vertex_count() && !same_bits(p, mesh.vertices[v]))
      messages.push_back(name(VertexId(v)) + " is not where the input has it");
  }
}

void check_triangle(const LabelledMesh& labelled, const CutMesh& mesh, std::size_t index, Messages& messages) {
  const LabelledTriangle& t = labelled.triangles[index];
  const auto& [a, b, c] = t.corners;
  const auto report = [&](bool wrong, const std::string& what) {
    if (wrong) messages.push_back(triangle_name(index) + what);
  };
  report(std::ranges::any_of(t.corners, [&](VertexId v) { return v.index() >= labelled.vertices.size(); }),
         " has a corner that is no vertex");
  report(a == b || b == c || c == a, " has a corner twice");
  report(t.label > Label::visible, " has no such label");
  report(t.label != Label::back_facing && t.seen != (t.label == Label::visible), " is seen or not, against its label");
  report(index > 0 && t.face < labelled.triangles[index - 1].face, " is not listed with its face");
  const bool is_face = t.face.index() < mesh.face_count();
  report(!is_face, " is of no face");
  report(is_face && mesh.first_facet(t.face) == mesh.end_facet(t.face),
         " is of " + name(t.face) + ", which is skipped");
}

// Surfaces are named by the facets of the mesh as it was cut.
void check_surfaces(const LabelledMesh& labelled, const CutMesh& mesh, Messages& messages) {
  FacetId last(0);
  for (std::size_t i = 0; i < labelled.triangles.size(); ++i) {
    const LabelledTriangle& t = labelled.triangles[i];
    const bool is_surface = t.surface.index() < mesh.facet_count() && surface_of(mesh, t.surface) == t.surface;
    if (!is_surface || mesh.facet_face[t.surface.index()] != t.face) {
      messages.push_back(triangle_name(i) + " is on no surface of its face");
    } else if (t.surface < last) {
      messages.push_back(triangle_name(i) + " is not listed with its surface");
    } else {
      last = t.surface;
    }
  }
}

void check_refinement(const LabelledMesh& labelled, const PolygonMesh& uncut, const ProjectedScene& scene,
                      Messages& messages) {
  check_face_areas(labelled, uncut, scene, messages);
  check_conformity(labelled, uncut, messages);
}

}  // namespace

std::vector<std::string> validate(const LabelledMesh& labelled, const ProjectedScene& scene) {
  const CutMesh& mesh = scene.mesh();
  Messages messages;
  check_vertices(labelled, mesh, messages);
  for (std::size_t t = 0; t < labelled.triangles.size(); ++t) check_triangle(labelled, mesh, t, messages);
  check_surfaces(labelled, mesh, messages);
  if (!messages.empty()) return messages;
  if (mesh.is_cut()) {
    check_refinement(labelled, without_cuts(mesh), scene, messages);
  } else {
    check_refinement(labelled, mesh, scene, messages);
  }
  return messages;
}

}  // namespace sightline::inline reconstruct
