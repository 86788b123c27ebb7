#include "sweep/unrounded/unrounded_decider.h"

#include <algorithm>
#include <cmath>

namespace sightline::inline sweep {
namespace {

double size_of(double x, double y) { return std::fabs(x) + std::fabs(y); }

std::uint64_t key(std::uint32_t a, std::uint32_t b) { return std::uint64_t{a} << 32 | b; }

}  // namespace

UnroundedDecider::UnroundedDecider(const UnroundedScene& scene)
    : scene_(scene), swap_edges_(scene), exact_places_(scene.places.size()), lines_(scene.scene.edge_count()) {
  directions_.reserve(scene.scene.edge_count());
  for (std::size_t e = 0; e < scene.scene.edge_count(); ++e) {
    const SceneEdge& edge = scene.scene.edges[e];
    directions_.push_back(way(scene.places[edge.top.index()], scene.places[edge.bottom.index()]));
  }
}

UnroundedDecider::Way UnroundedDecider::way(const CertifiedPlace& from, const CertifiedPlace& to) {
  const double x = to.x - from.x;
  const double y = to.y - from.y;
  return {x, y, Bounded::widened(from.radius + to.radius + unit_roundoff * std::max(std::fabs(x), std::fabs(y)))};
}

Bounded UnroundedDecider::determinant(const Way& d, const Way& e) {
  const double left = d.x * e.y;
  const double right = d.y * e.x;
  const double through = d.radius * size_of(e.x, e.y) + e.radius * size_of(d.x, d.y) + 2 * d.radius * e.radius;
  return {left - right, Bounded::widened(Bounded::widened(through) + 3 * unit_roundoff * size_of(left, right))};
}

Sign UnroundedDecider::side(EdgeId e, PointId p) const {
  ++counts_.sides;
  if (swap_edges_.is_one(e)) {
    const auto sign = certain_sign(swap_side(e, scene_.places[p.index()]));
    return sign ? *sign : exact_side(e, p);
  }
  const SceneEdge& edge = scene_.scene.edge(e);
  if (p == edge.top || p == edge.bottom) return 0;
  const auto sign =
      certain_sign(determinant(directions_[e.index()], way(scene_.places[edge.top.index()], scene_.places[p.index()])));
  return sign ? *sign : exact_side(e, p);
}

// The coefficients are at most 1 and off by u; two products and two sums round.
Bounded UnroundedDecider::swap_side(EdgeId e, const CertifiedPlace& place) const {
  const SwapEdge& edge = swap_edges_[e];
  const double size = size_of(place.x, place.y) + 1;
  return {(edge.a * place.x + edge.b * place.y) + edge.c,
          Bounded::widened(2 * place.radius + 5 * unit_roundoff * size)};
}

Sign UnroundedDecider::side(EdgeId e, const Place& place) const {
  if (place.a == e || place.b == e) return 0;
  ++counts_.sides;
  if (swap_edges_.is_one(e)) {
    const auto sign = certain_sign(swap_side(e, certified_place(place)));
    if (sign) return *sign;
  }
  ++counts_.exact_sides;
  return sweep::side(line(e), exact(place));
}

Sign UnroundedDecider::exact_side(EdgeId e, PointId p) const {
  const auto [known, is_new] = sides_.try_emplace(key(e.value, p.value));
  if (is_new) {
    ++counts_.exact_sides;
    known->second = sweep::side(line(e), known_exact(p));
  }
  return known->second;
}

Sign UnroundedDecider::turn(EdgeId a, EdgeId b) const {
  ++counts_.turns;
  if (a == b) return 0;
  const auto sign = certain_sign(determinant(directions_[a.index()], directions_[b.index()]));
  return sign ? *sign : exact_turn(a, b);
}

Sign UnroundedDecider::exact_turn(EdgeId a, EdgeId b) const {
  const auto [known, is_new] = turns_.try_emplace(key(a.value, b.value));
  if (is_new) {
    ++counts_.exact_turns;
    known->second = sweep::turn(line(a), line(b));
  }
  return known->second;
}

Bounded UnroundedDecider::height(EdgeId a, EdgeId b) const {
  if (!swap_edges_.is_one(a) && !swap_edges_.is_one(b)) {
    const CertifiedPlace& top = scene_.places[scene_.scene.edge(a).top.index()];
    const Way& d = directions_[a.index()];
    return Bounded(top.y, top.radius) + share_along(a, b) * Bounded(d.y, d.radius);
  }
  const CertifiedPlace& place = certified_place({a, b});
  return {place.y, place.radius};
}

// The crossing is at a's top + s d with s = ((b's top - a's top) x e) / (d x e), d and e being the edges' ways. Nothing is
// known where these may be parallel.
Bounded UnroundedDecider::share_along(EdgeId a, EdgeId b) const {
  const CertifiedPlace& top = scene_.places[scene_.scene.edge(a).top.index()];
  const Way between = way(top, scene_.places[scene_.scene.edge(b).top.index()]);
  const Way& e = directions_[b.index()];
  return determinant(between, e) / determinant(directions_[a.index()], e);
}

CertifiedPlace UnroundedDecider::filtered_place(const Place& place) const {
  const CertifiedPlace& top = scene_.places[scene_.scene.edge(place.a).top.index()];
  const Way& d = directions_[place.a.index()];
  const Bounded share = share_along(place.a, place.b);
  const Bounded x = Bounded(top.x, top.radius) + share * Bounded(d.x, d.radius);
  const Bounded y = Bounded(top.y, top.radius) + share * Bounded(d.y, d.radius);
  return {x.value, y.value, std::max(x.radius, y.radius)};
}

int UnroundedDecider::compare(const Place& a, PointId p) const {
  ++counts_.exact_orders;
  return sweep_compare(exact(a), known_exact(p));
}

int UnroundedDecider::compare(const Place& a, const Place& b) const {
  ++counts_.exact_orders;
  return sweep_compare(exact(a), exact(b));
}

std::array<double, 2> UnroundedDecider::in_window(PointId p) const {
  return {scene_.places[p.index()].x, scene_.places[p.index()].y};
}

std::array<double, 2> UnroundedDecider::in_window(const Place& place) const {
  const CertifiedPlace& certified = certified_place(place);
  return {certified.x, certified.y};
}

EdgeId UnroundedDecider::swap_edge(FacetId f, FacetId g) const {
  const EdgeId e = swap_edges_.between(f, g);
  if (e.index() == directions_.size()) directions_.push_back({swap_edges_[e].b, -swap_edges_[e].a, unit_roundoff});
  return e;
}

const CertifiedPlace& UnroundedDecider::certified_place(const Place& place) const {
  const auto [known, is_new] = crossings_.try_emplace(key(place.a.value, place.b.value));
  if (!is_new) return known->second;
  const bool of_scene = !swap_edges_.is_one(place.a) && !swap_edges_.is_one(place.b);
  if (of_scene) known->second = filtered_place(place);
  if (!of_scene || !(known->second.radius < largest_radius)) known->second = sweep::certified(exact(place));
  return known->second;
}

const ExactPlace& UnroundedDecider::known_exact(PointId p) const {
  auto& place = exact_places_[p.index()];
  if (!place) place = std::make_unique<ExactPlace>(scene_.exact(p));
  return *place;
}

const ExactLine& UnroundedDecider::line(EdgeId e) const {
  if (swap_edges_.is_one(e)) return swap_edges_[e].line;
  auto& line = lines_[e.index()];
  const SceneEdge& edge = scene_.scene.edge(e);
  if (!line) line = std::make_unique<ExactLine>(line_through(known_exact(edge.top), known_exact(edge.bottom)));
  return *line;
}

}  // namespace sightline::inline sweep
