#include "reconstruct/visible_polygons.h"

#include <algorithm>
#include <cmath>

#include "geometry/errors.h"
#include "geometry/facet_plane.h"
#include "reconstruct/ring_linker.h"
#include "sweep/image_points.h"

namespace sightline {
namespace {

// The polygons of one surface: walks with an outer ring, and the holes that threads lead to them.
class SurfacePolygons {
 public:
  SurfacePolygons(const ProjectedScene& scene, const VisibleSegments& segments, std::span<const SegmentId> ids)
      : walks_(link_rings(scene, segments, ids)) {
    for (std::size_t w = 0; w < walks_.size(); ++w) {
      for (const LinkedRing& ring : walks_[w].rings) {
        for (const SegmentId s : ring.segments) walk_of_.emplace_back(s, w);
      }
    }
    std::sort(walk_of_.begin(), walk_of_.end());
  }

  // Per walk with an outer ring, in sweep order of its top: all its rings.
  std::vector<std::vector<LinkedRing>> polygons(std::span<const Thread> threads, const SweepOrder& order) {
    std::vector<std::size_t> polygon_walks;
    for (std::size_t w = 0; w < walks_.size(); ++w) {
      if (walks_[w].has_outer()) polygon_walks.push_back(w);
    }
    std::sort(polygon_walks.begin(), polygon_walks.end(),
              [&](std::size_t a, std::size_t b) { return order(walks_[a].top, walks_[b].top); });
    for (std::size_t w = 0; w < walks_.size(); ++w) {
      if (!walks_[w].has_outer()) give_holes(w, threads, order);
    }
    std::vector<std::vector<LinkedRing>> result;
    for (const std::size_t w : polygon_walks) result.push_back(std::move(walks_[w].rings));
    return result;
  }

 private:
  // Fang 5.3.1: a thread may lead to another hole, which in turn has a thread.
  void give_holes(std::size_t hole, std::span<const Thread> threads, const SweepOrder& order) {
    std::size_t w = hole;
    for (std::size_t steps = 0; !walks_[w].has_outer(); ++steps) {
      const auto thread = std::lower_bound(threads.begin(), threads.end(), walks_[w].top,
                                           [&order](const Thread& t, PointId top) { return order(t.top, top); });
      if (thread == threads.end() || thread->top != walks_[w].top || steps > walks_.size()) {
        throw InternalError("no thread leads from the hole at point " + std::to_string(walks_[w].top.value));
      }
      w = walk_of(thread->segment);
    }
    auto& rings = walks_[w].rings;
    rings.insert(rings.end(), walks_[hole].rings.begin(), walks_[hole].rings.end());
  }

  [[nodiscard]] std::size_t walk_of(SegmentId s) const {
    const auto found = std::lower_bound(walk_of_.begin(), walk_of_.end(), std::pair{s, std::size_t{0}});
    if (found == walk_of_.end() || found->first != s) {
      throw InternalError("a thread leads to segment " + std::to_string(s.value) + " of another surface");
    }
    return found->second;
  }

  std::vector<Walk> walks_;
  std::vector<std::pair<SegmentId, std::size_t>> walk_of_;
};

// Area and perimeter of a ring; coordinates relative to its first point keep the products small.
struct Measure {
  double twice_area = 0;
  double perimeter = 0;
};

Measure measure(const ImagePoints& points, const VisibleSegments& segments, std::span<const SegmentId> ring) {
  Measure m;
  const Point2 origin = points.approximate(segments.segments[ring.front().index()].start);
  for (const SegmentId s : ring) {
    const Point2& a = points.approximate(segments.segments[s.index()].start);
    const Point2& b = points.approximate(segments.segments[s.index()].end);
    m.twice_area += (a.x - origin.x) * (b.y - origin.y) - (a.y - origin.y) * (b.x - origin.x);
    m.perimeter += std::hypot(b.x - a.x, b.y - a.y);
  }
  return m;
}

class Reconstruction {
 public:
  Reconstruction(const Mesh& mesh, const ProjectedScene& scene, const VisibleSegments& segments)
      : mesh_(mesh), scene_(scene), segments_(segments), points_(scene, segments), order_(scene, segments) {}

  VisiblePolygons run() {
    const std::vector<SegmentId> by_surface = sorted_segments();
    const auto threads = sorted_threads();
    for (std::size_t begin = 0; begin < by_surface.size();) {
      const FacetId surface = surface_of_segment(by_surface[begin]);
      std::size_t end = begin + 1;
      while (end < by_surface.size() && surface_of_segment(by_surface[end]) == surface) ++end;
      add_surface(surface, std::span(by_surface).subspan(begin, end - begin), threads);
      begin = end;
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] FacetId surface_of_segment(SegmentId s) const {
    return surface_of(mesh_, segments_.segments[s.index()].facet);
  }

  // By surface; those of one surface stay in their order.
  [[nodiscard]] std::vector<SegmentId> sorted_segments() const {
    std::vector<std::uint32_t> next(mesh_.facet_count() + 1, 0);
    for (std::size_t s = 0; s < segments_.segments.size(); ++s) ++next[surface_of_segment(SegmentId(s)).index() + 1];
    for (std::size_t f = 1; f < next.size(); ++f) next[f] += next[f - 1];
    std::vector<SegmentId> sorted(segments_.segments.size());
    for (std::size_t s = 0; s < sorted.size(); ++s)
      sorted[next[surface_of_segment(SegmentId(s)).index()]++] = SegmentId(s);
    return sorted;
  }

  // By surface; those of one surface stay in sweep order.
  [[nodiscard]] std::vector<Thread> sorted_threads() const {
    std::vector<Thread> sorted = segments_.threads;
    std::stable_sort(sorted.begin(), sorted.end(), [this](const Thread& a, const Thread& b) {
      return surface_of(mesh_, a.facet) < surface_of(mesh_, b.facet);
    });
    return sorted;
  }

  void add_surface(FacetId surface, std::span<const SegmentId> ids, std::span<const Thread> threads) {
    const SingleRing single = single_ring(scene_, segments_, order_, ids);
    if (single.outer) {
      Measure total;
      const auto first_ring = static_cast<std::uint32_t>(result_.ring_count());
      add_ring({single.segments.data(), single.segments.size()}, total);
      finish_polygon(surface, first_ring, total);
      return;
    }
    const auto [first, last] = std::equal_range(
        threads.begin(), threads.end(), Thread{{}, surface, {}},
        [this](const Thread& a, const Thread& b) { return surface_of(mesh_, a.facet) < surface_of(mesh_, b.facet); });
    SurfacePolygons polygons(scene_, segments_, ids);
    for (const auto& rings : polygons.polygons({first, last}, order_)) add_polygon(surface, rings);
  }

  void add_polygon(FacetId surface, const std::vector<LinkedRing>& rings) {
    const auto first_ring = static_cast<std::uint32_t>(result_.ring_count());
    Measure total;
    for (const LinkedRing& ring : rings) add_ring(ring.segments, total);
    finish_polygon(surface, first_ring, total);
  }

  void add_ring(std::span<const SegmentId> ring, Measure& total) {
    const Measure m = measure(points_, segments_, ring);
    total.twice_area += m.twice_area;
    total.perimeter += m.perimeter;
    result_.ring_segments.insert(result_.ring_segments.end(), ring.begin(), ring.end());
    result_.ring_begin.push_back(static_cast<std::uint32_t>(result_.ring_segments.size()));
  }

  // Of the rings from first_ring on.
  void finish_polygon(FacetId surface, std::uint32_t first_ring, const Measure& total) {
    VisiblePolygon polygon;
    polygon.facet = surface;
    polygon.face = mesh_.facet_face[surface.index()];
    polygon.first_ring = first_ring;
    polygon.ring_count = static_cast<std::uint32_t>(result_.ring_count()) - first_ring;
    polygon.below_resolution = total.twice_area < total.perimeter;
    polygon.area = std::ldexp(total.twice_area / 2, -2 * scene_.grid_bits);
    polygon.perimeter = std::ldexp(total.perimeter, -scene_.grid_bits);
    result_.polygons.push_back(polygon);
  }

  const Mesh& mesh_;
  const ProjectedScene& scene_;
  const VisibleSegments& segments_;
  const ImagePoints points_;
  const SweepOrder order_;
  VisiblePolygons result_;
};

}  // namespace

VisiblePolygons reconstruct_polygons(const Mesh& mesh, const ProjectedScene& scene, const VisibleSegments& segments) {
  return with_invariants_of(scene.arithmetic, [&] { return Reconstruction(mesh, scene, segments).run(); });
}

Rational exact_area(const ProjectedScene& scene, const VisibleSegments& segments, const VisiblePolygons& polygons,
                    std::size_t polygon) {
  const VisiblePolygon& p = polygons.polygons[polygon];
  Rational twice_area = 0;
  const auto rational = [](const Wide512& numerator, const Wide512& denominator) {
    return Rational(BigInteger(numerator), BigInteger(denominator));
  };
  for (std::size_t r = p.first_ring; r < p.first_ring + p.ring_count; ++r) {
    for (const SegmentId s : polygons.ring(r)) {
      const ExactPoint a = exact_point(scene, segments, segments.segments[s.index()].start);
      const ExactPoint b = exact_point(scene, segments, segments.segments[s.index()].end);
      twice_area += rational(Wide512(a.x * b.y - a.y * b.x), Wide512(a.denominator * b.denominator));
    }
  }
  return twice_area / 2;
}

}  // namespace sightline
