#include "geometry/mesh/components.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "geometry/mesh/box_hierarchy.h"
#include "geometry/mesh/convex_facet.h"
#include "geometry/numbers/bounded.h"

namespace sightline::inline geometry {
namespace {

// Disjoint sets of facets are each named by their smallest one (Tarjan 1975, with path halving).
class DisjointFacets {
 public:
  explicit DisjointFacets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }

  std::uint32_t find(std::uint32_t f) {
    while (parent_[f] != f) f = parent_[f] = parent_[parent_[f]];
    return f;
  }

  void unite(std::uint32_t f, std::uint32_t g) {
    const auto [first, last] = std::minmax({find(f), find(g)});
    parent_[last] = first;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

DisjointFacets connect_by_edges(const PolygonMesh& mesh) {
  DisjointFacets sets(mesh.facet_count());
  std::vector<FacetId> first_of_edge(mesh.edges.size());
  for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
    for (const MeshEdgeId e : mesh.edges_of(FacetId(f))) {
      FacetId& first = first_of_edge[e.index()];
      if (!first.valid()) first = FacetId(f);
      sets.unite(first.value, FacetId(f).value);
    }
  }
  return sets;
}

// Calls visit(a, b, c) with the triangles of a fan over each facet.
template <class Visit>
void for_each_triangle(const PolygonMesh& mesh, std::span<const FacetId> component, Visit visit) {
  for (const FacetId f : component) {
    const auto corners = mesh.corners(f);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      visit(mesh.position(corners[0]), mesh.position(corners[i]), mesh.position(corners[i + 1]));
    }
  }
}

int lowest_exponent(const PolygonMesh& mesh, std::span<const FacetId> component) {
  std::vector<double> coordinates;
  for_each_triangle(mesh, component, [&](const Point3& a, const Point3& b, const Point3& c) {
    coordinates.insert(coordinates.end(), {a.x(), a.y(), a.z(), b.x(), b.y(), b.z(), c.x(), c.y(), c.z()});
  });
  return exponent_range(coordinates).lowest;
}

Sign exact_volume_sign(const PolygonMesh& mesh, std::span<const FacetId> component) {
  const int lowest = lowest_exponent(mesh, component);
  const auto integers = [lowest](const Point3& p) {
    return scaled<BigInteger>(std::array{p.x(), p.y(), p.z()}, lowest);
  };
  BigInteger sum = 0;
  for_each_triangle(mesh, component, [&](const Point3& p, const Point3& q, const Point3& r) {
    const auto a = integers(p);
    const auto b = integers(q);
    const auto c = integers(r);
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  });
  return sign_of(sum);
}

ConvexFacet facet_of(const PolygonMesh& mesh, FacetId f) { return {mesh, f, mesh.corners(f)}; }

bool lies_on(const Point3& p, const ConvexFacet& facet) {
  const FacetPlane plane = plane_of(facet);
  return side_of(plane, p) == 0 && place_of_point(facet, projection_axis(plane), p) != Place::outside;
}

bool box_contains(const Point3& p, const PolygonMesh& mesh, std::span<const FacetId> component) {
  const Point3& first = mesh.position(mesh.corners(component.front()).front());
  Box box{first, first};
  for_each_triangle(mesh, component, [&](const Point3& a, const Point3& b, const Point3& c) {
    box = hull(hull(box, {a, a}), hull({b, b}, {c, c}));
  });
  return contains(box, p);
}

// Returns whether the ray from p, which is not on the facet, crosses it; nullopt where the ray runs in its plane or
// meets its boundary.
std::optional<bool> crosses(const Point3& p, const Vector3& direction, const ConvexFacet& facet) {
  const FacetPlane plane = plane_of(facet);
  const Sign from = side_of(plane, p);
  const Sign to = orient3d(plane.a, plane.b, plane.c, HomogeneousPoint{direction, 0});
  if (from == 0 && to == 0) return std::nullopt;
  if (from * to >= 0) return false;
  const Place place = place_of_line(facet, p, {direction, 0});
  if (place == Place::boundary) return std::nullopt;
  return place == Place::inside;
}

// Returns whether the ray crosses the component an odd number of times; nullopt where it meets an edge.
std::optional<bool> crosses_oddly(const Point3& p, const Vector3& direction, const PolygonMesh& mesh,
                                  std::span<const FacetId> component) {
  bool odd = false;
  for (const FacetId f : component) {
    const auto crossing = crosses(p, direction, facet_of(mesh, f));
    if (!crossing) return std::nullopt;
    odd ^= *crossing;
  }
  return odd;
}

}  // namespace

std::vector<Component> components(const PolygonMesh& mesh) {
  DisjointFacets sets = connect_by_edges(mesh);
  std::vector<Component> result;
  std::vector<std::size_t> component_of(mesh.facet_count());
  for (std::uint32_t f = 0; f < mesh.facet_count(); ++f) {
    const std::uint32_t first = sets.find(f);
    component_of[f] = first == f ? result.size() : component_of[first];
    if (first == f) result.emplace_back();
    result[component_of[f]].push_back(FacetId(f));
  }
  return result;
}

// Six times the volume is the sum of det(a - o, b - o, c - o) over the triangles, which is the same for every origin o
// where the component is closed.
Sign volume_sign(const PolygonMesh& mesh, std::span<const FacetId> component) {
  const Point3& origin = mesh.position(mesh.corners(component.front()).front());
  Bounded estimate;
  for_each_triangle(mesh, component, [&](const Point3& a, const Point3& b, const Point3& c) {
    const BoundedVector u = bounded(a) - bounded(origin);
    const BoundedVector v = bounded(b) - bounded(origin);
    const BoundedVector w = bounded(c) - bounded(origin);
    estimate += u.dot(v.cross(w));
  });
  const auto sign = certain_sign(estimate);
  return sign ? *sign : exact_volume_sign(mesh, component);
}

// Every ray that meets no edge gives the same exact answer, so a ray that meets one is replaced by another. The
// directions (1, k, k^2) have at most two in any plane through the origin; so at most two values of k fail for the
// plane of each facet and for the plane through p and each edge (a facet that has p on the line of an edge has p in its
// plane), and the search ends.
Location location_of(const Point3& p, const PolygonMesh& mesh, std::span<const FacetId> component) {
  if (!box_contains(p, mesh, component)) return Location::outside;
  if (std::any_of(component.begin(), component.end(), [&](FacetId f) { return lies_on(p, facet_of(mesh, f)); })) {
    return Location::on_surface;
  }
  for (double k = 0;; ++k) {
    const auto odd = crosses_oddly(p, {1, k, k * k}, mesh, component);
    if (odd) return *odd ? Location::inside : Location::outside;
  }
}

}  // namespace sightline::inline geometry
