#include "reconstruct/polygons/visible_polygons.h"

#include <algorithm>
#include <cmath>

#include "geometry/mesh/facet_plane.h"
#include "geometry/numbers/errors.h"
#include "geometry/numbers/grouping.h"
#include "geometry/numbers/parallel.h"
#include "reconstruct/polygons/ring_linker.h"
#include "reconstruct/polygons/ring_measure.h"
#include "sweep/segments/image_points.h"

namespace sightline::inline reconstruct {
namespace {

// The polygons of one surface are the walks with an outer ring, and the holes that threads lead to them.
class SurfacePolygons {
 public:
  SurfacePolygons(const EdgeTurns& turns, const SweepOrder& order, const VisibleSegments& segments,
                  std::span<const SegmentId> ids)
      : walks_(link_rings(turns, order, segments, ids)) {
    for (std::size_t w = 0; w < walks_.size(); ++w) {
      for (const LinkedRing& ring : walks_[w].rings) {
        for (const SegmentId s : ring.segments) walk_of_.emplace_back(s, w);
      }
    }
    std::sort(walk_of_.begin(), walk_of_.end());
  }

  // Returns, per walk with an outer ring, all its rings; walks are in sweep order of their tops.
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
  // A thread may lead to another hole, which in turn has a thread (Fang 5.3.1).
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

// Returns, per facet that names a surface, the surface's segments, in their order.
Grouping<SegmentId> segments_by_surface(const CutMesh& mesh, const VisibleSegments& segments) {
  Grouping<SegmentId> of_surface(mesh.facet_count(), [&](const auto& visit) {
    parallel_for_each(segments.segments.size(), [&](std::size_t s) {
      visit(surface_of(mesh, segments.segments[s].facet).index(), SegmentId(s));
    });
  });
  parallel_for_each(mesh.facet_count(), [&](std::size_t surface) { std::ranges::sort(of_surface.of(surface)); });
  return of_surface;
}

// All surfaces are reconstructed from these: what the sweep found, and how and where its points and edges are.
struct Sources {
  Sources(const ProjectedScene& s, const VisibleSegments& v)
      : scene(s),
        mesh(s.mesh()),
        segments(v),
        points(s, v),
        order(points.order()),
        of_surface(segments_by_surface(mesh, v)),
        threads(v.threads) {
    std::stable_sort(threads.begin(), threads.end(), [this](const Thread& a, const Thread& b) {
      return surface_of(mesh, a.facet) < surface_of(mesh, b.facet);
    });
  }

  const ProjectedScene& scene;
  const CutMesh& mesh;
  const VisibleSegments& segments;
  const ImagePoints points;
  const SweepOrder& order;
  const Grouping<SegmentId> of_surface;
  std::vector<Thread> threads;  // by surface; those of one surface stay in sweep order
};

// This reconstructs the polygons of some of the surfaces, one after the other.
class Reconstruction {
 public:
  explicit Reconstruction(const Sources& from) : from_(from) {}

  void add_surface(FacetId surface) {
    const auto ids = from_.of_surface.of(surface.index());
    const SingleRing single = single_ring(from_.points, from_.order, from_.segments, ids);
    if (single.outer) {
      add_single(surface, {single.segments.data(), single.segments.size()});
    } else if (!ids.empty()) {
      add_with_holes(surface, ids);
    }
  }

  [[nodiscard]] const VisiblePolygons& result() const { return result_; }

 private:
  void add_single(FacetId surface, std::span<const SegmentId> ring) {
    RingMeasure total;
    const auto first_ring = static_cast<std::uint32_t>(result_.ring_count());
    add_ring(ring, total);
    finish_polygon(surface, first_ring, total);
  }

  void add_with_holes(FacetId surface, std::span<const SegmentId> ids) {
    const auto by_surface = [this](const Thread& a, const Thread& b) {
      return surface_of(from_.mesh, a.facet) < surface_of(from_.mesh, b.facet);
    };
    const auto [first, last] =
        std::equal_range(from_.threads.begin(), from_.threads.end(), Thread{{}, surface, {}}, by_surface);
    SurfacePolygons polygons(from_.points, from_.order, from_.segments, ids);
    for (const auto& rings : polygons.polygons({first, last}, from_.order)) add_polygon(surface, rings);
  }

  void add_polygon(FacetId surface, const std::vector<LinkedRing>& rings) {
    const auto first_ring = static_cast<std::uint32_t>(result_.ring_count());
    RingMeasure total;
    for (const LinkedRing& ring : rings) add_ring(ring.segments, total);
    finish_polygon(surface, first_ring, total);
  }

  void add_ring(std::span<const SegmentId> ring, RingMeasure& total) {
    total += measure(from_.points, from_.segments, ring);
    result_.ring_segments.insert(result_.ring_segments.end(), ring.begin(), ring.end());
    result_.ring_begin.push_back(static_cast<std::uint32_t>(result_.ring_segments.size()));
  }

  // The polygon has the rings from first_ring on.
  void finish_polygon(FacetId surface, std::uint32_t first_ring, const RingMeasure& total) {
    VisiblePolygon polygon;
    polygon.facet = surface;
    polygon.face = from_.mesh.facet_face[surface.index()];
    polygon.first_ring = first_ring;
    polygon.ring_count = static_cast<std::uint32_t>(result_.ring_count()) - first_ring;
    polygon.area = total.twice_area.value / 2;
    polygon.perimeter = total.perimeter.value;
    polygon.below_resolution = is_below_resolution(from_.scene, surface, polygon.area, polygon.perimeter);
    result_.polygons.push_back(polygon);
  }

  const Sources& from_;
  VisiblePolygons result_;
};

void append(VisiblePolygons& all, const VisiblePolygons& part) {
  const auto rings = static_cast<std::uint32_t>(all.ring_count());
  const auto segments = static_cast<std::uint32_t>(all.ring_segments.size());
  for (VisiblePolygon polygon : part.polygons) {
    polygon.first_ring += rings;
    all.polygons.push_back(polygon);
  }
  for (std::size_t r = 1; r < part.ring_begin.size(); ++r) all.ring_begin.push_back(segments + part.ring_begin[r]);
  all.ring_segments.insert(all.ring_segments.end(), part.ring_segments.begin(), part.ring_segments.end());
}

VisiblePolygons reconstruct(const Sources& sources) {
  const std::size_t facet_count = sources.mesh.facet_count();
  std::vector<VisiblePolygons> parts(range_count(facet_count));
  parallel_for_ranges(facet_count, [&](std::size_t range, std::size_t begin, std::size_t end) {
    Reconstruction reconstruction(sources);
    for (std::size_t f = begin; f < end; ++f) reconstruction.add_surface(FacetId(f));
    parts[range] = reconstruction.result();
  });
  VisiblePolygons polygons;
  for (const VisiblePolygons& part : parts) append(polygons, part);
  return polygons;
}

}  // namespace

VisiblePolygons reconstruct_polygons(const ProjectedScene& scene, const VisibleSegments& segments) {
  return with_invariants_of(scene.arithmetic, [&] { return reconstruct(Sources(scene, segments)); });
}

Rational exact_area(const ProjectedScene& scene, const VisibleSegments& segments, const VisiblePolygons& polygons,
                    std::size_t polygon) {
  const VisiblePolygon& p = polygons.polygons[polygon];
  Rational twice_area = 0;
  for (std::size_t r = p.first_ring; r < p.first_ring + p.ring_count; ++r) {
    for (const SegmentId s : polygons.ring(r)) {
      const ExactPlace a = exact_place(scene, segments, segments.segments[s.index()].start);
      const ExactPlace b = exact_place(scene, segments, segments.segments[s.index()].end);
      twice_area += Rational(BigInteger(a.x * b.y - a.y * b.x), BigInteger(a.w * b.w));
    }
  }
  return twice_area / 2 * Rational(BigInteger(1) << static_cast<unsigned>(2 * scene.grid_bits));
}

}  // namespace sightline::inline reconstruct
