#include "sweep/bands/joined_segments.h"

#include <tbb/parallel_sort.h>

#include <algorithm>

#include "geometry/numbers/parallel.h"
#include "sweep/bands/joined_crossings.h"
#include "sweep/bands/openings.h"

namespace sightline::inline sweep {
namespace {

class Joining {
 public:
  Joining(const ProjectedScene& scene, const Continuation& continuation, const std::vector<Role>& roles,
          const Bands& bands, std::vector<VisibleSegments> swept)
      : scene_(scene),
        continuation_(continuation),
        roles_(roles),
        bands_(bands),
        swept_(std::move(swept)),
        order_(scene, result_) {}

  VisibleSegments join() {
    parallel_for_each(swept_.size(), 1, [this](std::size_t band) { drop_foreign(BandId(band)); });
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
    const JoinedCrossings joined(scene_, crossings);
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
    const std::size_t points = scene_.points.size();
    std::vector<std::vector<Opening>> parts(range_count(points));
    parallel_for_ranges(points, [&](std::size_t range, std::size_t begin, std::size_t end) {
      const auto first = begin == 0 ? from_bands.begin()
                                    : std::ranges::upper_bound(from_bands, PointId(begin - 1), order_, &Opening::upper);
      parts[range] = openings_at(scene_, continuation_, roles_, order_, {first, from_bands.end()}, begin, end);
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

VisibleSegments join_segments(const ProjectedScene& scene, const Continuation& continuation,
                              const std::vector<Role>& roles, const Bands& bands, std::vector<VisibleSegments> swept) {
  return Joining(scene, continuation, roles, bands, std::move(swept)).join();
}

}  // namespace sightline::inline sweep
