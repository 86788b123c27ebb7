#include "reflect/merged_scene.h"

#include <algorithm>

namespace sightline {
namespace {

bool in_sweep_order(const ImagePoint& a, const ImagePoint& b) { return sweeps_before(a, b); }

bool in_edge_order(const ImageLine& a, const ImageLine& b) {
  return a.top != b.top ? sweeps_before(a.top, b.top) : sweeps_before(a.bottom, b.bottom);
}

template <class Item, class Order>
void sort_distinct(std::vector<Item>& items, Order order) {
  std::ranges::sort(items, order);
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

class Merging {
 public:
  Merging(const ProjectedScene& scene, const VisibleSegments& segments, std::span<const BorderPiece> pieces)
      : scene_(scene), segments_(segments), pieces_(pieces) {}

  MergedScene run() {
    merged_.scene = scene_;
    merged_.scene.has_mirrored_lines = true;
    merged_.segments = segments_;
    number_points();
    number_edges();
    number_crossings();
    rename();
    return std::move(merged_);
  }

 private:
  static ImageLine line(const ProjectedScene& scene, EdgeId e) {
    return {scene.point(scene.edge(e).top), scene.point(scene.edge(e).bottom)};
  }

  // The piece's own line, and those that cross at its ends.
  template <class Visit>
  static void for_each_line(const BorderPiece& piece, Visit visit) {
    visit(piece.line);
    for (const ImagePlace& place : {piece.start, piece.end}) {
      if (place.on_grid) continue;
      visit(place.a);
      visit(place.b);
    }
  }

  void number_points() {
    auto& points = merged_.scene.points;
    for (const BorderPiece& piece : pieces_) {
      for_each_line(piece, [&](const ImageLine& l) { points.insert(points.end(), {l.top, l.bottom}); });
      for (const ImagePlace& place : {piece.start, piece.end}) {
        if (place.on_grid) points.push_back(place.at.base);
      }
    }
    sort_distinct(points, in_sweep_order);
  }

  [[nodiscard]] PointId scene_point(const ImagePoint& p) const {
    const auto& points = merged_.scene.points;
    return PointId(static_cast<std::size_t>(std::ranges::lower_bound(points, p, in_sweep_order) - points.begin()));
  }

  // Edges come with the sides that they had.
  void number_edges() {
    for (std::size_t e = 0; e < scene_.edge_count(); ++e) lines_.push_back(line(scene_, EdgeId(e)));
    const std::vector<ImageLine> old = lines_;
    for (const BorderPiece& piece : pieces_) {
      for_each_line(piece, [this](const ImageLine& l) { lines_.push_back(l); });
    }
    sort_distinct(lines_, in_edge_order);
    merged_.scene.edges.clear();
    merged_.scene.sides.clear();
    std::size_t next_old = 0;
    for (const ImageLine& l : lines_) {
      const auto first_side = static_cast<std::uint32_t>(merged_.scene.sides.size());
      merged_.scene.edges.push_back({scene_point(l.top), scene_point(l.bottom), first_side});
      if (next_old == old.size() || old[next_old] != l) continue;
      const auto sides = scene_.sides_of(EdgeId(next_old++));
      merged_.scene.sides.insert(merged_.scene.sides.end(), sides.begin(), sides.end());
    }
    const auto end = static_cast<std::uint32_t>(merged_.scene.sides.size());
    merged_.scene.edges.push_back({PointId{}, PointId{}, end});
  }

  [[nodiscard]] EdgeId edge(const ImageLine& l) const {
    return EdgeId(static_cast<std::size_t>(std::ranges::lower_bound(lines_, l, in_edge_order) - lines_.begin()));
  }

  // A crossing of either origin. Where a scene point is at the same place, that stands for it, and else the crossing that
  // comes first here: of the sweep's own, if it has one.
  struct Candidate {
    CrossingPoint at;
    EdgeId a;
    EdgeId b;
    std::size_t origin = 0;  // an index into the sweep's crossings, and from there on into the pieces' ends
  };

  void number_crossings() {
    std::vector<Candidate> candidates;
    for (std::size_t c = 0; c < segments_.crossings.size(); ++c) {
      const ImageLine a = line(scene_, segments_.crossings[c].a);
      const ImageLine b = line(scene_, segments_.crossings[c].b);
      candidates.push_back({crossing_point(a.top, a.bottom, b.top, b.bottom), edge(a), edge(b), c});
    }
    const std::size_t first_new = candidates.size();
    for (std::size_t i = 0; i < 2 * pieces_.size(); ++i) {
      const ImagePlace& p = i % 2 == 0 ? pieces_[i / 2].start : pieces_[i / 2].end;
      if (!p.on_grid) candidates.push_back({p.at, edge(p.a), edge(p.b), segments_.crossings.size() + i});
    }
    const auto in_order = [](const Candidate& a, const Candidate& b) {
      const int order = sweep_compare(a.at, b.at);
      return order != 0 ? order < 0 : a.origin < b.origin;
    };
    const auto middle = candidates.begin() + static_cast<std::ptrdiff_t>(first_new);
    std::sort(middle, candidates.end(), in_order);
    std::inplace_merge(candidates.begin(), middle, candidates.end(), in_order);
    point_of_.resize(segments_.crossings.size() + 2 * pieces_.size());
    merged_.segments.crossings.clear();
    const Candidate* last = nullptr;
    for (const Candidate& c : candidates) {
      const PointId known = scene_point_at(c.at);
      if (!known.valid() && (last == nullptr || sweep_compare(last->at, c.at) != 0)) {
        merged_.segments.crossings.push_back({c.a, c.b, next_scene_point(c.at)});
        last = &c;
      }
      point_of_[c.origin] =
          known.valid() ? known : PointId(merged_.scene.points.size() + merged_.segments.crossings.size() - 1);
    }
  }

  // The first scene point at or after the crossing in sweep order.
  [[nodiscard]] PointId next_scene_point(const CrossingPoint& at) const {
    const auto& points = merged_.scene.points;
    const auto found =
        std::ranges::partition_point(points, [&](const ImagePoint& p) { return sweep_compare(at, p) > 0; });
    return PointId(static_cast<std::size_t>(found - points.begin()));
  }

  [[nodiscard]] PointId scene_point_at(const CrossingPoint& at) const {
    const PointId next = next_scene_point(at);
    const bool same = next.index() < merged_.scene.points.size() && sweep_compare(at, merged_.scene.point(next)) == 0;
    return same ? next : PointId{};
  }

  [[nodiscard]] PointId renamed(PointId p) const {
    if (p.index() < scene_.points.size()) return scene_point(scene_.point(p));
    return point_of_[p.index() - scene_.points.size()];
  }
  [[nodiscard]] EdgeId renamed(EdgeId e) const { return edge(line(scene_, e)); }

  void rename() {
    for (ClippedCorner& corner : merged_.scene.polygon_corners) corner.point = renamed(corner.point);
    for (VisibleSegment& s : merged_.segments.segments) {
      s.start = renamed(s.start);
      s.end = renamed(s.end);
      s.edge = renamed(s.edge);
    }
    for (Thread& thread : merged_.segments.threads) thread.top = renamed(thread.top);
    for (EdgeSplit& split : merged_.segments.splits) {
      split.edge = renamed(split.edge);
      split.point = renamed(split.point);
    }
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const BorderPiece& piece = pieces_[i];
      merged_.pieces.push_back({end_of(piece.start, 2 * i), end_of(piece.end, 2 * i + 1), edge(piece.line)});
    }
  }

  [[nodiscard]] PointId end_of(const ImagePlace& place, std::size_t end) const {
    return place.on_grid ? scene_point(place.at.base) : point_of_[segments_.crossings.size() + end];
  }

  const ProjectedScene& scene_;
  const VisibleSegments& segments_;
  std::span<const BorderPiece> pieces_;
  std::vector<ImageLine> lines_;   // per edge of the merged scene
  std::vector<PointId> point_of_;  // per crossing of the sweep, then per end of a piece
  MergedScene merged_;
};

}  // namespace

MergedScene merge(const ProjectedScene& scene, const VisibleSegments& segments, std::span<const BorderPiece> pieces) {
  return Merging(scene, segments, pieces).run();
}

}  // namespace sightline
