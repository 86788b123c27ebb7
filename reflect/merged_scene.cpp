#include "reflect/merged_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <memory>

#include "geometry/numbers/partition_index.h"

namespace sightline::inline reflect {
namespace {

template <class Item, class Order>
void sort_distinct(std::vector<Item>& items, Order order) {
  std::ranges::sort(items, order);
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

// Merges two lists, each sorted and distinct. Calls take(is_old, is_new) for each item of it, in order: which of the
// lists have it at their head.
template <class Compare, class Take>
void for_each_merged(std::size_t old_count, std::size_t new_count, Compare compare, Take take) {
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < old_count || j < new_count) {
    const int order = i == old_count ? 1 : j == new_count ? -1 : compare(i, j);
    take(order <= 0, order >= 0);
    i += order <= 0 ? 1 : 0;
    j += order >= 0 ? 1 : 0;
  }
}

// Ids of points follow the sweep order, so they order edges.
using EdgeEnds = std::array<PointId, 2>;

class SceneMerger {
 public:
  // The image is null on the grid; else it is that of the scene and the segments, and does not change with them.
  SceneMerger(ProjectedScene scene, VisibleSegments segments, std::span<const BorderSegment> border,
              const ImagePoints* image)
      : merged_{std::move(scene), std::move(segments), {}}, border_(border), image_(image) {}

  MergedScene run() {
    if (border_.empty()) return std::move(merged_);
    merged_.scene.has_mirrored_lines = true;
    std::swap(old_.points, merged_.scene.points);
    std::swap(old_.unrounded, merged_.scene.unrounded);
    std::swap(old_.edges, merged_.scene.edges);
    std::swap(old_.sides, merged_.scene.sides);
    std::swap(old_crossings_, merged_.segments.crossings);
    number_points();
    number_edges();
    number_crossings();
    rename();
    return std::move(merged_);
  }

 private:
  // The lines on the grid are the segment's own, and those that cross at its ends.
  template <class Visit>
  static void for_each_line(const BorderSegment& segment, Visit visit) {
    if (segment.line.image == nullptr) visit(segment.line);
    for (const ImagePlace& place : {segment.start, segment.end}) {
      if (!is_crossing(place)) continue;
      if (place.a.image == nullptr) visit(place.a);
      if (place.b.image == nullptr) visit(place.b);
    }
  }

  // Returns whether the place is known by the lines that cross there, and not by a number or as a grid point.
  [[nodiscard]] static bool is_crossing(const ImagePlace& place) { return !place.on_grid && place.image == nullptr; }

  void number_points() {
    std::vector<ImagePoint> found;
    for (const BorderSegment& segment : border_) {
      for_each_line(segment, [&](const ImageLine& l) { found.insert(found.end(), {l.top, l.bottom}); });
      for (const ImagePlace& place : {segment.start, segment.end}) {
        if (place.on_grid) found.push_back(place.at.base);
      }
    }
    sort_distinct(found, [](const ImagePoint& a, const ImagePoint& b) { return sweeps_before(a, b); });
    const auto compare = [&](std::size_t i, std::size_t j) { return compare_old(PointId(i), found[j]); };
    std::vector<ExactPlace> made;
    for_each_merged(old_.points.size(), found.size(), compare, [&](bool is_old, bool is_new) {
      if (is_new) point_of_found_.emplace_back(merged_.scene.points.size());
      if (is_old) {
        add_old_point();
      } else {
        add_found_point(found[point_of_found_.size() - 1], made);
      }
    });
    found_ = std::move(found);
    if (image_ != nullptr) merged_.scene.unrounded.made = with_more(*old_.unrounded.made, std::move(made));
  }

  [[nodiscard]] int compare_old(PointId old, const ImagePoint& found) const {
    if (image_ != nullptr) return sweep_compare(image_place(*image_, old), grid_place(found));
    const ImagePoint& p = old_.point(old);
    return p == found ? 0 : sweeps_before(p, found) ? -1 : 1;
  }

  void add_old_point() {
    const std::size_t old = point_of_old_.size();
    point_of_old_.emplace_back(merged_.scene.points.size());
    merged_.scene.points.push_back(old_.points[old]);
    if (image_ == nullptr) return;
    old_of_point_.emplace_back(old);
    merged_.scene.unrounded.places.push_back(old_.unrounded.places[old]);
    merged_.scene.unrounded.sources.push_back(old_.unrounded.sources[old]);
  }

  void add_found_point(const ImagePoint& found, std::vector<ExactPlace>& made) {
    const int bits = merged_.scene.grid_bits;
    merged_.scene.points.push_back(found);
    if (image_ == nullptr) return;
    old_of_point_.emplace_back();
    const auto window = [bits](std::int64_t c) { return std::ldexp(static_cast<double>(c), -bits); };
    merged_.scene.unrounded.places.push_back({window(found.x), window(found.y), 0});
    merged_.scene.unrounded.sources.push_back({{}, MadeCornerId(old_.unrounded.made->size() + made.size())});
    made.push_back({found.x, found.y, BigInteger(1) << static_cast<unsigned>(bits)});
  }

  [[nodiscard]] static std::shared_ptr<const std::vector<ExactPlace>> with_more(std::vector<ExactPlace> places,
                                                                                std::vector<ExactPlace> more) {
    std::ranges::move(more, std::back_inserter(places));
    return std::make_shared<const std::vector<ExactPlace>>(std::move(places));
  }

  // Precondition: it is a grid point of the border.
  [[nodiscard]] PointId scene_point(const ImagePoint& p) const {
    const auto found = std::ranges::partition_point(found_, [&](const ImagePoint& q) { return sweeps_before(q, p); });
    return point_of_found_[static_cast<std::size_t>(found - found_.begin())];
  }

  [[nodiscard]] EdgeEnds ends_of(const ImageLine& l) const { return {scene_point(l.top), scene_point(l.bottom)}; }
  [[nodiscard]] EdgeEnds ends_of_old(EdgeId e) const {
    return {point_of_old_[old_.edge(e).top.index()], point_of_old_[old_.edge(e).bottom.index()]};
  }

  // Edges come with the sides that they had.
  void number_edges() {
    std::vector<EdgeEnds> found;
    for (const BorderSegment& segment : border_) {
      for_each_line(segment, [&](const ImageLine& l) { found.push_back(ends_of(l)); });
    }
    sort_distinct(found, std::less<>());
    auto& edges = merged_.scene.edges;
    std::size_t next_found = 0;
    const auto compare = [&](std::size_t i, std::size_t j) {
      const EdgeEnds old = ends_of_old(EdgeId(i));
      return old == found[j] ? 0 : old < found[j] ? -1 : 1;
    };
    for_each_merged(old_.edge_count(), found.size(), compare, [&](bool is_old, bool is_new) {
      const EdgeEnds ends = is_old ? ends_of_old(EdgeId(edge_of_old_.size())) : found[next_found];
      if (is_old) {
        add_edge(ends, old_.sides_of(EdgeId(edge_of_old_.size())));
        edge_of_old_.emplace_back(edges.size() - 1);
      } else {
        add_edge(ends, {});
      }
      if (is_new) ++next_found;
    });
    add_edge({}, {});
  }

  void add_edge(const EdgeEnds& ends, std::span<const EdgeSide> sides) {
    auto& all = merged_.scene.sides;
    merged_.scene.edges.push_back({ends[0], ends[1], static_cast<std::uint32_t>(all.size())});
    all.insert(all.end(), sides.begin(), sides.end());
  }

  // Swap edges still follow those of the scene.
  [[nodiscard]] EdgeId edge_of_old(EdgeId e) const {
    const std::size_t old = edge_of_old_.size();
    return e.index() < old ? edge_of_old_[e.index()] : EdgeId(merged_.scene.edge_count() + e.index() - old);
  }
  [[nodiscard]] EdgeId edge(const ImageLine& l) const {
    if (l.image != nullptr) return edge_of_old(l.edge);
    const EdgeEnds ends = ends_of(l);
    const auto real = std::span(merged_.scene.edges).first(merged_.scene.edge_count());
    const auto before = [&](const SceneEdge& e) { return EdgeEnds{e.top, e.bottom} < ends; };
    return EdgeId(static_cast<std::size_t>(std::ranges::partition_point(real, before) - real.begin()));
  }

  // A segment of the border ends here in a crossing.
  struct BorderEnd {
    const ImagePlace* at = nullptr;
    std::size_t number = 0;  // 2 i for the start of segment i, 2 i + 1 for its end
  };

  [[nodiscard]] std::vector<BorderEnd> crossing_ends() const {
    std::vector<BorderEnd> ends;
    for (std::size_t i = 0; i < 2 * border_.size(); ++i) {
      const ImagePlace& p = i % 2 == 0 ? border_[i / 2].start : border_[i / 2].end;
      if (is_crossing(p)) ends.push_back({&p, i});
    }
    std::sort(ends.begin(), ends.end(), [](const BorderEnd& a, const BorderEnd& b) {
      const int order = sweep_compare(*a.at, *b.at);
      return order != 0 ? order < 0 : a.number < b.number;
    });
    return ends;
  }

  // Crossings are numbered in sweep order. Of those at the same place the sweep's own comes first, if there is one, and
  // stands for all.
  void number_crossings() {
    point_of_.resize(old_crossings_.size() + 2 * border_.size());
    std::size_t next_old = 0;
    const auto add_old_up_to = [&](std::size_t end) {
      for (; next_old < end; ++next_old) point_of_[next_old] = number_of_old(next_old);
    };
    for (const BorderEnd& end : crossing_ends()) {
      add_old_up_to(first_old_after(*end.at, next_old));
      point_of_[old_crossings_.size() + end.number] = number_of(end);
    }
    add_old_up_to(old_crossings_.size());
  }

  [[nodiscard]] std::size_t first_old_after(const ImagePlace& at, std::size_t from) const {
    const auto is_not_after = [&](std::size_t old) { return sweep_compare(place_of_old(old), at) <= 0; };
    return partition_index(from, old_crossings_.size(), is_not_after);
  }

  [[nodiscard]] ImagePlace place_of_old(std::size_t crossing) const {
    if (image_ != nullptr) return image_place(*image_, PointId(old_.points.size() + crossing));
    const auto line = [this](EdgeId e) {
      return ImageLine{old_.point(old_.edge(e).top), old_.point(old_.edge(e).bottom), nullptr, {}};
    };
    return crossing_place(line(old_crossings_[crossing].a), line(old_crossings_[crossing].b));
  }

  // Only points that are new since can be between the crossing and the points that it was between.
  PointId number_of_old(std::size_t crossing) {
    const Crossing& old = old_crossings_[crossing];
    const std::size_t after = old.after.index();
    const std::size_t first = after == 0 ? 0 : point_of_old_[after - 1].index() + 1;
    const std::size_t end = after == point_of_old_.size() ? merged_.scene.points.size() : point_of_old_[after].index();
    const Crossing renamed{edge_of_old(old.a), edge_of_old(old.b), PointId(end)};
    const PointId id =
        first == end ? added(renamed) : scene_point_or_added(renamed, place_of_old(crossing), first, end);
    if (is_crossing(id)) last_place_ = [this, crossing] { return place_of_old(crossing); };
    return id;
  }

  PointId number_of(const BorderEnd& end) {
    if (last_place_ && sweep_compare(last_place_(), *end.at) == 0) return last_crossing();
    const Crossing crossing{edge(end.at->a), edge(end.at->b), PointId{}};
    const PointId id = scene_point_or_added(crossing, *end.at, 0, merged_.scene.points.size());
    if (is_crossing(id)) last_place_ = [at = end.at] { return *at; };
    return id;
  }

  // Returns the scene point that is there, else the crossing. Of the scene points that come at or after it, the first
  // is in [first, end) or is `end`.
  PointId scene_point_or_added(Crossing crossing, const ImagePlace& at, std::size_t first, std::size_t end) {
    crossing.after = PointId(partition_index(first, end, [&](std::size_t p) { return compare(at, PointId(p)) > 0; }));
    return crossing.after.index() != end && compare(at, crossing.after) == 0 ? crossing.after : added(crossing);
  }

  // Compares with a point of the merged scene.
  [[nodiscard]] int compare(const ImagePlace& at, PointId p) const {
    if (image_ == nullptr) return sweep_compare(at.at, merged_.scene.point(p));
    const PointId old = old_of_point_[p.index()];
    return sweep_compare(at, old.valid() ? image_place(*image_, old) : grid_place(merged_.scene.point(p)));
  }

  PointId added(const Crossing& crossing) {
    merged_.segments.crossings.push_back(crossing);
    return last_crossing();
  }
  [[nodiscard]] bool is_crossing(PointId p) const { return p.index() >= merged_.scene.points.size(); }
  [[nodiscard]] PointId last_crossing() const {
    return PointId(merged_.scene.points.size() + merged_.segments.crossings.size() - 1);
  }

  [[nodiscard]] PointId renamed(PointId p) const {
    if (p.index() < old_.points.size()) return point_of_old_[p.index()];
    return point_of_[p.index() - old_.points.size()];
  }

  void rename() {
    for (ClippedCorner& corner : merged_.scene.polygon_corners) corner.point = renamed(corner.point);
    for (VisibleSegment& s : merged_.segments.segments) {
      s.start = renamed(s.start);
      s.end = renamed(s.end);
      s.edge = edge_of_old(s.edge);
    }
    for (Thread& thread : merged_.segments.threads) thread.top = renamed(thread.top);
    for (EdgeSplit& split : merged_.segments.splits) {
      split.edge = edge_of_old(split.edge);
      split.point = renamed(split.point);
    }
    for (std::size_t i = 0; i < border_.size(); ++i) {
      const BorderSegment& segment = border_[i];
      merged_.border.push_back({end_of(segment.start, 2 * i), end_of(segment.end, 2 * i + 1), edge(segment.line)});
    }
  }

  [[nodiscard]] PointId end_of(const ImagePlace& place, std::size_t end) const {
    if (place.image != nullptr) return renamed(place.point);
    return place.on_grid ? scene_point(place.at.base) : point_of_[old_crossings_.size() + end];
  }

  MergedScene merged_;
  std::span<const BorderSegment> border_;
  const ImagePoints* const image_;
  ProjectedScene old_;  // only the points, the edges and their sides, as they were numbered
  std::vector<Crossing> old_crossings_;
  std::vector<ImagePoint> found_;           // the grid points of the border, in sweep order
  std::vector<PointId> point_of_found_;     // per such point
  std::vector<PointId> old_of_point_;       // per point; invalid where it is new; empty on the grid
  std::function<ImagePlace()> last_place_;  // of the crossing that was added last
  std::vector<PointId> point_of_old_;       // per point of the scene
  std::vector<EdgeId> edge_of_old_;         // per edge of the scene
  std::vector<PointId> point_of_;           // per crossing of the sweep, then per end of a segment of the border
};

}  // namespace

MergedScene merge(ProjectedScene scene, VisibleSegments segments, std::span<const BorderSegment> border) {
  return SceneMerger(std::move(scene), std::move(segments), border, nullptr).run();
}

MergedScene merge(const ImagePoints& image, std::span<const BorderSegment> border) {
  return SceneMerger(image.scene(), image.segments(), border, &image).run();
}

}  // namespace sightline::inline reflect
