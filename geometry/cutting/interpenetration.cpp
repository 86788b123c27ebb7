#include "geometry/cutting/interpenetration.h"

#include <algorithm>

#include "geometry/cutting/facet_contact.h"
#include "geometry/mesh/box_hierarchy.h"

namespace sightline::inline geometry {
namespace {

// This has the facets with their corners welded.
class WeldedFacets {
 public:
  explicit WeldedFacets(const PolygonMesh& mesh) : mesh_(mesh), corners_(mesh.facets.corners) {
    for (VertexId& corner : corners_) corner = mesh.weld[corner.index()];
  }

  [[nodiscard]] ConvexFacet operator[](FacetId f) const {
    const std::size_t first = mesh_.facets.begin[f.index()];
    return {mesh_, f, std::span(corners_).subspan(first, mesh_.facets.begin[f.index() + 1] - first)};
  }

 private:
  const PolygonMesh& mesh_;
  std::vector<VertexId> corners_;
};

Box box_of(const PolygonMesh& mesh, FacetId f) {
  const Point3& first = mesh.position(mesh.corners(f).front());
  Box box{first, first};
  for (const VertexId corner : mesh.corners(f)) box = hull(box, {mesh.position(corner), mesh.position(corner)});
  return box;
}

std::vector<Box> facet_boxes(const PolygonMesh& mesh) {
  std::vector<Box> boxes;
  boxes.reserve(mesh.facet_count());
  for (std::size_t f = 0; f < mesh.facet_count(); ++f) boxes.push_back(box_of(mesh, FacetId(f)));
  return boxes;
}

}  // namespace

MeshContacts find_contacts(const PolygonMesh& mesh) {
  const WeldedFacets facets(mesh);
  MeshContacts contacts;
  for_each_overlapping_pair(build_hierarchy(facet_boxes(mesh)), [&](std::uint32_t i, std::uint32_t j) {
    const std::array pair{FacetId(i), FacetId(j)};
    const Contact contact = contact_of(facets[pair[0]], facets[pair[1]]);
    if (contact == Contact::crossing) contacts.crossing.push_back(pair);
    if (contact == Contact::touching) contacts.touching.push_back(pair);
  });
  std::sort(contacts.crossing.begin(), contacts.crossing.end());
  std::sort(contacts.touching.begin(), contacts.touching.end());
  return contacts;
}

}  // namespace sightline::inline geometry
