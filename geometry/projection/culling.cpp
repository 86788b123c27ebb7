#include "geometry/projection/culling.h"

#include <optional>
#include <vector>

#include "geometry/mesh/components.h"

namespace sightline::inline geometry {
namespace {

// An objection says why culling could change the picture; there is none where it cannot.
using Objection = std::optional<std::string>;

std::string name(std::uint32_t id) { return std::to_string(id); }

// This counts how many facets run through an edge from its first end to its second, and back.
struct EdgeUse {
  std::uint32_t forward = 0;
  std::uint32_t backward = 0;
};

std::vector<EdgeUse> count_edge_uses(const CutMesh& mesh) {
  std::vector<EdgeUse> uses(mesh.edges.size());
  for (std::size_t i = 0; i < mesh.facet_edges.size(); ++i) {
    const std::size_t edge = mesh.facet_edges[i].index();
    const bool forward = mesh.weld[mesh.facets.corners[i].index()] == mesh.edges[edge][0];
    ++(forward ? uses[edge].forward : uses[edge].backward);
  }
  return uses;
}

std::string describe(const EdgeUse& use) {
  const std::uint32_t facets = use.forward + use.backward;
  if (facets == 2) return " has two facets that run along it in one direction";
  return facets == 1 ? " has one facet" : " has " + std::to_string(facets) + " facets";
}

Objection open_edge(const CutMesh& mesh) {
  const std::vector<EdgeUse> uses = count_edge_uses(mesh);
  for (std::size_t e = 0; e < uses.size(); ++e) {
    if (uses[e].forward + uses[e].backward == 0 || (uses[e].forward == 1 && uses[e].backward == 1)) continue;
    return "edge " + name(mesh.edges[e][0].value) + "-" + name(mesh.edges[e][1].value) + describe(uses[e]);
  }
  return std::nullopt;
}

std::string describe(const CutMesh& mesh, const std::array<FacetId, 2>& pair, const std::string& verb) {
  const FaceId first = mesh.facet_face[pair[0].index()];
  const FaceId second = mesh.facet_face[pair[1].index()];
  if (first == second) return "face " + name(first.value) + " meets itself";
  return "faces " + name(first.value) + " and " + name(second.value) + " " + verb;
}

Objection first_crossing(const CutMesh& mesh, const MeshContacts& contacts) {
  if (contacts.crossing.empty()) return std::nullopt;
  if (!mesh.is_cut()) return describe(mesh, contacts.crossing.front(), "cross");
  const auto [a, b] = mesh.cuts.crossing.front();
  return describe(mesh, {mesh.cuts.first_facet[a.index()], mesh.cuts.first_facet[b.index()]}, "cross");
}

// A mesh that was not cut has its facets under their own numbers.
Objection first_touch(const CutMesh& mesh, const MeshContacts& contacts) {
  if (!contacts.touching.empty()) return describe(mesh, contacts.touching.front(), "touch");
  return std::nullopt;
}

Objection component_around(const CutMesh& mesh, const Component& component, const HomogeneousPoint& eye) {
  const std::string surface = "the surface of face " + name(mesh.facet_face[component.front().index()].value);
  if (volume_sign(mesh, component) <= 0) return surface + " is inside out";
  if (eye.w == 0) return std::nullopt;
  const Location location = location_of(eye.xyz, mesh, component);
  if (location == Location::inside) return "the eye is inside " + surface;
  if (location == Location::on_surface) return "the eye is on " + surface;
  return std::nullopt;
}

Objection objection(const CutMesh& mesh, const MeshContacts& contacts, const Camera& camera) {
  if (camera.near_distance) return "the near plane may cut the surface open";
  if (const Objection crossing = first_crossing(mesh, contacts)) return crossing;
  if (const Objection edge = open_edge(mesh)) return edge;
  if (const Objection touch = first_touch(mesh, contacts)) return touch;
  for (const Component& component : components(mesh)) {
    if (const Objection around = component_around(mesh, component, camera.eye)) return around;
  }
  return std::nullopt;
}

}  // namespace

bool is_closed(const CutMesh& mesh) { return !open_edge(mesh); }

SidesDecision decide_sides(const CutMesh& mesh, const MeshContacts& contacts, const Camera& camera,
                           SidesPolicy policy) {
  if (policy == SidesPolicy::front) return {Sides::front, "front sides: as asked"};
  if (policy == SidesPolicy::both) return {Sides::both, "both sides: as asked"};
  if (const Objection reason = objection(mesh, contacts, camera)) return {Sides::both, "both sides: " + *reason};
  return {Sides::front, "front sides: every surface is closed, faces outwards and has the eye outside"};
}

}  // namespace sightline::inline geometry
