#include "reconstruct/labelling/conformity.h"

#include <algorithm>
#include <span>
#include <utility>

namespace sightline::inline reconstruct {
namespace {

// A link is a directed edge between welded vertices, with how often it is there; in a canonical chain from < to, and
// the opposite direction counts < 0.
struct Link {
  VertexId from;
  VertexId to;
  int count = 0;
};
using Chain = std::vector<Link>;

void add(Chain& chain, VertexId from, VertexId to, int count) {
  if (from < to) chain.push_back({from, to, count});
  if (to < from) chain.push_back({to, from, -count});
}

std::pair<VertexId, VertexId> ends(const Link& link) { return {link.from, link.to}; }

// Returns the chain with equal links added up and those with count 0 left out, sorted.
Chain canonical(Chain chain) {
  std::ranges::sort(chain, {}, ends);
  Chain result;
  for (std::size_t begin = 0; begin < chain.size();) {
    Link sum = chain[begin];
    std::size_t next = begin + 1;
    for (; next < chain.size() && ends(chain[next]) == ends(sum); ++next) sum.count += chain[next].count;
    if (sum.count != 0) result.push_back(sum);
    begin = next;
  }
  return result;
}

// Returns both directions as links with a positive count, sorted by where they start.
Chain outgoing(const Chain& border) {
  Chain result;
  for (const Link& link : border) {
    if (link.count > 0) result.push_back(link);
    if (link.count < 0) result.push_back({link.to, link.from, -link.count});
  }
  std::ranges::sort(result, {}, ends);
  return result;
}

// Returns the links that start at v, of links sorted by where they start.
std::span<const Link> leaving_from(const Chain& links, VertexId v) {
  const auto first = std::ranges::lower_bound(links, v, {}, &Link::from);
  const auto last = std::ranges::upper_bound(links, v, {}, &Link::from);
  return {first, last};
}

// Vertices of the input at one position are one; each vertex that is new is its own, wherever rounding has put it.
std::vector<VertexId> weld(const LabelledMesh& labelled, const PolygonMesh& mesh) {
  std::vector<VertexId> welded = mesh.weld;
  for (std::size_t v = welded.size(); v < labelled.vertices.size(); ++v) welded.emplace_back(v);
  return welded;
}

class Conformity {
 public:
  Conformity(const LabelledMesh& labelled, const PolygonMesh& mesh, std::vector<std::string>& messages)
      : labelled_(labelled),
        mesh_(mesh),
        messages_(messages),
        weld_(weld(labelled, mesh)),
        segments_(mesh.edges.size()) {}

  void run() {
    find_borders();
    for (std::size_t f = 0; f < mesh_.face_count(); ++f) find_segments(FaceId(f));
    for (std::size_t f = 0; f < mesh_.face_count(); ++f) compare(FaceId(f));
  }

 private:
  void find_borders() {
    borders_.resize(mesh_.face_count());
    first_triangle_.assign(mesh_.face_count() + 1, 0);
    for (const LabelledTriangle& t : labelled_.triangles) ++first_triangle_[t.face.index() + 1];
    for (std::size_t f = 0; f < mesh_.face_count(); ++f) {
      first_triangle_[f + 1] += first_triangle_[f];
      borders_[f] = canonical(sides(FaceId(f)));
    }
  }

  // Returns the sides of the triangles of a face, each in the direction of its triangle or as a count of -1.
  [[nodiscard]] Chain sides(FaceId face) const {
    Chain chain;
    for (std::size_t t = first_triangle_[face.index()]; t < first_triangle_[face.index() + 1]; ++t) {
      const auto& corners = labelled_.triangles[t].corners;
      for (std::size_t i = 0; i < 3; ++i) add(chain, weld_[corners[i].index()], weld_[corners[(i + 1) % 3].index()], 1);
    }
    return chain;
  }

  // These are the mesh edges around a face: those between its own facets cancel.
  struct BorderEdge {
    MeshEdgeId edge;
    int count = 0;  // positive: in the direction of the mesh edge's ends
  };
  [[nodiscard]] std::vector<BorderEdge> border_edges(FaceId face) const {
    std::vector<std::pair<MeshEdgeId, int>> uses;
    for (std::size_t f = mesh_.first_facet(face); f < mesh_.end_facet(face); ++f) {
      const auto corners = mesh_.corners(FacetId(f));
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const MeshEdgeId e = mesh_.edges_of(FacetId(f))[i];
        uses.emplace_back(e, mesh_.weld[corners[i].index()] == mesh_.edges[e.index()][0] ? 1 : -1);
      }
    }
    std::ranges::sort(uses);
    std::vector<BorderEdge> result;
    for (const auto& [edge, direction] : uses) {
      if (result.empty() || result.back().edge != edge) result.push_back({edge, 0});
      result.back().count += direction;
    }
    std::erase_if(result, [](const BorderEdge& b) { return b.count == 0; });
    return result;
  }

  // Where a border runs back along itself the links of a mesh edge may have cancelled; then all sides of the triangles
  // are looked at.
  void find_segments(FaceId face) {
    for (const bool of_border : {true, false}) {
      std::vector<BorderEdge> edges = border_edges(face);
      std::erase_if(edges, [this](const BorderEdge& b) { return !segments_[b.edge.index()].empty(); });
      if (edges.empty()) return;
      const Chain links = outgoing(of_border ? borders_[face.index()] : sides(face));
      for (const BorderEdge& b : edges) find_segments(b, links);
    }
  }

  void find_segments(const BorderEdge& b, const Chain& links) {
    const auto& [first, second] = mesh_.edges[b.edge.index()];
    auto& segments = segments_[b.edge.index()];
    segments = b.count > 0 ? path(links, weld_[first.index()], weld_[second.index()])
                           : path(links, weld_[second.index()], weld_[first.index()]);
    if (b.count < 0) std::ranges::reverse(segments);
  }

  // Returns the vertices of a path along the links, both ends included; it is empty where none leads there.
  [[nodiscard]] std::vector<VertexId> path(const Chain& links, VertexId from, VertexId to) const {
    std::vector<VertexId> vertices{from};
    while (vertices.back() != to) {
      const std::span<const Link> leaving = leaving_from(links, vertices.back());
      if (leaving.empty() || vertices.size() > links.size()) return {};
      vertices.push_back(leaving.size() == 1 ? leaving.front().to : straightest(leaving, vertices.back(), to));
    }
    return vertices;
  }

  // A detour says where p lies beside the straight way from a to b: how far along (0 to 1), and how far off.
  struct Detour {
    double along = 0;
    double off = 0;
  };
  // The way may be so short that other ways are longer by more than doubles say.
  [[nodiscard]] static Detour detour(const Point3& a, const Point3& b, const Point3& p) {
    constexpr double longest = 0x1p500;
    const double length = (b - a).cwiseAbs().maxCoeff();
    const Vector3 way = (b - a) / length;
    const Vector3 to_p = ((p - a) / length).cwiseMax(-longest).cwiseMin(longest);
    const double along = std::clamp(to_p.dot(way) / way.squaredNorm(), 0.0, 1.0);
    return {along, norm(p - (a + along * (b - a)))};
  }

  // Returns the end of the link that makes way and leads least away from the straight way.
  [[nodiscard]] VertexId straightest(std::span<const Link> leaving, VertexId from, VertexId to) const {
    const auto& vertices = labelled_.vertices;
    const auto key = [&](const Link& link) {
      const Detour d = detour(vertices[from.index()], vertices[to.index()], vertices[link.to.index()]);
      return std::pair(d.along > 0 ? 0 : 1, d.off);
    };
    return std::ranges::min_element(leaving, {}, key)->to;
  }

  void compare(FaceId face) {
    Chain difference = borders_[face.index()];
    for (const BorderEdge& b : border_edges(face)) {
      const std::vector<VertexId>& segments = segments_[b.edge.index()];
      if (segments.empty()) {
        messages_.push_back("face " + std::to_string(face.value) + " has no border along mesh edge " +
                            std::to_string(b.edge.value));
        return;
      }
      for (std::size_t i = 0; i + 1 < segments.size(); ++i) add(difference, segments[i], segments[i + 1], -b.count);
    }
    for (const Link& link : canonical(std::move(difference))) {
      messages_.push_back("face " + std::to_string(face.value) +
                          " does not conform with its neighbours between vertices " + std::to_string(link.from.value) +
                          " and " + std::to_string(link.to.value));
    }
  }

  const LabelledMesh& labelled_;
  const PolygonMesh& mesh_;
  std::vector<std::string>& messages_;
  std::vector<VertexId> weld_;
  std::vector<std::size_t> first_triangle_;  // per face and one more
  std::vector<Chain> borders_;               // per face, canonical
  std::vector<std::vector<VertexId>>
      segments_;  // per mesh edge, from its first end to its second; empty: not found yet
};

}  // namespace

void check_conformity(const LabelledMesh& labelled, const PolygonMesh& mesh, std::vector<std::string>& messages) {
  Conformity(labelled, mesh, messages).run();
}

}  // namespace sightline::inline reconstruct
