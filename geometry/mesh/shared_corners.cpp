#include "geometry/mesh/shared_corners.h"

#include <algorithm>
#include <map>

#include "geometry/faces/face_shape.h"

namespace sightline::inline geometry {

namespace {

// A line between two corners (welded) is named by them, the one with the smaller id first.
using Ends = std::array<VertexId, 2>;
using CornersInside = std::map<Ends, std::vector<VertexId>>;  // lexicographically sorted along the line

// A border that touches itself and has fewer corners than this has a spike.
constexpr std::size_t fewest_corners = 5;

class CornerSharer {
 public:
  CornerSharer(PolygonList& outlines, std::span<const Point3> vertices, const Welding& welding)
      : outlines_(outlines), vertices_(vertices), welding_(welding) {}

  void run() {
    for (std::size_t f = 0; f < outlines_.size(); ++f) find_inside(outlines_[f]);
    if (!inside_.empty()) put_in();
  }

 private:
  [[nodiscard]] VertexId welded(VertexId v) const { return welding_.weld[v.index()]; }
  [[nodiscard]] const Point3& position(VertexId v) const { return vertices_[v.index()]; }
  [[nodiscard]] Ends ends(VertexId a, VertexId b) const {
    return {std::min(welded(a), welded(b)), std::max(welded(a), welded(b))};
  }

  [[nodiscard]] bool is_inside(VertexId v, VertexId a, VertexId b) const {
    const auto rank = [this](VertexId u) { return welding_.rank[u.index()]; };
    const auto [low, high] = std::minmax({rank(a), rank(b)});
    return low < rank(v) && rank(v) < high && collinear(position(a), position(v), position(b));
  }

  void find_inside(std::span<const VertexId> outline) {
    const PolygonView polygon{outline, vertices_};
    if (outline.size() < fewest_corners || (is_planar(polygon) && is_convex(polygon))) return;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const VertexId a = outline[i];
      const VertexId b = outline[i + 1 == outline.size() ? 0 : i + 1];
      for (const VertexId v : outline) {
        if (is_inside(v, a, b)) inside_[ends(a, b)].push_back(welded(v));
      }
    }
  }

  void put_in() {
    for (auto& [edge, corners] : inside_) {
      std::ranges::sort(corners, {}, [this](VertexId v) { return welding_.rank[v.index()]; });
      corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    }
    PolygonList result;
    for (std::size_t f = 0; f < outlines_.size(); ++f) result.push_back(with_corners_inside(outlines_[f]));
    outlines_ = std::move(result);
  }

  [[nodiscard]] std::vector<VertexId> with_corners_inside(std::span<const VertexId> outline) const {
    std::vector<VertexId> result;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const VertexId a = outline[i];
      const VertexId b = outline[i + 1 == outline.size() ? 0 : i + 1];
      result.push_back(a);
      const auto found = inside_.find(ends(a, b));
      if (found == inside_.end()) continue;
      const auto& corners = found->second;
      if (welding_.rank[a.index()] < welding_.rank[b.index()]) {
        result.insert(result.end(), corners.begin(), corners.end());
      } else {
        result.insert(result.end(), corners.rbegin(), corners.rend());
      }
    }
    return result;
  }

  PolygonList& outlines_;
  const std::span<const Point3> vertices_;
  const Welding& welding_;
  CornersInside inside_;
};

}  // namespace

void share_corners(PolygonList& outlines, std::span<const Point3> vertices, const Welding& welding) {
  CornerSharer(outlines, vertices, welding).run();
}

}  // namespace sightline::inline geometry
