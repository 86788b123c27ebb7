#include "sweep/bands/openings.h"

#include <algorithm>

#include "geometry/numbers/sort_few.h"
#include "sweep/segments/image_decisions.h"

namespace sightline::inline sweep {
namespace {

class OpeningFinder {
 public:
  OpeningFinder(const ProjectedScene& scene, const Continuation& continuation, const std::vector<Role>& roles,
                const SweepOrder& order, std::span<const Opening> from_bands)
      : scene_(scene), continuation_(continuation), roles_(roles), order_(order), from_bands_(from_bands) {}

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
      const Sign turn = directions_turn(a.segment.edge, b.segment.edge);
      return turn != 0 ? turn > 0 : a.left_of_edge && !b.left_of_edge;
    });
    placed_.insert(placed_.end(), here_.begin(), here_.end());
    here_.clear();
  }

  [[nodiscard]] Sign directions_turn(EdgeId a, EdgeId b) const {
    if (a == b) return 0;
    const auto direction = [this](EdgeId e) {
      return ExactDecisions::direction(scene_.point(scene_.edge(e).top), scene_.point(scene_.edge(e).bottom));
    };
    return ExactDecisions::turn(direction(a), direction(b));
  }

  const ProjectedScene& scene_;
  const Continuation& continuation_;
  const std::vector<Role>& roles_;
  const SweepOrder& order_;
  const std::span<const Opening> from_bands_;
  std::size_t next_swept_ = 0;
  std::size_t next_edge_ = 0;
  std::vector<Opening> here_;  // at the current point
  std::vector<Opening> placed_;
};

}  // namespace

std::vector<Opening> openings_at(const ProjectedScene& scene, const Continuation& continuation,
                                 const std::vector<Role>& roles, const SweepOrder& order,
                                 std::span<const Opening> from_bands, std::size_t begin, std::size_t end) {
  return OpeningFinder(scene, continuation, roles, order, from_bands).find(begin, end);
}

}  // namespace sightline::inline sweep
