#include "oracle/judging/ray_caster.h"

#include <algorithm>
#include <random>
#include <stdexcept>

#include "geometry/mesh/facet_plane.h"
#include "oracle/judging/ray_depth.h"

namespace sightline::lattice {
namespace {

// The range has the rays with y in [low, high], as indices.
struct RayRange {
  std::size_t begin;
  std::size_t end;
};

RayRange rays_between(const std::vector<ImagePoint>& rays, std::int64_t low, std::int64_t high) {
  const auto begin =
      std::lower_bound(rays.begin(), rays.end(), low, [](const ImagePoint& r, std::int64_t y) { return r.y < y; });
  const auto end =
      std::upper_bound(begin, rays.end(), high, [](std::int64_t y, const ImagePoint& r) { return y < r.y; });
  return {static_cast<std::size_t>(begin - rays.begin()), static_cast<std::size_t>(end - rays.begin())};
}

enum class Place2 { inside, outside, border };

// The test is even-odd, with half-open edges; turn > 0 where the ray lies left of the edge going up.
Place2 place_in(const std::vector<ImagePoint>& ring, const ImagePoint& ray) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const ImagePoint& p = ring[i];
    const ImagePoint& q = ring[(i + 1) % ring.size()];
    const Sign turn = orientation(p, q, ray);
    const bool in_box = std::min(p.x, q.x) <= ray.x && ray.x <= std::max(p.x, q.x) && std::min(p.y, q.y) <= ray.y &&
                        ray.y <= std::max(p.y, q.y);
    if (turn == 0 && in_box) return Place2::border;
    if ((p.y <= ray.y) != (q.y <= ray.y) && (turn > 0) == (q.y > p.y)) inside = !inside;
  }
  return inside ? Place2::inside : Place2::outside;
}

// A floor is an end of a visible segment, rounded down, and says whether that was a change. Comparisons with whole
// numbers stay exact.
struct Floor {
  std::int64_t y = 0;
  bool above = false;  // the end is strictly above y
};

template <class Integer>
Floor floor_of(const Integer& numerator, const Integer& denominator) {
  Integer quotient = numerator / denominator;
  const Integer rest = numerator - quotient * denominator;
  if (rest < 0) quotient -= 1;
  return {quotient.template convert_to<std::int64_t>(), rest != 0};
}

std::vector<Floor> floors(const View& view) {
  std::vector<Floor> result;
  for (const ImagePoint& p : view.scene.points) result.push_back({p.y, false});
  for (std::size_t c = 0; c < view.segments.crossings.size(); ++c) {
    const ExactPoint p = exact_point(view.scene, view.segments, PointId(view.scene.points.size() + c));
    result.push_back(floor_of(p.y, p.denominator));
  }
  return result;
}

bool is_above(const Floor& end, std::int64_t y) { return end.y > y || (end.y == y && end.above); }

// Returns whether the point lies on the line through a and b, exactly.
bool on_line(const View& view, PointId point, const ImagePoint& a, const ImagePoint& b) {
  using boost::multiprecision::cpp_int;
  const ExactPoint exact = exact_point(view.scene, view.segments, point);
  const auto x = exact.x.convert_to<cpp_int>();
  const auto y = exact.y.convert_to<cpp_int>();
  const auto d = exact.denominator.convert_to<cpp_int>();
  return (b.x - a.x) * cpp_int(y - d * a.y) == (b.y - a.y) * cpp_int(x - d * a.x);
}

// The ends have to be on the segment's edge, so that the edge's line is the segment's.
void require_ends_on_edge(const View& view, const VisibleSegment& s) {
  const SceneEdge& edge = view.scene.edge(s.edge);
  for (const PointId end : {s.start, s.end}) {
    if (end == edge.top || end == edge.bottom) continue;
    if (!on_line(view, end, view.scene.point(edge.top), view.scene.point(edge.bottom))) {
      throw std::logic_error("a visible segment ends off its edge, at point " + std::to_string(end.value));
    }
  }
}

}  // namespace

std::vector<ImagePoint> fixed_rays(int grid_bits, std::size_t count) {
  std::mt19937_64 engine(1993);
  const std::uint64_t inner = (std::uint64_t{2} << static_cast<unsigned>(grid_bits)) - 1;
  const std::int64_t half = std::int64_t{1} << static_cast<unsigned>(grid_bits);
  const auto coordinate = [&] { return static_cast<std::int64_t>(engine() % inner) - half + 1; };
  std::vector<ImagePoint> rays;
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t x = coordinate();
    rays.push_back({x, coordinate()});
  }
  std::sort(rays.begin(), rays.end(), [](const ImagePoint& a, const ImagePoint& b) { return a.y < b.y; });
  return rays;
}

std::vector<RayHits> cast(const ProjectedScene& scene, const std::vector<ImagePoint>& rays) {
  std::vector<RayHits> hits(rays.size());
  std::vector<ImagePoint> ring;
  for (std::size_t f = 0; f < scene.status.size(); ++f) {
    ring.clear();
    for (const ClippedCorner& c : scene.polygon(FacetId(f))) ring.push_back(scene.point(c.point));
    if (ring.empty()) continue;
    const auto [low, high] = std::minmax_element(ring.begin(), ring.end(), [](auto& a, auto& b) { return a.y < b.y; });
    const RayRange range = rays_between(rays, low->y, high->y);
    for (std::size_t r = range.begin; r < range.end; ++r) {
      const Place2 place = place_in(ring, rays[r]);
      hits[r].on_edge |= place == Place2::border;
      if (place == Place2::inside) hits[r].facets.emplace_back(f);
    }
  }
  return hits;
}

namespace {

// The facet is one of the mesh, which need not be the scene's.
bool is_front(const PolygonMesh& mesh, const Camera& camera, FacetId f) {
  const auto [a, b, c] = plane_corners(mesh, mesh.corners(f));
  return orient3d(mesh.position(a), mesh.position(b), mesh.position(c), camera.eye) > 0;
}

}  // namespace

void sort_by_depth(std::vector<FacetId>& facets, const PolygonMesh& mesh, const ProjectedScene& scene,
                   const ImagePoint& ray) {
  std::vector<std::pair<RayDepth, FacetId>> placed;
  for (const FacetId f : facets) placed.emplace_back(depth_along(mesh, scene, f, ray), f);
  std::sort(placed.begin(), placed.end(), [&](const auto& a, const auto& b) {
    const Sign order = nearer(a.first, b.first);
    if (order != 0) return order > 0;
    const bool looks_at_eye = is_front(mesh, scene.camera, a.second);
    if (looks_at_eye != is_front(mesh, scene.camera, b.second)) return looks_at_eye;
    const FaceId face_a = mesh.facet_face[a.second.index()];
    const FaceId face_b = mesh.facet_face[b.second.index()];
    return face_a != face_b ? face_a < face_b : a.second < b.second;
  });
  for (std::size_t i = 0; i < facets.size(); ++i) facets[i] = placed[i].second;
}

std::vector<std::vector<std::size_t>> polygons_around(const View& view, const std::vector<ImagePoint>& rays) {
  const std::vector<Floor> heights = floors(view);
  std::vector<std::vector<std::size_t>> around(rays.size());
  const auto toggle = [&](std::size_t ray, std::size_t polygon) {
    auto& list = around[ray];
    const auto found = std::find(list.begin(), list.end(), polygon);
    if (found == list.end()) {
      list.push_back(polygon);
    } else {
      list.erase(found);
    }
  };
  for (std::size_t p = 0; p < view.polygons.polygons.size(); ++p) {
    const VisiblePolygon& polygon = view.polygons.polygons[p];
    for (std::size_t ring = polygon.first_ring; ring < polygon.first_ring + polygon.ring_count; ++ring) {
      for (const SegmentId id : view.polygons.ring(ring)) {
        const VisibleSegment& s = view.segments.segments[id.index()];
        require_ends_on_edge(view, s);
        const SceneEdge& edge = view.scene.edge(s.edge);
        const Floor& a = heights[s.start.index()];
        const Floor& b = heights[s.end.index()];
        const RayRange range = rays_between(rays, std::min(a.y, b.y), std::max(a.y, b.y));
        for (std::size_t r = range.begin; r < range.end; ++r) {
          if (is_above(a, rays[r].y) == is_above(b, rays[r].y)) continue;
          if (orientation(view.scene.point(edge.bottom), view.scene.point(edge.top), rays[r]) > 0) toggle(r, p);
        }
      }
    }
  }
  return around;
}

}  // namespace sightline::lattice
