#include "reconstruct/polygons/surface_layout.h"

#include <algorithm>

#include "geometry/numbers/id_names.h"

namespace sightline::inline reconstruct {
namespace {

constexpr std::size_t checked_in_full = 64;

class SurfaceLayout {
 public:
  SurfaceLayout(const EdgeSides& sides, const VisibleSegments& segments, std::vector<SegmentId> of_surface)
      : sides_(sides), segments_(segments), ids_(std::move(of_surface)) {
    std::ranges::sort(ids_, [this](SegmentId a, SegmentId b) {
      const PointId upper_a = sides_.upper(segment(a));
      const PointId upper_b = sides_.upper(segment(b));
      return upper_a != upper_b ? sides_.before(upper_a, upper_b) : a < b;
    });
  }

  // Segments whose spans of the sweep have nothing but an end in common cannot meet elsewhere.
  void check_meetings(std::vector<std::string>& messages) const {
    for (std::size_t i = 0; i < ids_.size(); ++i) {
      const std::size_t end = std::min(ids_.size(), i + 1 + checked_in_full);
      for (std::size_t j = i + 1; j < end && opens_within(ids_[j], ids_[i]); ++j) {
        if (meet_inside(sides_, segment(ids_[i]), segment(ids_[j])))
          messages.push_back(name(ids_[i]) + " and " + name(ids_[j]) + " meet outside their end points");
      }
    }
  }

  void check_windings(std::vector<std::string>& messages) const {
    const std::size_t count = std::min(ids_.size(), checked_in_full);
    for (std::size_t i = 0; i < count; ++i) {
      const SegmentId s = ids_[i * ids_.size() / count];
      const int expected = sides_.runs_down(segment(s)) ? 0 : 1;
      const int winding = winding_left_of(s);
      if (winding != expected)
        messages.push_back(name(s) + ": what is visible has the winding number " +
                           std::to_string(winding + 1 - expected) + " to its left");
    }
  }

 private:
  [[nodiscard]] const VisibleSegment& segment(SegmentId s) const { return segments_.segments[s.index()]; }
  [[nodiscard]] bool opens_within(SegmentId later, SegmentId earlier) const {
    return sides_.before(sides_.upper(segment(later)), sides_.lower(segment(earlier)));
  }

  // Returns the winding number where the sweep line comes from the left to s, just below its upper end.
  [[nodiscard]] int winding_left_of(SegmentId s) const {
    const PointId p = sides_.upper(segment(s));
    const EdgeId along = segment(s).edge;
    int winding = 0;
    for (const SegmentId t : ids_) {
      const VisibleSegment& other = segment(t);
      if (sides_.before(p, sides_.upper(other)) || !sides_.before(p, sides_.lower(other))) continue;
      if (sides_.place_beside(other.edge, p, along) < 0) winding += sides_.runs_down(other) ? 1 : -1;
    }
    return winding;
  }

  const EdgeSides& sides_;
  const VisibleSegments& segments_;
  std::vector<SegmentId> ids_;  // by the point where they open
};

}  // namespace

bool meet_inside(const EdgeSides& sides, const VisibleSegment& s, const VisibleSegment& t) {
  const EdgeId on_s = s.edge;
  const EdgeId on_t = t.edge;
  if (sides.turn(on_s, on_t) == 0) {
    if (sides.side(on_s, sides.upper(t)) != 0) return false;
    return sides.before(sides.upper(s), sides.lower(t)) && sides.before(sides.upper(t), sides.lower(s));
  }
  // Different lines meet once: in a common end, or else nowhere in both.
  if (s.start == t.start || s.start == t.end || s.end == t.start || s.end == t.end) return false;
  return sides.side(on_s, t.start) * sides.side(on_s, t.end) <= 0 &&
         sides.side(on_t, s.start) * sides.side(on_t, s.end) <= 0;
}

void check_surface_layout(const EdgeSides& sides, const VisibleSegments& segments, std::vector<SegmentId> of_surface,
                          std::vector<std::string>& messages) {
  const SurfaceLayout layout(sides, segments, std::move(of_surface));
  layout.check_meetings(messages);
  layout.check_windings(messages);
}

}  // namespace sightline::inline reconstruct
