#include "sweep/joined_segments.h"

#include <algorithm>
#include <tuple>

#include "sweep/crossing_point.h"
#include "sweep/image_decisions.h"

namespace sightline {
namespace {

// A segment where it opens.
struct Opening {
  VisibleSegment segment;
  BandId band;      // invalid: of a plain facet
  SegmentId swept;  // its number in the band's sweep
  bool left_of_edge = false;

  // Left of its edge a segment runs upwards.
  [[nodiscard]] PointId upper() const { return left_of_edge ? segment.end : segment.start; }
};

auto key_of(const Crossing& c) { return std::tuple(c.after, c.a, c.b); }

// The crossings that what is used of all bands has as its points, in sweep order, each once.
class JoinedCrossings {
 public:
  JoinedCrossings(const ProjectedScene& scene, const std::vector<Crossing>& crossings)
      : vertices_(scene.points.size()) {
    std::vector<Placed> placed;
    for (const Crossing& c : crossings) {
      const SceneEdge& a = scene.edge(c.a);
      const SceneEdge& b = scene.edge(c.b);
      placed.push_back(
          {c, crossing_point(scene.point(a.top), scene.point(a.bottom), scene.point(b.top), scene.point(b.bottom))});
    }
    std::ranges::sort(placed, [](const Placed& x, const Placed& y) {
      if (x.crossing.after != y.crossing.after) return x.crossing.after < y.crossing.after;
      return sweep_compare(x.place, y.place) < 0;
    });
    for (const Placed& p : placed) {
      if (!crossings_.empty() && key_of(crossings_.back()) == key_of(p.crossing)) continue;
      index_.emplace_back(key_of(p.crossing), crossings_.size());
      crossings_.push_back(p.crossing);
    }
    std::ranges::sort(index_);
  }

  [[nodiscard]] PointId name(const Crossing& c) const {
    const auto found = std::ranges::lower_bound(index_, key_of(c), {}, &std::pair<Key, std::size_t>::first);
    return PointId(vertices_ + found->second);
  }
  [[nodiscard]] const std::vector<Crossing>& all() const { return crossings_; }

 private:
  using Key = std::tuple<PointId, EdgeId, EdgeId>;
  struct Placed {
    Crossing crossing;
    CrossingPoint place;
  };

  std::size_t vertices_;
  std::vector<Crossing> crossings_;
  std::vector<std::pair<Key, std::size_t>> index_;
};

class Joining {
 public:
  Joining(const ProjectedScene& scene, const Continuation& continuation, const std::vector<Role>& roles,
          const Bands& bands, std::vector<VisibleSegments> swept)
      : scene_(scene), continuation_(continuation), roles_(roles), bands_(bands), swept_(std::move(swept)) {}

  VisibleSegments join() {
    for (std::size_t band = 0; band < swept_.size(); ++band) drop_foreign(BandId(band));
    join_crossings();
    collect_swept();
    for (std::size_t p = 0; p < scene_.points.size(); ++p) {
      take_swept_through(PointId(p));
      open_plain_at(PointId(p));
      place_openings();
    }
    take_swept_through({});
    take_threads();
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool is_of(FacetId f, BandId band) const { return bands_.band_of[f.index()] == band; }

  // What a band's sweep says of other facets than its own is not used.
  void drop_foreign(BandId band) {
    VisibleSegments& swept = swept_[band.index()];
    std::erase_if(swept.threads, [&](const Thread& t) { return !is_of(t.facet, band); });
    std::erase_if(swept.splits, [&](const EdgeSplit& s) { return !is_of(s.facet, band); });
    result_.statistics += swept.statistics;
  }

  template <class Visit>
  void for_each_point(BandId band, Visit visit) {
    for (VisibleSegment& s : swept_[band.index()].segments) {
      if (!is_of(s.facet, band)) continue;
      visit(s.start);
      visit(s.end);
    }
    for (Thread& thread : swept_[band.index()].threads) visit(thread.top);
    for (EdgeSplit& split : swept_[band.index()].splits) visit(split.point);
  }

  void join_crossings() {
    const std::size_t vertices = scene_.points.size();
    std::vector<std::vector<std::uint8_t>> used(swept_.size());
    std::vector<Crossing> crossings;
    for (std::size_t band = 0; band < swept_.size(); ++band) {
      const auto& own = swept_[band].crossings;
      used[band].assign(own.size(), 0);
      for_each_point(BandId(band), [&](const PointId& p) {
        if (p.index() >= vertices) used[band][p.index() - vertices] = 1;
      });
      for (std::size_t i = 0; i < own.size(); ++i) {
        if (used[band][i] != 0) crossings.push_back(own[i]);
      }
    }
    const JoinedCrossings joined(scene_, crossings);
    for (std::size_t band = 0; band < swept_.size(); ++band) {
      const auto& own = swept_[band].crossings;
      std::vector<PointId> name(own.size());
      for (std::size_t i = 0; i < own.size(); ++i) {
        if (used[band][i] != 0) name[i] = joined.name(own[i]);
      }
      for_each_point(BandId(band), [&](PointId& p) {
        if (p.index() >= vertices) p = name[p.index() - vertices];
      });
    }
    result_.crossings = joined.all();
  }

  // In the order in which they open. Those of one point and one band are from left to right already.
  void collect_swept() {
    const SweepOrder order(scene_, result_);
    new_name_.resize(swept_.size());
    for (std::size_t band = 0; band < swept_.size(); ++band) {
      const auto& segments = swept_[band].segments;
      new_name_[band].resize(segments.size());
      const std::size_t begin = from_bands_.size();
      for (std::size_t s = 0; s < segments.size(); ++s) {
        if (is_of(segments[s].facet, BandId(band)))
          from_bands_.push_back({segments[s], BandId(band), SegmentId(s), order(segments[s].end, segments[s].start)});
      }
      std::inplace_merge(from_bands_.begin(), from_bands_.begin() + static_cast<std::ptrdiff_t>(begin),
                         from_bands_.end(),
                         [&](const Opening& a, const Opening& b) { return order(a.upper(), b.upper()); });
      auto& splits = result_.splits;
      splits.insert(splits.end(), swept_[band].splits.begin(), swept_[band].splits.end());
    }
    std::ranges::sort(result_.splits);
    result_.splits.erase(std::unique(result_.splits.begin(), result_.splits.end()), result_.splits.end());
  }

  [[nodiscard]] bool is_plain(FacetId f) const { return roles_[f.index()] == Role::plain; }

  // What opens before point p, crossing by crossing, and what opens at p (invalid: all that is left).
  void take_swept_through(PointId p) {
    const SweepOrder order(scene_, result_);
    for (; next_swept_ < from_bands_.size(); ++next_swept_) {
      const Opening& opening = from_bands_[next_swept_];
      if (p.valid() && order(p, opening.upper())) break;
      if (!openings_.empty() && openings_.front().upper() != opening.upper()) place_openings();
      openings_.push_back(opening);
    }
    if (!openings_.empty() && openings_.front().upper() != p) place_openings();
  }

  // Edges are sorted by their tops.
  void open_plain_at(PointId p) {
    for (; next_edge_ < scene_.edge_count() && scene_.edges[next_edge_].top == p; ++next_edge_) {
      const EdgeId e(next_edge_);
      if (continuation_.is_contour(e)) continue;
      const auto& [left, right] = continuation_.across(e);
      const PointId bottom = scene_.edge(e).bottom;
      if (is_plain(left)) openings_.push_back({{bottom, p, left, right, e}, {}, {}, true});
      if (is_plain(right)) openings_.push_back({{p, bottom, right, left, e}, {}, {}, false});
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
    if (opening.band.valid())
      new_name_[opening.band.index()][opening.swept.index()] = SegmentId(result_.segments.size());
    result_.segments.push_back(opening.segment);
  }

  void take_threads() {
    for (std::size_t band = 0; band < swept_.size(); ++band) {
      for (Thread thread : swept_[band].threads) {
        thread.segment = new_name_[band][thread.segment.index()];
        result_.threads.push_back(thread);
      }
    }
    const SweepOrder order(scene_, result_);
    std::ranges::stable_sort(result_.threads, order, &Thread::top);
  }

  const ProjectedScene& scene_;
  const Continuation& continuation_;
  const std::vector<Role>& roles_;
  const Bands& bands_;
  std::vector<VisibleSegments> swept_;            // per band
  std::vector<std::vector<SegmentId>> new_name_;  // per band and segment of its sweep
  std::vector<Opening> from_bands_;               // in the order in which they open
  std::vector<Opening> openings_;                 // at the current point
  std::size_t next_swept_ = 0;
  std::size_t next_edge_ = 0;
  VisibleSegments result_;
};

}  // namespace

VisibleSegments join_segments(const ProjectedScene& scene, const Continuation& continuation,
                              const std::vector<Role>& roles, const Bands& bands, std::vector<VisibleSegments> swept) {
  return Joining(scene, continuation, roles, bands, std::move(swept)).join();
}

}  // namespace sightline
