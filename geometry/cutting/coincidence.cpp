#include "geometry/cutting/coincidence.h"

#include <algorithm>
#include <cmath>

#include "geometry/faces/fitted_plane.h"
#include "geometry/mesh/box_hierarchy.h"
#include "geometry/mesh/facet_plane.h"
#include "geometry/numbers/predicates.h"

namespace sightline::inline geometry {

namespace {

using Corners = std::vector<Point3>;

// Returns what of a convex polygon is on the inner side of a plane through a point: Sutherland and Hodgman 1974.
Corners clipped(const Corners& polygon, const Point3& from, const Vector3& inwards) {
  Corners result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point3& p = polygon[i];
    const Point3& q = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    const double at_p = inwards.dot(p - from);
    const double at_q = inwards.dot(q - from);
    if (at_p >= 0) result.push_back(p);
    if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) result.emplace_back(p + at_p / (at_p - at_q) * (q - p));
  }
  return result;
}

// Returns what of b is over a, seen across a.
Corners part_over(std::span<const Point3> a, const Vector3& normal, std::span<const Point3> b) {
  Corners part(b.begin(), b.end());
  for (std::size_t i = 0; i < a.size() && !part.empty(); ++i)
    part = clipped(part, a[i], normal.cross(a[i + 1 == a.size() ? 0 : i + 1] - a[i]));
  return part;
}

double length_around(const Corners& polygon) {
  double length = norm(polygon.front() - polygon.back());
  for (std::size_t i = 1; i < polygon.size(); ++i) length += norm(polygon[i] - polygon[i - 1]);
  return length;
}

// A convex polygon of area A and length L around holds a circle of radius A / L.
bool is_wide(double area, double length, double distance) { return area > least_overlap * distance * length; }

// Planes that are nowhere further apart than d in a circle of radius r enclose an angle of d / r at most.
bool may_be_flush(const Vector3& normal, const Vector3& other) {
  return norm(normal.cross(other)) <= 1 / least_overlap;
}

std::optional<Coincidence> coincidence_across(const Vector3& normal, std::span<const Point3> a,
                                              std::span<const Point3> b, double distance) {
  const Corners part = part_over(a, normal, b);
  if (part.size() < 3) return std::nullopt;
  Coincidence result{0, std::fabs(normal.dot(area_vector(part)))};
  if (!is_wide(result.overlap, length_around(part), distance)) return std::nullopt;
  for (const Point3& p : part) result.distance = std::max(result.distance, std::fabs(normal.dot(p - a[0])));
  return result.distance <= distance ? std::optional(result) : std::nullopt;
}

Corners corners_of(const PolygonMesh& mesh, std::size_t facet) {
  Corners result;
  for (const VertexId v : mesh.corners(FacetId(facet))) result.push_back(mesh.position(v));
  return result;
}

Box box_of(const Corners& polygon) {
  Box box{polygon[0], polygon[0]};
  for (const Point3& p : polygon) box = hull(box, {p, p});
  return box;
}

class Finder {
 public:
  Finder(const PolygonMesh& mesh, double distance) : mesh_(mesh), distance_(distance) {
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) normals_.push_back(unit(area_vector(corners(f))));
  }

  void run() {
    std::vector<Box> boxes;
    for (std::size_t f = 0; f < mesh_.facet_count(); ++f) boxes.push_back(widened_box(f));
    for_each_overlapping_pair(build_hierarchy(boxes), [&](std::uint32_t f, std::uint32_t g) { add(f, g); });
  }

  std::vector<FacetCoincidence> found;

 private:
  [[nodiscard]] Corners corners(std::size_t f) const { return corners_of(mesh_, f); }

  [[nodiscard]] Box widened_box(std::size_t f) const {
    const Box box = box_of(corners(f));
    return {box.low.array() - distance_ / 2, box.high.array() + distance_ / 2};
  }

  void add(std::uint32_t f, std::uint32_t g) {
    if (mesh_.facet_face[f] == mesh_.facet_face[g] || !may_be_flush(normals_[f], normals_[g])) return;
    auto pair = coincidence_across(normals_[f], corners(f), corners(g), distance_);
    if (!pair) return;
    if (are_in_one_plane(f, g)) pair->distance = 0;
    found.push_back({*pair, FacetId(f), FacetId(g)});
  }

  // Exactly.
  [[nodiscard]] bool are_in_one_plane(std::uint32_t f, std::uint32_t g) const {
    const auto [a, b, c] = plane_corners(mesh_, mesh_.corners(FacetId(f)));
    return std::ranges::all_of(mesh_.corners(FacetId(g)), [&, a = a, b = b, c = c](VertexId v) {
      return orient3d(mesh_.position(a), mesh_.position(b), mesh_.position(c), mesh_.position(v)) == 0;
    });
  }

  const PolygonMesh& mesh_;
  double distance_;
  std::vector<Vector3> normals_;
};

bool have_same_corners(const PolygonMesh& mesh, FacetId f, FacetId g) {
  const auto of_f = mesh.corners(f);
  const auto of_g = mesh.corners(g);
  const auto is_of_g = [&](VertexId v) {
    return std::ranges::any_of(of_g, [&](VertexId w) { return mesh.weld[v.index()] == mesh.weld[w.index()]; });
  };
  return of_f.size() == of_g.size() && std::ranges::all_of(of_f, is_of_g);
}

FaceCoincidence of_faces(const CutMesh& mesh, const FacetCoincidence& pair) {
  const bool is_snapped = !mesh.snapped_to.empty() &&
                          mesh.plane_of(mesh.uncut_facet(pair.first)) == mesh.plane_of(mesh.uncut_facet(pair.second));
  return {pair, mesh.facet_face[pair.first.index()], mesh.facet_face[pair.second.index()], is_snapped};
}

// Returns a pair of faces once, however many of their facets meet.
std::vector<FaceCoincidence> joined(std::vector<FaceCoincidence> pairs) {
  const auto ids = [](const FaceCoincidence& pair) { return std::pair(pair.first, pair.second); };
  std::ranges::stable_sort(pairs, {}, ids);
  std::vector<FaceCoincidence> result;
  for (const FaceCoincidence& pair : pairs) {
    if (result.empty() || ids(result.back()) != ids(pair)) {
      result.push_back(pair);
      continue;
    }
    result.back().distance = std::max(result.back().distance, pair.distance);
    result.back().overlap += pair.overlap;
    result.back().is_snapped = result.back().is_snapped && pair.is_snapped;
  }
  return result;
}

}  // namespace

std::optional<Coincidence> coincidence_of(std::span<const Point3> a, std::span<const Point3> b, double distance) {
  const Vector3 normal = unit(area_vector(a));
  if (!may_be_flush(normal, unit(area_vector(b)))) return std::nullopt;
  return coincidence_across(normal, a, b, distance);
}

// The order in which pairs are found is that of the boxes' hierarchy, so the sums do not depend on anything else.
std::vector<FaceCoincidence> find_coincidences(const CutMesh& mesh, double distance) {
  std::vector<FaceCoincidence> pairs;
  for (const FacetCoincidence& pair : coincident_facets(mesh, distance)) {
    if (!have_same_corners(mesh, pair.first, pair.second)) pairs.push_back(of_faces(mesh, pair));
  }
  return joined(std::move(pairs));
}

std::vector<FacetCoincidence> coincident_facets(const PolygonMesh& mesh, double distance) {
  Finder finder(mesh, distance);
  finder.run();
  return std::move(finder.found);
}

namespace {

double distance_from_edge(const Point3& p, const Point3& a, const Point3& b) {
  const Vector3 along = b - a;
  const double share = std::clamp(along.dot(p - a) / along.dot(along), 0.0, 1.0);
  return norm(p - a - share * along);
}

// The polygon is convex; a place over it is as far from it as from its plane, another one as from its nearest edge.
double distance_from_polygon(const Point3& p, const Corners& polygon) {
  const Vector3 normal = unit(area_vector(polygon));
  bool is_over = true;
  double from_border = norm(p - polygon[0]);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point3& next = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    is_over = is_over && normal.cross(next - polygon[i]).dot(p - polygon[i]) >= 0;
    from_border = std::min(from_border, distance_from_edge(p, polygon[i], next));
  }
  return is_over ? std::fabs(normal.dot(p - polygon[0])) : from_border;
}

}  // namespace

std::vector<FaceId> faces_at(const PolygonMesh& mesh, const Point3& point, double distance) {
  std::vector<FaceId> faces;
  const Box around{point.array() - distance, point.array() + distance};
  for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
    const FaceId face = mesh.facet_face[f];
    if (!faces.empty() && faces.back() == face) continue;
    const Corners polygon = corners_of(mesh, f);
    if (overlap(around, box_of(polygon)) && distance_from_polygon(point, polygon) <= distance) faces.push_back(face);
  }
  return faces;
}

double size_of(const PolygonMesh& mesh) {
  if (mesh.facets.corners.empty()) return 0;
  const Point3& any = mesh.position(mesh.facets.corners.front());
  Box box{any, any};
  for (const VertexId v : mesh.facets.corners) box = hull(box, {mesh.position(v), mesh.position(v)});
  return norm(box.high - box.low);
}

}  // namespace sightline::inline geometry
