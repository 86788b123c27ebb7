#include "peers/painters/depth_sort.h"

#include <algorithm>
#include <iterator>
#include <optional>

#include "peers/scene/newell_tests.h"

namespace sightline::peers {
namespace {

using SurfaceId = Id<struct SurfaceTag>;
using SurfaceList = std::vector<SurfaceId>;

struct TestCounts {
  std::uint64_t pairs = 0;
  std::uint64_t given_to_2 = 0;
  std::uint64_t given_to_3 = 0;
  std::uint64_t given_to_4 = 0;
  std::uint64_t given_to_5 = 0;
  std::uint64_t given_to_3_and_4_reversed = 0;
};

class DepthSort {
 public:
  DepthSort(const FlatScene& scene, Splitting splitting) : splitting_(splitting) {
    for (const FlatPolygon& polygon : scene.polygons) list_.push_back(new_surface(polygon));
    std::sort(list_.begin(), list_.end(), [this](SurfaceId a, SurfaceId b) { return is_earlier(a, b); });
  }

  DepthSorted run() {
    while (!moved_.empty() || !list_.empty()) {
      const SurfaceId p = moved_.empty() ? list_.back() : moved_.back();
      if (const auto q = obstacle_of(p)) {
        resolve(p, *q);
      } else {
        paint(p);
      }
    }
    write_counts();
    return std::move(result_);
  }

 private:
  [[nodiscard]] const Surface& surface(SurfaceId id) const { return surfaces_[id.index()]; }
  [[nodiscard]] bool has_moved(SurfaceId id) const {
    return std::find(moved_.begin(), moved_.end(), id) != moved_.end();
  }

  SurfaceId new_surface(const FlatPolygon& polygon) {
    const Extent extent = extent_of(polygon.corners);
    surfaces_.push_back({polygon, extent});
    return SurfaceId(surfaces_.size() - 1);
  }

  // Returns whether a comes earlier in the list, whose end is painted first. At one depth the order is that of polygons
  // in one plane.
  [[nodiscard]] bool is_earlier(SurfaceId a, SurfaceId b) const {
    const double depth_a = surface(a).extent.most.depth;
    const double depth_b = surface(b).extent.most.depth;
    if (depth_a != depth_b) return depth_a < depth_b;
    if (is_in_front_in_plane(surface(a).polygon, surface(b).polygon)) return true;
    if (is_in_front_in_plane(surface(b).polygon, surface(a).polygon)) return false;
    return a < b;
  }

  [[nodiscard]] SurfaceList::iterator place_in_list(SurfaceId id) {
    return std::lower_bound(list_.begin(), list_.end(), id,
                            [this](SurfaceId a, SurfaceId b) { return is_earlier(a, b); });
  }

  void remove(SurfaceId id) {
    if (!has_moved(id)) {
      list_.erase(place_in_list(id));
    } else {
      moved_.erase(std::find(moved_.begin(), moved_.end(), id));
    }
  }

  // Returns the first Q for which all five tests fail.
  [[nodiscard]] std::optional<SurfaceId> obstacle_of(SurfaceId p) {
    const auto is_obstacle = [&](SurfaceId q) {
      return q != p && !is_nearer_throughout(surface(q), surface(p)) && !may_be_painted_first(surface(p), surface(q));
    };
    const auto moved = std::find_if(moved_.begin(), moved_.end(), is_obstacle);
    if (moved != moved_.end()) return *moved;
    const auto overlapping = std::partition_point(
        list_.begin(), list_.end(), [&](SurfaceId q) { return is_nearer_throughout(surface(q), surface(p)); });
    const auto listed = std::find_if(list_.rbegin(), std::make_reverse_iterator(overlapping), is_obstacle);
    if (listed != std::make_reverse_iterator(overlapping)) return *listed;
    return std::nullopt;
  }

  bool may_be_painted_first(const Surface& p, const Surface& q) {
    ++tests_.pairs;
    if (x_extents_apart(p, q)) return true;
    ++tests_.given_to_2;
    if (y_extents_apart(p, q)) return true;
    ++tests_.given_to_3;
    if (is_behind(p, q)) return true;
    ++tests_.given_to_4;
    if (is_before(q, p)) return true;
    ++tests_.given_to_5;
    return images_apart(p, q);
  }

  // These are tests 3' and 4'.
  bool may_be_reversed(const Surface& p, const Surface& q) {
    ++tests_.given_to_3_and_4_reversed;
    return is_behind(q, p) || is_before(p, q);
  }

  void resolve(SurfaceId p, SurfaceId q) {
    if (!has_moved(q) && may_be_reversed(surface(p), surface(q))) return move_to_end(p, q);
    if (splitting_ == Splitting::where_needed && split_one_of(cycle_of(p, q))) return;
    ++result_.unresolved;
    paint(p);
  }

  void move_to_end(SurfaceId p, SurfaceId q) {
    ++result_.moves;
    remove(q);
    if (moved_.empty()) {
      remove(p);
      moved_.push_back(p);
    }
    moved_.push_back(q);
  }

  // Each is to be painted before the next one, and the last one, P, before the first.
  [[nodiscard]] SurfaceList cycle_of(SurfaceId p, SurfaceId q) const {
    if (!has_moved(q)) return {q, p};
    return {std::find(moved_.begin(), moved_.end(), q), moved_.end()};
  }

  // P is split by Q's plane where that cuts it.
  bool split_one_of(const SurfaceList& cycle) {
    for (auto cut = cycle.rbegin(); cut != cycle.rend(); ++cut) {
      for (const SurfaceId by : cycle) {
        const DepthPlane& plane = surface(by).polygon.plane;
        if (side_of(surface(*cut).polygon, plane) != Side::across) continue;
        replace_by_parts(*cut, split(surface(*cut).polygon, plane));
        return true;
      }
    }
    return false;
  }

  void replace_by_parts(SurfaceId id, const Halves& parts) {
    ++result_.splits;
    remove(id);
    moved_.push_back(new_surface(parts.nearer));
    moved_.push_back(new_surface(parts.farther));
    for (const SurfaceId moved : moved_) list_.insert(place_in_list(moved), moved);
    moved_.clear();
  }

  void paint(SurfaceId p) {
    remove(p);
    result_.polygons.push_back(surface(p).polygon);
  }

  void write_counts() {
    result_.counts = {{"pairs tested", tests_.pairs},
                      {"pairs that came to test 2", tests_.given_to_2},
                      {"pairs that came to test 3", tests_.given_to_3},
                      {"pairs that came to test 4", tests_.given_to_4},
                      {"pairs that came to test 5", tests_.given_to_5},
                      {"pairs that came to tests 3' and 4'", tests_.given_to_3_and_4_reversed},
                      {"surfaces moved", result_.moves},
                      {"splits", result_.splits},
                      {"cycles that no plane cuts", result_.unresolved},
                      {"polygons painted", result_.polygons.size()}};
  }

  Splitting splitting_;
  std::vector<Surface> surfaces_;
  SurfaceList list_;
  SurfaceList moved_;
  TestCounts tests_;
  DepthSorted result_;
};

}  // namespace

DepthSorted sort_by_depth(const FlatScene& scene, Splitting splitting) { return DepthSort(scene, splitting).run(); }

Peer depth_sort() {
  return {"depth-sort",
          "Depth sort (painter's algorithm)",
          "Slides 001, depth-sort algorithm",
          ComputedAt::image_precision,
          "Sorts the polygons by their farthest depth and paints them over one another, the farthest first. Before one "
          "is painted, five tests, cheap ones first, ask of every other one whose depths overlap its own whether the "
          "order is right. Where none says so, the two change places; where that was done before, they lie around each "
          "other in a cycle, and one is split by the plane of another.",
          "The order is computed in doubles with a tolerance, without which every mesh would be split along its own "
          "edges: of surfaces nearer to each other in depth than about 10^-12 the wrong one may come out in front. "
          "What is painted is as coarse as the pixels: a centre decides for the whole pixel. And the tests take their "
          "time: where many depths overlap, every polygon is tested against every other one.",
          [](const FlatScene& scene, int resolution) {
            DepthSorted sorted = sort_by_depth(scene);
            Painting painting = paint(sorted.polygons, resolution);
            sorted.counts.push_back({"pixels painted", painting.pixels_painted});
            return Outcome{std::move(painting.buffer), std::move(sorted.counts)};
          }};
}

}  // namespace sightline::peers
