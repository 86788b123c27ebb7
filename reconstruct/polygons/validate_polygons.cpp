// Precondition: mesh and scene are valid, and validate(segments, scene) is empty.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "geometry/mesh/facet_plane.h"
#include "geometry/numbers/id_names.h"
#include "geometry/projection/clipping.h"
#include "reconstruct/polygons/ring_measure.h"
#include "reconstruct/polygons/surface_layout.h"
#include "reconstruct/polygons/visible_polygons.h"

namespace sightline::inline reconstruct {
namespace {

using Messages = std::vector<std::string>;

// These say how many polygons have their area checked against the exact one, and how many ring segments are looked at
// to place the holes of one polygon: what is beyond is checked for an even choice.
constexpr std::size_t exact_areas = 1024;
constexpr std::size_t hole_budget = std::size_t{1} << 24U;

std::string ring_name(std::size_t r) { return "ring " + std::to_string(r); }
std::string polygon_name(std::size_t p) { return "polygon " + std::to_string(p); }

// Sizes and ranges come first: the other checks need them in order to look at anything.
Messages check_arrays(const VisiblePolygons& polygons, const CutMesh& mesh, const VisibleSegments& segments) {
  Messages messages;
  const auto require = [&](bool holds, const char* what) {
    if (!holds) messages.emplace_back(what);
  };
  const auto& begin = polygons.ring_begin;
  require(!begin.empty() && begin.front() == 0 &&
              std::ranges::adjacent_find(begin, std::greater_equal{}) == begin.end() &&
              begin.back() == polygons.ring_segments.size(),
          "ring_begin: not the ranges of rings with segments");
  require(
      std::ranges::all_of(polygons.ring_segments, [&](SegmentId s) { return s.index() < segments.segments.size(); }),
      "ring_segments: no such segment");
  std::size_t rings = 0;
  bool consecutive = true;
  for (const VisiblePolygon& p : polygons.polygons) {
    consecutive = consecutive && p.first_ring == rings && p.ring_count > 0;
    rings += p.ring_count;
    require(p.facet.index() < mesh.facet_count(), "polygons: no such facet");
  }
  require(consecutive && begin.size() == rings + 1, "polygons: not the ranges of the rings");
  return messages;
}

class PolygonCheck {
 public:
  PolygonCheck(const VisiblePolygons& polygons, const ProjectedScene& scene, const VisibleSegments& segments,
               Messages& messages)
      : polygons_(polygons),
        mesh_(scene.mesh()),
        scene_(scene),
        segments_(segments),
        sides_(scene, segments),
        messages_(messages) {}

  void run() {
    check_uses();
    for (std::size_t r = 0; r < polygons_.ring_count(); ++r) check_chain(r);
    for (std::size_t p = 0; p < polygons_.polygons.size(); ++p) check_surface(p);
    check_threads();
    if (!messages_.empty()) return;
    for (std::size_t p = 0; p < polygons_.polygons.size(); ++p) {
      check_order(p);
      check_roles(p);
      check_holes(p);
      check_measures(p);
    }
    check_surface_layouts();
  }

 private:
  [[nodiscard]] const VisibleSegment& segment(SegmentId s) const { return segments_.segments[s.index()]; }
  [[nodiscard]] FacetId surface(SegmentId s) const { return surface_of(mesh_, segment(s).facet); }
  [[nodiscard]] PointId first_point(std::size_t ring) const { return segment(polygons_.ring(ring).front()).start; }

  void check_uses() {
    std::vector<std::uint32_t> uses(segments_.segments.size(), 0);
    for (const SegmentId s : polygons_.ring_segments) ++uses[s.index()];
    for (std::size_t s = 0; s < uses.size(); ++s) {
      if (uses[s] != 1) messages_.push_back(name(SegmentId(s)) + " is in " + std::to_string(uses[s]) + " rings");
    }
  }

  void check_chain(std::size_t r) {
    const auto ring = polygons_.ring(r);
    std::vector<PointId> visited;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const VisibleSegment& s = segment(ring[i]);
      const VisibleSegment& following = segment(ring[i + 1 == ring.size() ? 0 : i + 1]);
      visited.push_back(s.start);
      if (s.end != following.start) messages_.push_back(ring_name(r) + " is interrupted after " + name(ring[i]));
      if (sides_.before(s.start, first_point(r)))
        messages_.push_back(ring_name(r) + " does not start at its first point in sweep order, " + name(s.start));
    }
    std::ranges::sort(visited);
    const auto twice = std::ranges::adjacent_find(visited);
    if (twice != visited.end()) messages_.push_back(ring_name(r) + " visits " + name(*twice) + " twice");
  }

  // This is what keeps the polygons of a face that is not planar within one facet each.
  void check_surface(std::size_t p) {
    const VisiblePolygon& polygon = polygons_.polygons[p];
    if (mesh_.facet_face[polygon.facet.index()] != polygon.face)
      messages_.push_back(polygon_name(p) + " is not of the face of its facet");
    for (std::size_t r = polygon.first_ring; r < polygon.first_ring + polygon.ring_count; ++r) {
      for (const SegmentId s : polygons_.ring(r)) {
        if (surface(s) != surface_of(mesh_, polygon.facet))
          messages_.push_back(polygon_name(p) + " has " + name(s) + " of another surface");
      }
    }
  }

  void check_threads() {
    for (std::size_t t = 0; t < segments_.threads.size(); ++t) {
      const Thread& thread = segments_.threads[t];
      if (surface_of(mesh_, thread.facet) != surface(thread.segment))
        messages_.push_back("thread " + std::to_string(t) + " leads to " + name(thread.segment) +
                            " of another surface");
    }
  }

  void check_order(std::size_t p) {
    if (p == 0) return;
    const VisiblePolygon& a = polygons_.polygons[p - 1];
    const VisiblePolygon& b = polygons_.polygons[p];
    const bool same = a.face == b.face && a.facet == b.facet;
    if (std::tie(b.face, b.facet) < std::tie(a.face, a.facet) ||
        (same && sides_.before(first_point(b.first_ring), first_point(a.first_ring))))
      messages_.push_back(polygon_name(p) + " should come before the polygon before it");
  }

  void check_roles(std::size_t p) {
    const VisiblePolygon& polygon = polygons_.polygons[p];
    for (std::size_t r = polygon.first_ring; r < polygon.first_ring + polygon.ring_count; ++r) {
      const bool outer = r == polygon.first_ring;
      if (area_sign(sides_.points(), segments_, polygons_.ring(r)) != (outer ? 1 : -1))
        messages_.push_back(ring_name(r) + " of " + polygon_name(p) +
                            (outer ? " is not counter-clockwise" : " is a hole and not clockwise"));
    }
  }

  void check_holes(std::size_t p) {
    const VisiblePolygon& polygon = polygons_.polygons[p];
    const auto outer = polygons_.ring(polygon.first_ring);
    const std::size_t step = 1 + (polygon.ring_count - 1) * outer.size() / hole_budget;
    for (std::size_t hole = 1; hole < polygon.ring_count; hole += step) {
      const std::size_t r = polygon.first_ring + hole;
      if (!covers(outer, first_point(r)))
        messages_.push_back(ring_name(r) + " is a hole outside the outer ring of " + polygon_name(p));
    }
  }

  // Returns whether p lies on the ring or inside it: the sweep line from the left to p crosses it an odd number of
  // times.
  [[nodiscard]] bool covers(std::span<const SegmentId> ring, PointId p) const {
    bool inside = false;
    for (const SegmentId id : ring) {
      const VisibleSegment& s = segment(id);
      if (s.start == p) return true;
      if (sides_.before(p, sides_.upper(s)) || !sides_.before(p, sides_.lower(s))) continue;
      const Sign side = sides_.side(s.edge, p);
      if (side == 0) return true;
      if (side > 0) inside = !inside;
    }
    return inside;
  }

  void check_measures(std::size_t p) {
    const VisiblePolygon& polygon = polygons_.polygons[p];
    RingMeasure m;
    for (std::size_t r = polygon.first_ring; r < polygon.first_ring + polygon.ring_count; ++r)
      m += measure(sides_.points(), segments_, polygons_.ring(r));
    const double twice_area = 2 * polygon.area;
    const double perimeter = polygon.perimeter;
    // Both may be off by the bound.
    if (!(std::fabs(twice_area - m.twice_area.value) <= 2 * m.twice_area.radius))
      messages_.push_back(polygon_name(p) + " has another area than the one recorded");
    else if (p % (1 + polygons_.polygons.size() / exact_areas) == 0)
      check_exact_area(p, twice_area, m.twice_area.radius);
    if (!(std::fabs(perimeter - m.perimeter.value) <= 2 * m.perimeter.radius))
      messages_.push_back(polygon_name(p) + " has another perimeter than the one recorded");
    if (polygon.below_resolution != is_below_resolution(scene_, polygon.facet, polygon.area, perimeter))
      messages_.push_back(polygon_name(p) + (polygon.below_resolution ? " is not" : " is") + " below resolution");
  }

  void check_exact_area(std::size_t p, double twice_area, double error) {
    const VisiblePolygon& polygon = polygons_.polygons[p];
    const std::size_t begin = polygons_.ring_begin[polygon.first_ring];
    const std::size_t end = polygons_.ring_begin[polygon.first_ring + polygon.ring_count];
    const ExactArea exact =
        exact_twice_area(sides_.points(), segments_, std::span(polygons_.ring_segments).subspan(begin, end - begin));
    const double rounded = rounded_quotient(exact.numerator, exact.denominator);
    if (!(std::fabs(twice_area - rounded) <= error + 0x1p-52 * std::fabs(rounded)))
      messages_.push_back(polygon_name(p) + " has another exact area than the one recorded");
  }

  void check_surface_layouts() {
    std::vector<std::pair<FacetId, SegmentId>> by_surface;
    for (std::size_t s = 0; s < segments_.segments.size(); ++s)
      by_surface.emplace_back(surface(SegmentId(s)), SegmentId(s));
    std::ranges::sort(by_surface);
    std::vector<SegmentId> ids;
    for (std::size_t i = 0; i < by_surface.size(); ++i) {
      ids.push_back(by_surface[i].second);
      if (i + 1 < by_surface.size() && by_surface[i + 1].first == by_surface[i].first) continue;
      check_surface_layout(sides_, segments_, std::exchange(ids, {}), messages_);
    }
    check_folds();
  }

  // In large surfaces not all pairs are compared: here only those are that follow each other on a ring.
  void check_folds() {
    for (std::size_t r = 0; r < polygons_.ring_count(); ++r) {
      const auto ring = polygons_.ring(r);
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const SegmentId following = ring[i + 1 == ring.size() ? 0 : i + 1];
        if (meet_inside(sides_, segment(ring[i]), segment(following)))
          messages_.push_back(ring_name(r) + " folds back from " + name(ring[i]) + " to " + name(following));
      }
    }
  }

  const VisiblePolygons& polygons_;
  const CutMesh& mesh_;
  const ProjectedScene& scene_;
  const VisibleSegments& segments_;
  const EdgeSides sides_;
  Messages& messages_;
};

}  // namespace

std::vector<std::string> validate(const VisiblePolygons& polygons, const ProjectedScene& scene,
                                  const VisibleSegments& segments) {
  const CutMesh& mesh = scene.mesh();
  Messages messages = check_arrays(polygons, mesh, segments);
  if (messages.empty()) PolygonCheck(polygons, scene, segments, messages).run();
  return messages;
}

}  // namespace sightline::inline reconstruct
