#include "sweep/segments/unrounded_image.h"

#include <algorithm>

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
      memory_(std::make_unique<Memory>(scene, swap_edges)) {}

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
  const CrossingNames::Name of_a = memory_->names.of(a.a, a.b);
  const CrossingNames::Name of_b = memory_->names.of(b.a, b.b);
  if (of_a == of_b) return 0;
  if (const int by_words = compare_in_words(a, b); by_words != 0) return by_words;
  ++memory_->counts.exact_orders;
  const int order = sweep_compare(meeting(a), meeting(b));
  if (order == 0) memory_->names.unite(of_a, of_b);
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

const ExactLine& UnroundedImage::line(EdgeId e) const {
  const auto [known, is_new] = memory_->lines.try_emplace(e.value);
  if (!is_new) return known->second;
  if (is_swap_edge(e)) return known->second = sweep::exact_line(swap_edge(e), memory_->nearness);
  return known->second = line_through(known_exact(edge(e).top), known_exact(edge(e).bottom));
}

}  // namespace sightline::inline sweep
