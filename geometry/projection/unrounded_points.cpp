#include "geometry/projection/unrounded_points.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "geometry/numbers/bounded.h"
#include "geometry/projection/camera_forms.h"

namespace sightline::inline geometry {
namespace {

class PointNumbering {
 public:
  explicit PointNumbering(ProjectedScene& scene) : scene_(scene), forms_(scene.camera) {}

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
    std::optional<ExactPlace> exact;  // once somebody asked
  };

  [[nodiscard]] VertexId welded(VertexId v) const { return scene_.mesh().weld[v.index()]; }

  // Vertices at one position have one place.
  void find_places_of_vertices() {
    std::vector<std::uint8_t> in_view(scene_.mesh().vertices.size(), 0);
    for (const ClippedCorner& corner : scene_.polygon_corners) {
      if (corner.vertex.valid()) in_view[welded(corner.vertex).index()] = 1;
    }
    for (std::size_t v = 0; v < in_view.size(); ++v) {
      if (in_view[v] != 0) found_.push_back({certified_place(VertexId(v)), {VertexId(v), {}}, {}});
    }
  }

  [[nodiscard]] CertifiedPlace certified_place(VertexId v) const {
    if (v.index() < scene_.mesh().input_vertex_count()) {
      const CameraPlace<Bounded> place = forms_.at(bounded(scene_.mesh().position(v)));
      const Bounded x = place.x / place.w;
      const Bounded y = place.y / place.w;
      if (x.radius < largest_radius && y.radius < largest_radius)
        return {x.value, y.value, std::max(x.radius, y.radius)};
    }
    return certified(place_of_vertex(v));
  }

  [[nodiscard]] ExactPlace place_of_vertex(VertexId v) const {
    return place_of(exact_corner(scene_.mesh(), v, scene_.camera));
  }

  void find_places_of_made_corners() {
    const ProjectedScene& scene = scene_;
    std::vector<ExactPlace> made(scene.made_corners.size());
    for (std::size_t f = 0; f < scene.status.size(); ++f) {
      const auto polygon = scene.polygon(FacetId(f));
      const auto is_made = [](const ClippedCorner& corner) { return corner.made.valid(); };
      if (std::ranges::none_of(polygon, is_made)) continue;
      const std::vector<ExactCorner> clipped = clip(scene.mesh(), scene.camera, FacetId(f));
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        if (!is_made(polygon[i])) continue;
        const ExactPlace place = place_of(clipped[i]);
        made[polygon[i].made.index()] = place;
        found_.push_back({certified(place), {{}, polygon[i].made}, place});
      }
    }
    scene_.unrounded.made = std::make_shared<const std::vector<ExactPlace>>(std::move(made));
  }

  const ExactPlace& exact(Found& place) const {
    if (!place.exact) place.exact = place_of_vertex(place.source.vertex);
    return *place.exact;
  }

  // Heights further apart than both radii are in that order; the difference rounds once.
  [[nodiscard]] int compare(std::uint32_t a, std::uint32_t b) {
    const CertifiedPlace& p = found_[a].certified;
    const CertifiedPlace& q = found_[b].certified;
    const double apart = q.y - p.y;
    if (std::fabs(apart) > Bounded::widened(p.radius + q.radius + 0x1p-52 * std::fabs(apart)))
      return apart > 0 ? 1 : -1;
    return a == b ? 0 : sweep_compare(exact(found_[a]), exact(found_[b]));
  }

  void number_points() {
    std::vector<std::uint32_t> order(found_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [this](std::uint32_t a, std::uint32_t b) { return compare(a, b) < 0; });
    ProjectedScene& scene = scene_;
    std::vector<PointId> of_vertex(scene.mesh().vertices.size());
    std::vector<PointId> of_made(scene.made_corners.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (i == 0 || compare(order[i - 1], order[i]) != 0) add_point(found_[order[i]]);
      const UnroundedPoints::Source& source = found_[order[i]].source;
      (source.vertex.valid() ? of_vertex[source.vertex.index()] : of_made[source.made.index()]) =
          PointId(scene.points.size() - 1);
    }
    for (ClippedCorner& corner : scene.polygon_corners)
      corner.point = corner.vertex.valid() ? of_vertex[welded(corner.vertex).index()] : of_made[corner.made.index()];
  }

  void add_point(const Found& found) {
    const auto on_grid = [this](double value) { return std::llround(std::ldexp(value, scene_.grid_bits)); };
    scene_.points.push_back({on_grid(found.certified.x), on_grid(found.certified.y)});
    scene_.unrounded.places.push_back(found.certified);
    scene_.unrounded.sources.push_back(found.source);
  }

  ProjectedScene& scene_;
  const CameraForms<Bounded> forms_;
  std::vector<Found> found_;
};

}  // namespace

void number_unrounded_points(ProjectedScene& scene) { PointNumbering(scene).run(); }

ExactPlace exact_place(const ProjectedScene& scene, PointId p) {
  if (!scene.is_unrounded()) {
    const ImagePoint& point = scene.point(p);
    return {point.x, point.y, BigInteger(1) << static_cast<unsigned>(scene.grid_bits)};
  }
  const UnroundedPoints::Source& source = scene.unrounded.sources[p.index()];
  if (!source.vertex.valid()) return (*scene.unrounded.made)[source.made.index()];
  return place_of(exact_corner(scene.mesh(), source.vertex, scene.camera));
}

}  // namespace sightline::inline geometry
