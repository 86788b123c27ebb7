#include "reconstruct/polygons/ring_linker.h"

#include <algorithm>
#include <map>

#include "geometry/numbers/errors.h"

namespace sightline::inline reconstruct {
namespace {

// A spoke is a segment seen from one of its ends.
struct Spoke {
  PointId point;
  std::size_t segment = 0;  // index within the surface's segments
  bool outgoing = false;    // the segment starts here
  bool leads_up = false;    // away from this end
};

// Returns whether a ring that comes to its top along one edge and leaves it along the other has what is visible below: it
// turns to the left there.
bool is_outer(const EdgeTurns& turns, const VisibleSegment& arriving, const VisibleSegment& leaving) {
  return turns.turn(arriving.edge, leaving.edge) < 0;
}

class RingLinker {
 public:
  RingLinker(const EdgeTurns& turns, const SweepOrder& order, const VisibleSegments& segments,
             std::span<const SegmentId> ids)
      : turns_(turns), order_(order), segments_(segments), ids_(ids) {
    collect_spokes();
    link();
  }

  std::vector<Walk> walks() {
    std::vector<Walk> result;
    std::vector<std::uint8_t> walked(ids_.size(), 0);
    for (std::size_t first = 0; first < ids_.size(); ++first) {
      if (walked[first] == 0) result.push_back(walk(first, walked));
    }
    return result;
  }

 private:
  [[nodiscard]] const VisibleSegment& segment(std::size_t i) const { return segments_.segments[ids_[i].index()]; }

  void collect_spokes() {
    for (std::size_t i = 0; i < ids_.size(); ++i) {
      const bool runs_up = order_(segment(i).end, segment(i).start);
      spokes_.push_back({segment(i).start, i, true, runs_up});
      spokes_.push_back({segment(i).end, i, false, !runs_up});
    }
    std::sort(spokes_.begin(), spokes_.end(), [this](const Spoke& a, const Spoke& b) {
      return a.point != b.point ? a.point < b.point : comes_before_around(a, b);
    });
  }

  // Counter-clockwise around a point come those that lead up, and then those that lead down. Lines that pass a point come in
  // one order above it as below it, from right to left above, where they are looked at backwards.
  [[nodiscard]] bool comes_before_around(const Spoke& a, const Spoke& b) const {
    if (a.leads_up != b.leads_up) return a.leads_up;
    return turns_.turn(segment(a.segment).edge, segment(b.segment).edge) > 0;
  }

  void link() {
    next_.resize(ids_.size());
    shared_.resize(ids_.size());
    for (std::size_t begin = 0; begin < spokes_.size();) {
      std::size_t end = begin;
      while (end < spokes_.size() && spokes_[end].point == spokes_[begin].point) ++end;
      link_at_point(std::span(spokes_).subspan(begin, end - begin));
      begin = end;
    }
  }

  // Counter-clockwise around a point, what is visible lies between a segment that starts there and the next one, which
  // ends there.
  void link_at_point(std::span<const Spoke> around) {
    for (std::size_t i = 0; i < around.size(); ++i) {
      const Spoke& leaving = around[i];
      const Spoke& arriving = around[i + 1 == around.size() ? 0 : i + 1];
      if (leaving.outgoing == arriving.outgoing) {
        throw InternalError("the visible segments of facet " + std::to_string(segment(leaving.segment).facet.value) +
                            " do not balance at point " + std::to_string(leaving.point.value));
      }
      if (!leaving.outgoing) continue;
      next_[arriving.segment] = leaving.segment;
      shared_[leaving.segment] = around.size() > 2 ? 1 : 0;
    }
  }

  Walk walk(std::size_t first, std::vector<std::uint8_t>& walked) {
    Walk result;
    std::vector<std::size_t> path;
    std::map<PointId, std::size_t> on_path;  // shared points only: their place on the path
    for (std::size_t i = first; walked[i] == 0; i = next_[i]) {
      walked[i] = 1;
      if (shared_[i] != 0) close_ring_at(segment(i).start, path, on_path, result);
      path.push_back(i);
    }
    add_ring(path, result);
    std::stable_partition(result.rings.begin(), result.rings.end(), [](const LinkedRing& ring) { return ring.outer; });
    if (result.rings.size() > 1 && result.rings[1].outer) {
      throw InternalError("two outer rings around one visible part at point " + std::to_string(result.top.value));
    }
    return result;
  }

  // The walk comes back to a shared point: what it has done since is a ring.
  void close_ring_at(PointId p, std::vector<std::size_t>& path, std::map<PointId, std::size_t>& on_path, Walk& result) {
    const auto [place, is_new] = on_path.try_emplace(p, path.size());
    if (is_new) return;
    const std::size_t begin = place->second;
    add_ring(std::span(path).subspan(begin), result);
    std::erase_if(on_path, [begin](const auto& entry) { return entry.second > begin; });
    path.resize(begin);
  }

  void add_ring(std::span<const std::size_t> path, Walk& result) const {
    std::size_t top = 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
      if (order_(segment(path[i]).start, segment(path[top]).start)) top = i;
    }
    const std::size_t before = path[top == 0 ? path.size() - 1 : top - 1];
    LinkedRing ring;
    ring.outer = is_outer(turns_, segment(before), segment(path[top]));
    for (std::size_t i = 0; i < path.size(); ++i) ring.segments.push_back(ids_[path[(top + i) % path.size()]]);
    const PointId first = segment(path[top]).start;
    if (!result.top.valid() || order_(first, result.top)) result.top = first;
    result.rings.push_back(std::move(ring));
  }

  const EdgeTurns& turns_;
  const SweepOrder& order_;
  const VisibleSegments& segments_;
  std::span<const SegmentId> ids_;
  std::vector<Spoke> spokes_;
  std::vector<std::size_t> next_;     // per segment: the one after it on its walk
  std::vector<std::uint8_t> shared_;  // per segment: more than one segment starts where it starts
};

constexpr std::size_t most_in_single_ring = 16;

}  // namespace

SingleRing single_ring(const EdgeTurns& turns, const SweepOrder& order, const VisibleSegments& segments,
                       std::span<const SegmentId> of_surface) {
  const std::size_t n = of_surface.size();
  if (n < 3 || n > most_in_single_ring) return {};
  const auto segment = [&](SegmentId s) -> const VisibleSegment& { return segments.segments[s.index()]; };
  SingleRing ring;
  ring.segments.assign(of_surface.begin(), of_surface.end());
  const auto start_of = [&](SegmentId s) { return segment(s).start; };
  std::iter_swap(ring.segments.begin(), std::ranges::min_element(ring.segments, order, start_of));
  const PointId top = start_of(ring.segments.front());
  for (auto rest = ring.segments.begin() + 1; rest != ring.segments.end(); ++rest) {
    const PointId end = segment(*(rest - 1)).end;
    const auto leaves = [&](SegmentId s) { return start_of(s) == end; };
    const auto next = std::find_if(rest, ring.segments.end(), leaves);
    if (end == top || next == ring.segments.end() || std::any_of(next + 1, ring.segments.end(), leaves)) return {};
    std::iter_swap(rest, next);
  }
  const VisibleSegment& first = segment(ring.segments.front());
  const VisibleSegment& last = segment(ring.segments.back());
  if (last.end != top) return {};
  ring.outer = is_outer(turns, last, first);
  return ring;
}

std::vector<Walk> link_rings(const EdgeTurns& turns, const SweepOrder& order, const VisibleSegments& segments,
                             std::span<const SegmentId> of_surface) {
  return RingLinker(turns, order, segments, of_surface).walks();
}

}  // namespace sightline::inline reconstruct
