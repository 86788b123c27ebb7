#include "geometry/cutting/common_lines.h"

#include <algorithm>
#include <bit>

#include "geometry/cutting/facet_cutter.h"
#include "geometry/cutting/mesh_of_pieces.h"
#include "geometry/mesh/facet_plane.h"
#include "geometry/numbers/mix.h"

namespace sightline::inline geometry {
namespace {

// Facets with the same corners have the same number, however they are numbered and wherever they begin: cutters come in
// an order that is as good as random, and that shuffling faces does not change.
std::uint64_t fingerprint(const Mesh& mesh, FacetId facet) {
  std::uint64_t sum = 0;
  for (const VertexId v : mesh.corners(facet)) {
    const Point3& p = mesh.position(v);
    std::uint64_t number = 0;
    for (const double coordinate : {p.x(), p.y(), p.z()})
      number = mix(number ^ std::bit_cast<std::uint64_t>(coordinate + 0.0));
    sum += number;
  }
  return sum;
}

// A facet that crosses others is kept with its plane and with those that cut it.
struct CrossedFacet {
  FacetId facet;
  ExactPlane plane;
  CutPolygon polygon;
  std::uint64_t fingerprint = 0;
  std::vector<std::pair<std::uint64_t, Cutter>> cutters;
};

std::vector<CrossedFacet> crossed_facets(const Mesh& mesh, const MeshContacts& contacts) {
  std::vector<FacetId> ids;
  for (const auto& [f, g] : contacts.crossing) ids.insert(ids.end(), {f, g});
  std::ranges::sort(ids);
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  std::vector<CrossedFacet> facets;
  for (const FacetId f : ids) {
    const auto [a, b, c] = plane_corners(mesh, mesh.corners(f));
    facets.push_back({f,
                      plane_through(exact_position(mesh.position(a)), exact_position(mesh.position(b)),
                                    exact_position(mesh.position(c))),
                      facet_polygon(mesh, f),
                      fingerprint(mesh, f),
                      {}});
  }
  return facets;
}

// This holds the pieces of all facets that cross others; chords_ and facets_ stay where they are, since cutters point
// at them.
class CrossedFacets {
 public:
  CrossedFacets(const Mesh& mesh, const MeshContacts& contacts) : facets_(crossed_facets(mesh, contacts)) {
    chords_.reserve(contacts.crossing.size());
    for (const auto& [f, g] : contacts.crossing) add_crossing(find(f), find(g));
    for (CrossedFacet& facet : facets_) {
      std::ranges::stable_sort(facet.cutters, {}, [](const auto& entry) { return entry.first; });
    }
  }

  [[nodiscard]] std::size_t size() const { return facets_.size(); }
  [[nodiscard]] FacetId facet(std::size_t i) const { return facets_[i].facet; }

  [[nodiscard]] std::vector<CutPolygon> pieces(std::size_t i) const {
    std::vector<Cutter> cutters;
    for (const auto& [order, cutter] : facets_[i].cutters) cutters.push_back(cutter);
    return cut_facet(facets_[i].polygon, cutters);
  }

 private:
  CrossedFacet& find(FacetId f) { return *std::ranges::lower_bound(facets_, f, {}, &CrossedFacet::facet); }

  void add_crossing(CrossedFacet& f, CrossedFacet& g) {
    chords_.push_back(common_part(meet(f.polygon, g.plane), meet(g.polygon, f.plane)));
    f.cutters.push_back({g.fingerprint, {&g.plane, &chords_.back()}});
    g.cutters.push_back({f.fingerprint, {&f.plane, &chords_.back()}});
  }

  std::vector<CrossedFacet> facets_;
  std::vector<Chord> chords_;
};

}  // namespace

CutMesh cut_along_common_lines(Mesh mesh, const MeshContacts& contacts) {
  if (contacts.crossing.empty()) return uncrossed(std::move(mesh));
  std::vector<std::vector<CutPolygon>> pieces(mesh.facet_count());
  const CrossedFacets crossed(mesh, contacts);
  for (std::size_t i = 0; i < crossed.size(); ++i) pieces[crossed.facet(i).index()] = crossed.pieces(i);
  CutMesh cut = mesh_of_pieces(mesh, pieces);
  for (const auto& [f, g] : contacts.crossing)
    cut.cuts.crossing.push_back({UncutFacetId(f.index()), UncutFacetId(g.index())});
  return cut;
}

Mesh without_cuts(const CutMesh& mesh) {
  const auto end = mesh.vertices.begin() + static_cast<std::ptrdiff_t>(mesh.input_vertex_count());
  return build_mesh({mesh.vertices.begin(), end}, mesh.faces);
}

}  // namespace sightline::inline geometry
