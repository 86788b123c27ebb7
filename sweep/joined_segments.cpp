#include "sweep/joined_segments.h"

#include <algorithm>

#include "geometry/errors.h"
#include "sweep/image_decisions.h"

namespace sightline {
namespace {

enum class Seen : std::uint8_t { unknown, no, yes };

// Left of its edge a segment runs upwards.
bool is_left_of_edge(const VisibleSegment& segment, const SweepOrder& order) {
  return order(segment.end, segment.start);
}

// A segment where it opens.
struct Opening {
  VisibleSegment segment;
  SegmentId swept;  // its number in the part's sweep; invalid: of a patch
  bool left_of_edge = false;
};

class Joining {
 public:
  Joining(const ProjectedScene& scene, const Continuation& continuation, const Patches& patches,
          const VisibleSegments& swept)
      : scene_(scene), continuation_(continuation), patches_(patches), swept_(swept), order_(scene, swept) {}

  VisibleSegments join() {
    find_seen_patches();
    new_name_.resize(swept_.segments.size());
    for (std::size_t p = 0; p < scene_.points.size(); ++p) {
      take_swept_through(PointId(p));
      open_patches_at(PointId(p));
      place_openings();
    }
    take_swept_through({});
    take_threads_and_splits();
    drop_unused_crossings();
    result_.statistics = swept_.statistics;
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool is_open(FacetId f) const { return patches_.role[f.index()] == Role::open; }

  // An open facet that is seen along its edge with a facet of a patch shows that all of the patch is seen.
  void find_seen_patches() {
    std::vector<std::uint8_t> seen_left(scene_.edge_count(), 0);
    std::vector<std::uint8_t> seen_right(scene_.edge_count(), 0);
    for (const VisibleSegment& s : swept_.segments) {
      if (is_open(s.facet)) (is_left_of_edge(s, order_) ? seen_left : seen_right)[s.edge.index()] = 1;
    }
    seen_.assign(patches_.patch_count, Seen::unknown);
    for (std::size_t e = 0; e < scene_.edge_count(); ++e) {
      if (continuation_.is_contour(EdgeId(e))) continue;
      const Neighbours& across = continuation_.across(EdgeId(e));
      if (is_open(across.left)) note(across.right, seen_left[e] != 0);
      if (is_open(across.right)) note(across.left, seen_right[e] != 0);
    }
  }

  void note(FacetId facet, bool seen) {
    const PatchId patch = patches_.patch_of[facet.index()];
    if (!patch.valid()) return;
    Seen& known = seen_[patch.index()];
    if (known != Seen::unknown && (known == Seen::yes) != seen) {
      throw InternalError("the patch of facet " + std::to_string(facet.value) + " is seen in part");
    }
    known = seen ? Seen::yes : Seen::no;
  }

  [[nodiscard]] bool is_seen_patch(FacetId f) const {
    const PatchId patch = patches_.patch_of[f.index()];
    return patch.valid() && seen_[patch.index()] == Seen::yes;
  }

  // What the part's sweep opened before point p, and at p (invalid: all that is left). That of other facets than open
  // ones is not used.
  void take_swept_through(PointId p) {
    for (; next_swept_ < swept_.segments.size(); ++next_swept_) {
      const VisibleSegment& s = swept_.segments[next_swept_];
      const bool left = is_left_of_edge(s, order_);
      const PointId upper = left ? s.end : s.start;
      if (p.valid() && order_(p, upper)) return;
      if (!is_open(s.facet)) continue;
      if (upper != p) place({s, SegmentId(next_swept_), left});
      if (upper == p) openings_.push_back({s, SegmentId(next_swept_), left});
    }
  }

  // Edges are sorted by their tops.
  void open_patches_at(PointId p) {
    for (; next_edge_ < scene_.edge_count() && scene_.edges[next_edge_].top == p; ++next_edge_) {
      const EdgeId e(next_edge_);
      if (continuation_.is_contour(e)) continue;
      const auto& [left, right] = continuation_.across(e);
      const PointId bottom = scene_.edge(e).bottom;
      if (is_seen_patch(left)) openings_.push_back({{bottom, p, left, right, e}, {}, true});
      if (is_seen_patch(right)) openings_.push_back({{p, bottom, right, left, e}, {}, false});
    }
  }

  // From left to right; along one edge first what is left of it.
  void place_openings() {
    std::stable_sort(openings_.begin(), openings_.end(), [this](const Opening& a, const Opening& b) {
      const Sign turn = directions_turn(a.segment.edge, b.segment.edge);
      return turn != 0 ? turn > 0 : a.left_of_edge && !b.left_of_edge;
    });
    for (const Opening& opening : openings_) place(opening);
    openings_.clear();
  }

  [[nodiscard]] Sign directions_turn(EdgeId a, EdgeId b) const {
    if (a == b) return 0;
    const auto direction = [this](EdgeId e) {
      return ExactDecisions::direction(scene_.point(scene_.edge(e).top), scene_.point(scene_.edge(e).bottom));
    };
    return ExactDecisions::turn(direction(a), direction(b));
  }

  void place(const Opening& opening) {
    if (opening.swept.valid()) new_name_[opening.swept.index()] = SegmentId(result_.segments.size());
    result_.segments.push_back(opening.segment);
  }

  void take_threads_and_splits() {
    for (Thread thread : swept_.threads) {
      if (!is_open(thread.facet)) continue;
      thread.segment = new_name_[thread.segment.index()];
      result_.threads.push_back(thread);
    }
    for (const EdgeSplit& split : swept_.splits) {
      if (is_open(split.facet)) result_.splits.push_back(split);
    }
  }

  template <class Visit>
  void for_each_point(Visit visit) {
    for (VisibleSegment& s : result_.segments) {
      visit(s.start);
      visit(s.end);
    }
    for (EdgeSplit& split : result_.splits) visit(split.point);
  }

  // Some are of what other facets than open ones seemed to show.
  void drop_unused_crossings() {
    const std::size_t vertices = scene_.points.size();
    std::vector<PointId> name(swept_.crossings.size());
    for_each_point([&](const PointId& p) {
      if (p.index() >= vertices) name[p.index() - vertices] = p;
    });
    for (std::size_t i = 0; i < name.size(); ++i) {
      if (!name[i].valid()) continue;
      name[i] = PointId(vertices + result_.crossings.size());
      result_.crossings.push_back(swept_.crossings[i]);
    }
    for_each_point([&](PointId& p) {
      if (p.index() >= vertices) p = name[p.index() - vertices];
    });
  }

  const ProjectedScene& scene_;
  const Continuation& continuation_;
  const Patches& patches_;
  const VisibleSegments& swept_;
  const SweepOrder order_;
  std::vector<Seen> seen_;           // per patch
  std::vector<SegmentId> new_name_;  // per segment of the part's sweep
  std::vector<Opening> openings_;    // at the current point
  std::size_t next_swept_ = 0;
  std::size_t next_edge_ = 0;
  VisibleSegments result_;
};

}  // namespace

VisibleSegments join_segments(const ProjectedScene& scene, const Continuation& continuation, const Patches& patches,
                              const VisibleSegments& swept) {
  return Joining(scene, continuation, patches, swept).join();
}

}  // namespace sightline
