#include "sweep/segments/unrounded_image.h"

#include <algorithm>

#include "geometry/mesh/facet_plane.h"
#include "geometry/projection/unrounded_points.h"

namespace sightline::inline sweep {
namespace {

std::uint64_t key(std::uint32_t a, std::uint32_t b) { return std::uint64_t{a} << 32 | b; }

// Two edges cross once, whichever is named first.
std::uint64_t key(const UnroundedImage::Place& place) {
  const auto [first, second] = std::minmax(place.a.value, place.b.value);
  return key(first, second);
}

}  // namespace

UnroundedImage::UnroundedImage(const ProjectedScene& scene, const std::vector<SwapEdge>& swap_edges)
    : scene_(scene),
      edge_count_(scene.edge_count()),
      swap_edges_(swap_edges),
      space_(scene, swap_edges),
      memory_(std::make_unique<Memory>(scene)) {}

void UnroundedImage::expect_many_questions() {
  directions_.reserve(edge_count_);
  for (std::size_t e = 0; e < edge_count_; ++e) directions_.push_back(computed_direction(EdgeId(e)));
}

UnroundedImage::Way UnroundedImage::computed_direction(EdgeId e) const {
  if (is_swap_edge(e)) return {swap_edge(e).b, -swap_edge(e).a, swap_edge(e).radius};
  return way(top(e), certified(edge(e).bottom));
}

Sign UnroundedImage::side(EdgeId e, const Place& place, const CertifiedPlace& filtered) const {
  if (place.a == e || place.b == e) return 0;
  if (const auto sign = certain_sign(distance_right_of(e, filtered))) return *sign;
  if (const auto sign = certain_sign(distance_right_of(e, certified(place)))) return *sign;
  const std::lock_guard lock(memory_->lock);
  ++memory_->counts.exact_sides;
  return geometry::side(line(e), meeting(place));
}

Sign UnroundedImage::exact_side(EdgeId e, PointId p) const {
  const std::lock_guard lock(memory_->lock);
  const auto [known, is_new] = memory_->sides.try_emplace(key(e.value, p.value));
  if (is_new) {
    ++memory_->counts.exact_sides;
    known->second = geometry::side(line(e), known_exact(p));
  }
  return known->second;
}

Sign UnroundedImage::exact_turn(EdgeId a, EdgeId b) const {
  const std::lock_guard lock(memory_->lock);
  const auto [known, is_new] = memory_->turns.try_emplace(key(a.value, b.value));
  if (is_new) {
    ++memory_->counts.exact_turns;
    known->second = geometry::turn(line(a), line(b));
  }
  return known->second;
}

Bounded UnroundedImage::height(EdgeId a, EdgeId b) const {
  if (!is_swap_edge(a) && !is_swap_edge(b)) {
    const Way d = direction(a);
    return Bounded(top(a).y, top(a).radius) + share_along(a, b) * Bounded(d.y, d.radius);
  }
  return height_of(filtered_place({a, b}));
}

// The crossing is at a's top + s d with s = ((b's top - a's top) x e) / (d x e), d and e being the edges' ways. Nothing is
// known where these may be parallel.
Bounded UnroundedImage::share_along(EdgeId a, EdgeId b) const {
  const Way e = direction(b);
  return determinant(way(top(a), top(b)), e) / determinant(direction(a), e);
}

CertifiedPlace UnroundedImage::place_on_swaps(const SwapEdge& p, const SwapEdge& q) {
  const auto minor = [&](double a, double b, double c, double d) {
    return Bounded(a, p.radius) * Bounded(d, q.radius) - Bounded(b, p.radius) * Bounded(c, q.radius);
  };
  const Bounded w = minor(p.a, p.b, q.a, q.b);
  const Bounded x = minor(p.b, p.c, q.b, q.c) / w;
  const Bounded y = minor(p.c, p.a, q.c, q.a) / w;
  return {x.value, y.value, std::max(x.radius, y.radius)};
}

// A swap edge's form has a value at each end of the other edge; where it is zero is in proportion between them.
Bounded UnroundedImage::share_to_swap(EdgeId e, EdgeId swap) const {
  const Bounded at_top = distance_right_of(swap, top(e));
  return at_top / (at_top - distance_right_of(swap, certified(edge(e).bottom)));
}

CertifiedPlace UnroundedImage::filtered_place(const Place& crossing) const {
  if (is_swap_edge(crossing.a) && is_swap_edge(crossing.b))
    return place_on_swaps(swap_edge(crossing.a), swap_edge(crossing.b));
  const Place place = is_swap_edge(crossing.a) ? Place{crossing.b, crossing.a} : crossing;
  const Way d = direction(place.a);
  const Bounded share = is_swap_edge(place.b) ? share_to_swap(place.a, place.b) : share_along(place.a, place.b);
  const Bounded x = Bounded(top(place.a).x, top(place.a).radius) + share * Bounded(d.x, d.radius);
  const Bounded y = Bounded(top(place.a).y, top(place.a).radius) + share * Bounded(d.y, d.radius);
  return {x.value, y.value, std::max(x.radius, y.radius)};
}

CertifiedPlace UnroundedImage::certified(const Place& place) const {
  const CertifiedPlace filtered = filtered_place(place);
  if (filtered.radius < largest_radius) return filtered;
  if (const auto seen = space_.crossing(place.a, place.b)) {
    const CertifiedPlace nearer = space_.place_of(*seen);
    if (nearer.radius < largest_radius) return nearer;
  }
  const std::lock_guard lock(memory_->lock);
  const auto [known, is_new] = memory_->crossings.try_emplace(key(place));
  if (is_new) known->second = geometry::certified(meeting(place));
  return known->second;
}

std::optional<Point2> UnroundedImage::rounded(const Place& place) const {
  const auto seen = space_.crossing(place.a, place.b);
  return seen ? space_.rounded_place_of(*seen) : std::nullopt;
}

int UnroundedImage::compare(const Place& a, PointId p) const {
  const int by_height = compare_heights(height(a.a, a.b), height(p));
  if (by_height != 0) return by_height;
  const std::lock_guard lock(memory_->lock);
  ++memory_->counts.exact_orders;
  return sweep_compare(meeting(a), known_exact(p));
}

// Returns the order of the crossings of an edge with two others, along it: where that is nearly horizontal, heights say little.
// Returns 0 where it is open.
int UnroundedImage::compare_along(EdgeId e, EdgeId with_a, EdgeId with_b) const {
  const auto way_to = [&](EdgeId other) {
    if (!is_swap_edge(e)) return is_swap_edge(other) ? share_to_swap(e, other) : share_along(e, other);
    const CertifiedPlace place = filtered_place({e, other});
    const Way d = direction(e);
    return Bounded(d.x, d.radius) * Bounded(place.x, place.radius) +
           Bounded(d.y, d.radius) * Bounded(place.y, place.radius);
  };
  const Bounded apart = way_to(with_b) - way_to(with_a);
  return apart.is_positive() ? -1 : apart.is_negative() ? 1 : 0;
}

// Compares heights by double words. Returns 0 where these do not decide.
int UnroundedImage::compare_in_words(const Place& a, const Place& b) const {
  const auto seen_at_a = space_.crossing(a.a, a.b);
  const auto seen_at_b = space_.crossing(b.a, b.b);
  if (!seen_at_a || !seen_at_b) return 0;
  const DoubleWord apart = space_.height_of(*seen_at_b) - space_.height_of(*seen_at_a);
  return !apart.is_not_zero() ? 0 : apart.high > 0 ? 1 : -1;
}

int UnroundedImage::compare(const Place& a, const Place& b) const {
  const int by_height = compare_heights(height(a.a, a.b), height(b.a, b.b));
  if (by_height != 0) return by_height;
  for (const auto& [e, with_a] : {std::pair(a.a, a.b), std::pair(a.b, a.a)}) {
    if (e != b.a && e != b.b) continue;
    const int along = compare_along(e, with_a, e == b.a ? b.b : b.a);
    if (along != 0) return along;
  }
  const std::lock_guard lock(memory_->lock);
  const std::uint64_t first_at_a = first_known_at(a);
  const std::uint64_t first_at_b = first_known_at(b);
  if (first_at_a == first_at_b) return 0;
  if (const int by_words = compare_in_words(a, b); by_words != 0) return by_words;
  ++memory_->counts.exact_orders;
  const int order = sweep_compare(meeting(a), meeting(b));
  if (order == 0) memory_->same[first_at_a] = first_at_b;
  return order;
}

ExactPlace UnroundedImage::exact(PointId p) const {
  const std::lock_guard lock(memory_->lock);
  return known_exact(p);
}

ExactPlace UnroundedImage::exact(const Place& place) const {
  const std::lock_guard lock(memory_->lock);
  return meeting(place);
}

ExactLine UnroundedImage::exact_line(EdgeId e) const {
  const std::lock_guard lock(memory_->lock);
  return line(e);
}

UnroundedCounts UnroundedImage::counts() const {
  const std::lock_guard lock(memory_->lock);
  return memory_->counts;
}

const ExactPlace& UnroundedImage::known_exact(PointId p) const {
  const auto [known, is_new] = memory_->places.try_emplace(p.value);
  if (is_new) known->second = exact_place(scene_, p, memory_->corners);
  return known->second;
}

const ExactPlace& UnroundedImage::meeting(const Place& place) const {
  const auto [known, is_new] = memory_->meetings.try_emplace(key(place));
  if (is_new) known->second = meeting_place(line(place.a), line(place.b));
  return known->second;
}

// Returns one of all surfaces that lie in the same plane.
FacetId UnroundedImage::plane_name(FacetId surface) const {
  const auto [known, is_new] = memory_->plane_names.try_emplace(surface.value);
  if (!is_new) return known->second;
  const Nearness<BigInteger>& form = memory_->nearness.of(surface);
  const BigInteger divisor = gcd(gcd(form.a, form.b), gcd(form.c, form.k));
  const std::array<BigInteger, 4> plane{form.a / divisor, form.b / divisor, form.c / divisor, form.k / divisor};
  return known->second = memory_->surface_in.try_emplace(plane, surface).first->second;
}

// Returns one of all swap edges that are on the same line since their surfaces lie in the same planes; another edge itself.
EdgeId UnroundedImage::line_name(EdgeId e) const {
  if (!is_swap_edge(e)) return e;
  const auto& [first, second] = swap_edge(e).surfaces;
  const auto [low, high] = std::minmax(plane_name(first).value, plane_name(second).value);
  return memory_->edge_between.try_emplace(key(low, high), e).first->second;
}

// Returns the key of a mesh edge of one surface and of the other one's plane, which it passes through, where an edge of the
// image crosses the swap edge of both; nothing where it is an edge of neither.
std::optional<std::uint64_t> UnroundedImage::passage(EdgeId e, EdgeId swap) const {
  if (is_swap_edge(e) || !is_swap_edge(swap)) return std::nullopt;
  const FacetId first = plane_name(swap_edge(swap).surfaces[0]);
  const FacetId second = plane_name(swap_edge(swap).surfaces[1]);
  for (const EdgeSide& side : scene_.sides_of(e)) {
    if (!side.mesh_edge.valid()) continue;
    const FacetId plane = plane_name(surface_of(scene_.mesh(), side.facet));
    if (plane == first) return key(side.mesh_edge.value, second.value);
    if (plane == second) return key(side.mesh_edge.value, first.value);
  }
  return std::nullopt;
}

// Crossings that are known to be at one place lead to one of them; what leads there is made shorter on the way. A mesh edge
// passes through a plane once, though its image crosses the swap edges of both of its facets there.
std::uint64_t UnroundedImage::first_known_at(const Place& place) const {
  std::uint64_t at = key(Place{line_name(place.a), line_name(place.b)});
  for (const auto& [e, swap] : {std::pair(place.a, place.b), std::pair(place.b, place.a)}) {
    if (const auto through = passage(e, swap)) at = memory_->passages.try_emplace(*through, at).first->second;
  }
  auto next = memory_->same.find(at);
  while (next != memory_->same.end()) {
    const auto after = memory_->same.find(next->second);
    if (after == memory_->same.end()) return next->second;
    at = next->second = after->second;
    next = memory_->same.find(at);
  }
  return at;
}

const ExactLine& UnroundedImage::line(EdgeId e) const {
  const auto [known, is_new] = memory_->lines.try_emplace(e.value);
  if (!is_new) return known->second;
  if (is_swap_edge(e)) return known->second = sweep::exact_line(swap_edge(e), memory_->nearness);
  return known->second = line_through(known_exact(edge(e).top), known_exact(edge(e).bottom));
}

}  // namespace sightline::inline sweep
