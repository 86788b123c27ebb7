#include "sweep/bands/joined_segments.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <span>
#include <tuple>
#include <utility>

#include "geometry/numbers/parallel.h"
#include "geometry/numbers/sort_few.h"
#include "sweep/segments/crossing_order.h"
#include "sweep/segments/image_points.h"

namespace sightline::inline sweep {
namespace {

// Crossings of the same edges are one, and need no arithmetic.
void sort_by_place(const ProjectedScene& scene, const std::vector<SwapEdge>& swap_edges,
                   std::vector<Crossing>& crossings) {
  const CrossingOrder order(scene, swap_edges);
  tbb::parallel_sort(crossings.begin(), crossings.end(), [&](const Crossing& x, const Crossing& y) {
    if (x.after != y.after) return x.after < y.after;
    return (x.a != y.a || x.b != y.b) && order.compare(x, y) < 0;
  });
}

// The swap edges that several bands have found stand here once each, by their surfaces, and so in the same order whatever the
// bands are.
class JoinedSwapEdges {
 public:
  // `used` says per band and swap edge of it whether the whole needs it.
  JoinedSwapEdges(const std::vector<VisibleSegments>& bands, const std::vector<std::vector<std::uint8_t>>& used) {
    for (std::size_t band = 0; band < bands.size(); ++band) {
      own_.emplace_back();
      for (std::size_t i = 0; i < bands[band].swap_edges.size(); ++i) {
        const SwapEdge& edge = bands[band].swap_edges[i];
        own_.back().push_back(edge.surfaces);
        if (used[band][i] != 0) all_.push_back(edge);
      }
    }
    std::ranges::sort(all_, {}, &SwapEdge::surfaces);
    const auto same = [](const SwapEdge& a, const SwapEdge& b) { return a.surfaces == b.surfaces; };
    all_.erase(std::unique(all_.begin(), all_.end(), same), all_.end());
  }

  // Returns, per swap edge of the band, its number among all; any number where it is not used.
  [[nodiscard]] std::vector<std::size_t> numbers(std::size_t band) const {
    std::vector<std::size_t> result;
    for (const auto& surfaces : own_[band]) {
      const auto found = std::ranges::lower_bound(all_, surfaces, {}, &SwapEdge::surfaces);
      result.push_back(static_cast<std::size_t>(found - all_.begin()));
    }
    return result;
  }
  [[nodiscard]] const std::vector<SwapEdge>& all() const { return all_; }

 private:
  using Surfaces = std::array<FacetId, 2>;
  std::vector<SwapEdge> all_;
  std::vector<std::vector<Surfaces>> own_;  // per band
};

// The crossings that several bands have found stand here once each, in sweep order, with their names among the whole's
// points. Where several bands name a crossing, they give it the same name (segment_recorder.h).
class JoinedCrossings {
 public:
  JoinedCrossings(const ProjectedScene& scene, const std::vector<SwapEdge>& swap_edges, std::vector<Crossing> crossings)
      : vertices_(scene.points.size()) {
    sort_by_place(scene, swap_edges, crossings);
    for (const Crossing& c : crossings) {
      if (!crossings_.empty() && key_of(crossings_.back()) == key_of(c)) continue;
      index_.emplace_back(key_of(c), crossings_.size());
      crossings_.push_back(c);
    }
    tbb::parallel_sort(index_.begin(), index_.end());
  }

  // Precondition: it is one of them.
  [[nodiscard]] PointId name(const Crossing& crossing) const {
    const auto found = std::ranges::lower_bound(index_, key_of(crossing), {}, &std::pair<Key, std::size_t>::first);
    return PointId(vertices_ + found->second);
  }
  [[nodiscard]] const std::vector<Crossing>& all() const { return crossings_; }

 private:
  using Key = std::tuple<PointId, EdgeId, EdgeId>;
  static Key key_of(const Crossing& c) { return {c.after, c.a, c.b}; }

  std::size_t vertices_;
  std::vector<Crossing> crossings_;
  std::vector<std::pair<Key, std::size_t>> index_;
};

struct Opening {
  VisibleSegment segment;
  BandId band;      // invalid: of a plain facet
  SegmentId swept;  // its number in the band's sweep
  bool left_of_edge = false;

  // Left of its edge a segment runs upwards.
  [[nodiscard]] PointId upper() const { return left_of_edge ? segment.end : segment.start; }
};

// Segments open in the order in which a sweep of the whole would have found them: those of the bands' sweeps, and those
// along the edges of plain facets, which no sweep has found.
class OpeningFinder {
 public:
  OpeningFinder(const ProjectedScene& scene, const Continuation& continuation, const std::vector<Role>& roles,
                const ImagePoints& points, std::span<const Opening> from_bands)
      : scene_(scene),
        continuation_(continuation),
        roles_(roles),
        points_(points),
        order_(points.order()),
        from_bands_(from_bands) {}

  // Returns what opens at points [begin, end), and at crossings before each of them, from left to right. What opens in
  // the bands is given from the first that may open there on, in the order in which it opens; what opens at one point
  // in one band already goes from left to right.
  std::vector<Opening> find(std::size_t begin, std::size_t end) {
    const auto edges = std::span(scene_.edges).first(scene_.edge_count());
    next_edge_ =
        static_cast<std::size_t>(std::ranges::lower_bound(edges, PointId(begin), {}, &SceneEdge::top) - edges.begin());
    for (std::size_t p = begin; p < end; ++p) {
      take_swept_through(PointId(p));
      open_plain_at(PointId(p));
      place_here();
    }
    return std::move(placed_);
  }

 private:
  // Takes what opens before point p, crossing by crossing, and what opens at p.
  void take_swept_through(PointId p) {
    for (; next_swept_ < from_bands_.size(); ++next_swept_) {
      const Opening& opening = from_bands_[next_swept_];
      if (order_(p, opening.upper())) break;
      if (!here_.empty() && here_.front().upper() != opening.upper()) place_here();
      here_.push_back(opening);
    }
    if (!here_.empty() && here_.front().upper() != p) place_here();
  }

  // Edges are sorted by their tops.
  void open_plain_at(PointId p) {
    for (; next_edge_ < scene_.edge_count() && scene_.edges[next_edge_].top == p; ++next_edge_) {
      const EdgeId e(next_edge_);
      if (continuation_.is_contour(e)) continue;
      const auto& [left, right] = continuation_.across(e);
      const PointId bottom = scene_.edge(e).bottom;
      if (is_plain(left)) here_.push_back({{bottom, p, left, right, e}, {}, {}, true});
      if (is_plain(right)) here_.push_back({{p, bottom, right, left, e}, {}, {}, false});
    }
  }

  [[nodiscard]] bool is_plain(FacetId f) const { return roles_[f.index()] == Role::plain; }

  // Openings are placed from left to right; along one edge, what is left of it comes first.
  void place_here() {
    sort_few(std::span(here_), [this](const Opening& a, const Opening& b) {
      const Sign turn = points_.turn(a.segment.edge, b.segment.edge);
      return turn != 0 ? turn > 0 : a.left_of_edge && !b.left_of_edge;
    });
    placed_.insert(placed_.end(), here_.begin(), here_.end());
    here_.clear();
  }

  const ProjectedScene& scene_;
  const Continuation& continuation_;
  const std::vector<Role>& roles_;
  const ImagePoints& points_;
  const SweepOrder& order_;
  const std::span<const Opening> from_bands_;
  std::size_t next_swept_ = 0;
  std::size_t next_edge_ = 0;
  std::vector<Opening> here_;  // at the current point
  std::vector<Opening> placed_;
};

class SegmentJoiner {
 public:
  SegmentJoiner(const SceneInCells& in, const std::vector<Role>& roles, const Bands& bands,
                std::vector<VisibleSegments> swept)
      : scene_(in.scene),
        continuation_(in.continuation),
        roles_(roles),
        bands_(bands),
        swept_(std::move(swept)),
        order_(in.scene, result_) {}

  VisibleSegments join() {
    parallel_for_each(swept_.size(), 1, [this](std::size_t band) { drop_foreign(BandId(band)); });
    join_swap_edges();
    join_crossings();
    collect_splits();
    place_segments(collect_swept());
    take_threads();
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool is_of(FacetId f, BandId band) const { return bands_.band_of[f.index()] == band; }

  // Only what a band's sweep says of its own facets is used.
  void drop_foreign(BandId band) {
    VisibleSegments& swept = swept_[band.index()];
    std::erase_if(swept.threads, [&](const Thread& t) { return !is_of(t.facet, band); });
    std::erase_if(swept.splits, [&](const EdgeSplit& s) { return !is_of(s.facet, band); });
  }

  void join_swap_edges() {
    std::vector<std::vector<std::uint8_t>> used(swept_.size());
    parallel_for_each(swept_.size(), 1, [&](std::size_t band) { used[band] = used_swap_edges(BandId(band)); });
    const JoinedSwapEdges joined(swept_, used);
    result_.swap_edges = joined.all();
    const std::size_t scene_edges = scene_.edge_count();
    parallel_for_each(swept_.size(), 1, [&](std::size_t band) {
      const std::vector<std::size_t> numbers = joined.numbers(band);
      if (numbers.empty()) return;
      const auto rename = [&](EdgeId& e) {
        if (e.index() >= scene_edges) e = EdgeId(scene_edges + numbers[e.index() - scene_edges]);
      };
      for (Crossing& c : swept_[band].crossings) {
        rename(c.a);
        rename(c.b);
      }
      for (VisibleSegment& s : swept_[band].segments) rename(s.edge);
    });
  }

  // Returns, per swap edge of the band's sweep, whether what is used of the band runs along it, or crosses it where it names
  // a point.
  [[nodiscard]] std::vector<std::uint8_t> used_swap_edges(BandId band) {
    const VisibleSegments& swept = swept_[band.index()];
    std::vector<std::uint8_t> used(swept.swap_edges.size(), 0);
    if (used.empty()) return used;
    const auto use = [&](EdgeId e) {
      if (e.index() >= scene_.edge_count()) used[e.index() - scene_.edge_count()] = 1;
    };
    const std::vector<std::uint8_t> crossings = used_crossings(band);
    for (std::size_t c = 0; c < crossings.size(); ++c) {
      if (crossings[c] != 0) use(swept.crossings[c].a);
      if (crossings[c] != 0) use(swept.crossings[c].b);
    }
    for (const VisibleSegment& s : swept.segments) {
      if (is_of(s.facet, band)) use(s.edge);
    }
    return used;
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

  // Returns, per crossing of the band's sweep, whether what is used of the band has it as a point.
  [[nodiscard]] std::vector<std::uint8_t> used_crossings(BandId band) {
    const std::size_t vertices = scene_.points.size();
    std::vector<std::uint8_t> used(swept_[band.index()].crossings.size(), 0);
    for_each_point(band, [&](const PointId& p) {
      if (p.index() >= vertices) used[p.index() - vertices] = 1;
    });
    return used;
  }

  void join_crossings() {
    std::vector<std::vector<std::uint8_t>> used(swept_.size());
    parallel_for_each(swept_.size(), 1, [&](std::size_t band) { used[band] = used_crossings(BandId(band)); });
    std::vector<Crossing> crossings;
    for (std::size_t band = 0; band < swept_.size(); ++band) {
      const auto& own = swept_[band].crossings;
      for (std::size_t i = 0; i < own.size(); ++i) {
        if (used[band][i] != 0) crossings.push_back(own[i]);
      }
    }
    const JoinedCrossings joined(scene_, result_.swap_edges, std::move(crossings));
    parallel_for_each(swept_.size(), 1, [&](std::size_t band) { rename_points(BandId(band), used[band], joined); });
    result_.crossings = joined.all();
  }

  void rename_points(BandId band, const std::vector<std::uint8_t>& used, const JoinedCrossings& joined) {
    const std::size_t vertices = scene_.points.size();
    const auto& own = swept_[band.index()].crossings;
    std::vector<PointId> name(own.size());
    for (std::size_t i = 0; i < own.size(); ++i) {
      if (used[i] != 0) name[i] = joined.name(own[i]);
    }
    for_each_point(band, [&](PointId& p) {
      if (p.index() >= vertices) p = name[p.index() - vertices];
    });
  }

  void collect_splits() {
    auto& splits = result_.splits;
    for (const VisibleSegments& swept : swept_) {
      splits.insert(splits.end(), swept.splits.begin(), swept.splits.end());
      result_.statistics += swept.statistics;
    }
    tbb::parallel_sort(splits.begin(), splits.end());
    splits.erase(std::unique(splits.begin(), splits.end()), splits.end());
  }

  // Openings come in the order in which they open; those of one point by band, and those of one band from left to
  // right.
  [[nodiscard]] std::vector<Opening> collect_swept() {
    std::vector<Opening> all;
    new_name_.resize(swept_.size());
    for (std::size_t band = 0; band < swept_.size(); ++band) {
      const auto& segments = swept_[band].segments;
      new_name_[band].resize(segments.size());
      for (std::size_t s = 0; s < segments.size(); ++s) {
        if (is_of(segments[s].facet, BandId(band)))
          all.push_back({segments[s], BandId(band), SegmentId(s), order_(segments[s].end, segments[s].start)});
      }
    }
    tbb::parallel_sort(all.begin(), all.end(), [this](const Opening& a, const Opening& b) {
      if (a.upper() != b.upper()) return order_(a.upper(), b.upper());
      return a.band != b.band ? a.band < b.band : a.swept < b.swept;
    });
    return all;
  }

  // Points are divided into ranges, and each range is one thread's. Nothing opens below all points.
  void place_segments(const std::vector<Opening>& from_bands) {
    const ImagePoints image(scene_, result_);
    const std::size_t points = scene_.points.size();
    std::vector<std::vector<Opening>> parts(range_count(points));
    parallel_for_ranges(points, [&](std::size_t range, std::size_t begin, std::size_t end) {
      const auto first = begin == 0 ? from_bands.begin()
                                    : std::ranges::upper_bound(from_bands, PointId(begin - 1), order_, &Opening::upper);
      parts[range] = OpeningFinder(scene_, continuation_, roles_, image, {first, from_bands.end()}).find(begin, end);
    });
    std::vector<std::size_t> placed_before{0};
    for (const auto& part : parts) placed_before.push_back(placed_before.back() + part.size());
    result_.segments.resize(placed_before.back());
    parallel_for_each(parts.size(), 1, [&](std::size_t range) { place(parts[range], placed_before[range]); });
  }

  void place(const std::vector<Opening>& openings, std::size_t next) {
    for (const Opening& opening : openings) {
      if (opening.band.valid()) new_name_[opening.band.index()][opening.swept.index()] = SegmentId(next);
      result_.segments[next++] = opening.segment;
    }
  }

  void take_threads() {
    for (std::size_t band = 0; band < swept_.size(); ++band) {
      for (Thread thread : swept_[band].threads) {
        thread.segment = new_name_[band][thread.segment.index()];
        result_.threads.push_back(thread);
      }
    }
    std::ranges::stable_sort(result_.threads, order_, &Thread::top);
  }

  const ProjectedScene& scene_;
  const Continuation& continuation_;
  const std::vector<Role>& roles_;
  const Bands& bands_;
  std::vector<VisibleSegments> swept_;            // per band
  std::vector<std::vector<SegmentId>> new_name_;  // per band and segment of its sweep
  VisibleSegments result_;
  const SweepOrder order_;  // of the result's points
};

}  // namespace

VisibleSegments join_segments(const SceneInCells& in, const std::vector<Role>& roles, const Bands& bands,
                              std::vector<VisibleSegments> swept) {
  return SegmentJoiner(in, roles, bands, std::move(swept)).join();
}

}  // namespace sightline::inline sweep
