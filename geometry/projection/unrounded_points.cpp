#include "geometry/projection/unrounded_points.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <unordered_map>

#include "geometry/projection/certain_height.h"

namespace sightline::inline geometry {
namespace {

class PointNumbering {
 public:
  PointNumbering(ProjectedScene& scene, const std::vector<CertifiedPlace>& of_vertices)
      : scene_(scene), of_vertices_(of_vertices), corners_(scene.camera) {}

  void run() {
    find_places_of_vertices();
    find_places_of_made_corners();
    number_points();
  }

 private:
  // A place before points are numbered, with whose it is.
  struct Found {
    CertifiedPlace certified;
    UnroundedPoints::Source source;
  };

  [[nodiscard]] VertexId welded(VertexId v) const { return scene_.mesh().weld[v.index()]; }

  // Vertices at one position have one place.
  void find_places_of_vertices() {
    std::vector<VertexId> in_view(scene_.mesh().vertices.size());
    for (const ClippedCorner& corner : scene_.polygon_corners) {
      if (corner.vertex.valid()) in_view[welded(corner.vertex).index()] = corner.vertex;
    }
    found_.reserve(scene_.made_corners.size() +
                   static_cast<std::size_t>(std::ranges::count_if(in_view, &VertexId::valid)));
    for (const VertexId v : in_view) {
      if (v.valid()) found_.push_back({of_vertices_[v.index()], {v, {}}});
    }
  }

  void find_places_of_made_corners() {
    std::vector<ExactPlace> made(scene_.made_corners.size());
    for (std::size_t f = 0; f < scene_.status.size(); ++f) {
      const auto polygon = scene_.polygon(FacetId(f));
      const auto is_made = [](const ClippedCorner& corner) { return corner.made.valid(); };
      if (std::ranges::none_of(polygon, is_made)) continue;
      const std::vector<ExactCorner> clipped = clip(scene_.mesh(), scene_.camera, FacetId(f));
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        if (!is_made(polygon[i])) continue;
        ExactPlace& place = made[polygon[i].made.index()];
        place = place_of(clipped[i]);
        found_.push_back({certified(place), {{}, polygon[i].made}});
      }
    }
    scene_.unrounded.made = std::make_shared<const std::vector<ExactPlace>>(std::move(made));
  }

  [[nodiscard]] int compare(const Found& a, const Found& b) {
    if (const int by_height = compare_heights(height_of(a.certified), height_of(b.certified)); by_height != 0)
      return by_height;
    if (a.source == b.source) return 0;
    const std::lock_guard lock(lock_);
    return sweep_compare(exact(a.source), exact(b.source));
  }

  // Precondition: the lock is held. What was worked out once is kept.
  const ExactPlace& exact(const UnroundedPoints::Source& source) {
    if (!source.vertex.valid()) return (*scene_.unrounded.made)[source.made.index()];
    const auto [known, is_new] = exact_.try_emplace(source.vertex.value);
    if (is_new) known->second = place_of(corners_.of(scene_.mesh(), source.vertex));
    return known->second;
  }

  void number_points() {
    tbb::parallel_sort(found_.begin(), found_.end(),
                       [this](const Found& a, const Found& b) { return compare(a, b) < 0; });
    scene_.points.reserve(found_.size());
    scene_.unrounded.places.reserve(found_.size());
    scene_.unrounded.sources.reserve(found_.size());
    std::vector<PointId> of_vertex(scene_.mesh().vertices.size());
    std::vector<PointId> of_made(scene_.made_corners.size());
    for (std::size_t i = 0; i < found_.size(); ++i) {
      if (i == 0 || compare(found_[i - 1], found_[i]) != 0) add_point(found_[i]);
      const auto& [vertex, made] = found_[i].source;
      (vertex.valid() ? of_vertex[welded(vertex).index()] : of_made[made.index()]) = PointId(scene_.points.size() - 1);
    }
    for (ClippedCorner& corner : scene_.polygon_corners)
      corner.point = corner.vertex.valid() ? of_vertex[welded(corner.vertex).index()] : of_made[corner.made.index()];
  }

  void add_point(const Found& found) {
    scene_.points.push_back(near_grid_point(found.certified, scene_.grid_bits));
    scene_.unrounded.places.push_back(found.certified);
    scene_.unrounded.sources.push_back(found.source);
  }

  ProjectedScene& scene_;
  const std::vector<CertifiedPlace>& of_vertices_;
  std::vector<Found> found_;
  std::mutex lock_;
  ExactCorners corners_;
  std::unordered_map<std::uint32_t, ExactPlace> exact_;  // only looked up
};

}  // namespace

void number_unrounded_points(ProjectedScene& scene, const std::vector<CertifiedPlace>& of_vertices) {
  PointNumbering(scene, of_vertices).run();
}

ExactPlace exact_place(const ProjectedScene& scene, PointId p) {
  ExactCorners corners(scene.camera);
  return exact_place(scene, p, corners);
}

ExactPlace exact_place(const ProjectedScene& scene, PointId p, ExactCorners& corners) {
  if (!scene.is_unrounded()) {
    const ImagePoint& point = scene.point(p);
    return {point.x, point.y, BigInteger(1) << static_cast<unsigned>(scene.grid_bits)};
  }
  const UnroundedPoints::Source& source = scene.unrounded.sources[p.index()];
  if (!source.vertex.valid()) return (*scene.unrounded.made)[source.made.index()];
  return place_of(corners.of(scene.mesh(), source.vertex));
}

}  // namespace sightline::inline geometry
