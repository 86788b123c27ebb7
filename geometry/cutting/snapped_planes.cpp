#include "geometry/cutting/snapped_planes.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "geometry/cutting/coincidence.h"
#include "geometry/mesh/facet_plane.h"

namespace sightline::inline geometry {
namespace {

// What hangs together is a set of facets; a facet in it is named by one of them, found by going up.
class Sets {
 public:
  explicit Sets(std::size_t size) : above_(size) { std::iota(above_.begin(), above_.end(), 0U); }

  [[nodiscard]] std::uint32_t of(std::uint32_t item) {
    while (above_[item] != item) item = above_[item] = above_[above_[item]];
    return item;
  }
  void unite(FacetId a, FacetId b) {
    const std::uint32_t of_a = of(a.value);
    const std::uint32_t of_b = of(b.value);
    above_[std::max(of_a, of_b)] = std::min(of_a, of_b);
  }

 private:
  std::vector<std::uint32_t> above_;
};

double area_of(const CutMesh& mesh, FacetId surface) {
  double area = 0;
  for (FacetId f = surface; f < end_of_surface(mesh, surface); f = FacetId(f.index() + 1)) {
    std::vector<Point3> corners;
    for (const VertexId v : mesh.corners(f)) corners.push_back(mesh.position(v));
    area += norm(area_vector(corners));
  }
  return area;
}

bool lies_near_plane(const CutMesh& mesh, FacetId surface, FacetId of_plane, double distance) {
  const auto [a, b, c] = plane_corners(mesh, of_plane);
  const Point3& from = mesh.position(a);
  const Vector3 normal = unit(Vector3((mesh.position(b) - from).cross(mesh.position(c) - from)));
  for (FacetId f = surface; f < end_of_surface(mesh, surface); f = FacetId(f.index() + 1)) {
    const auto is_near = [&](VertexId v) { return std::fabs(normal.dot(mesh.position(v) - from)) <= distance; };
    if (!std::ranges::all_of(mesh.corners(f), is_near)) return false;
  }
  return true;
}

class Snapping {
 public:
  Snapping(const CutMesh& mesh, double distance) : mesh_(mesh), distance_(distance), sets_(mesh.facet_count()) {}

  std::vector<UncutFacetId> run() {
    for (const FacetCoincidence& pair : coincident_facets(mesh_, distance_)) add(pair);
    for (auto& [name, surfaces] : surfaces_by_set()) snap(std::move(surfaces));
    return std::move(snapped_to_);
  }

 private:
  // Those that are in one plane, exactly, need no other; but they stay together where one of them does.
  void add(const FacetCoincidence& pair) {
    sets_.unite(pair.first, pair.second);
    add_face_of(pair.first);
    add_face_of(pair.second);
    if (pair.distance > 0) apart_.push_back(pair.first);
  }

  // A face that is warped by rounding only has one plane by design.
  void add_face_of(FacetId facet) {
    const FaceId face = mesh_.facet_face[facet.index()];
    for (std::size_t f = mesh_.first_facet(face); f < mesh_.end_facet(face); ++f) {
      sets_.unite(facet, FacetId(f));
      members_.push_back(surface_of(mesh_, FacetId(f)));
    }
  }

  [[nodiscard]] std::map<std::uint32_t, std::vector<FacetId>> surfaces_by_set() {
    std::map<std::uint32_t, std::vector<FacetId>> by_set;
    for (const FacetId facet : apart_) by_set.try_emplace(sets_.of(facet.value));
    std::ranges::sort(members_);
    members_.erase(std::unique(members_.begin(), members_.end()), members_.end());
    for (const FacetId surface : members_) {
      const auto set = by_set.find(sets_.of(surface.value));
      if (set != by_set.end()) set->second.push_back(surface);
    }
    return by_set;
  }

  // The largest surface that is left lends its plane to all that are near to it.
  void snap(std::vector<FacetId> surfaces) {
    std::ranges::stable_sort(surfaces, std::greater{}, [&](FacetId surface) { return area_of(mesh_, surface); });
    while (surfaces.size() > 1) {
      const FacetId largest = surfaces.front();
      const auto rest = std::stable_partition(surfaces.begin(), surfaces.end(), [&](FacetId surface) {
        return surface == largest || lies_near_plane(mesh_, surface, largest, distance_);
      });
      for (auto surface = surfaces.begin(); surface != rest; ++surface) snap(*surface, largest);
      surfaces.erase(surfaces.begin(), rest);
    }
  }

  void snap(FacetId surface, FacetId to) {
    if (surface == to) return;
    if (snapped_to_.empty()) {
      for (std::size_t f = 0; f < mesh_.facet_count(); ++f) snapped_to_.emplace_back(f);
    }
    for (std::size_t f = surface.index(); f < end_of_surface(mesh_, surface).index(); ++f)
      snapped_to_[f] = UncutFacetId(to.index());
  }

  const CutMesh& mesh_;
  double distance_;
  Sets sets_;
  std::vector<FacetId> members_;  // surfaces
  std::vector<FacetId> apart_;    // facets that are on another one, and not in one plane with it
  std::vector<UncutFacetId> snapped_to_;
};

}  // namespace

std::vector<UncutFacetId> snapped_planes(const CutMesh& mesh, double distance) {
  return Snapping(mesh, distance).run();
}

}  // namespace sightline::inline geometry
