#include "bench/measuring/figure.h"

#include <fmt/format.h>

#include <cmath>

namespace sightline::bench {
namespace {

using Kind = Figure::Kind;

bool says_something(Kind kind) { return kind == Kind::exactly || kind == Kind::above || kind == Kind::below; }

Kind opposite(Kind kind) {
  if (kind == Kind::above) return Kind::below;
  return kind == Kind::below ? Kind::above : kind;
}

// Returns the kind of a figure that grows with both.
Kind together(Kind a, Kind b) {
  if (!says_something(a)) return a;
  if (!says_something(b) || a == Kind::exactly) return b;
  return b == Kind::exactly || b == a ? a : Kind::unknown;
}

}  // namespace

Figure figure_of(const Outcome& outcome, std::size_t index, const RunLimits& limits) {
  if (outcome.end == Outcome::End::out_of_time) return {Kind::above, limits.seconds};
  if (outcome.end == Outcome::End::failed) return {Kind::failed, 0};
  if (index >= outcome.numbers.size()) return {Kind::not_installed, 0};
  return exactly(outcome.numbers[index]);
}

Figure ratio(const Figure& a, const Figure& b) { return {together(a.kind, opposite(b.kind)), a.value / b.value}; }

Figure exponent(const Figure& first, const Figure& last, const Growth& size) {
  const Figure growth = ratio(last, first);
  return {size.to > size.from ? growth.kind : Kind::unknown, std::log(growth.value) / std::log(size.to / size.from)};
}

std::string text_of(const Figure& figure) {
  const std::string number = fmt::format(fmt::runtime(figure.value < 1000 ? "{:.3g}" : "{:.0f}"), figure.value);
  switch (figure.kind) {
    case Kind::exactly:
      return number;
    case Kind::above:
      return "> " + number;
    case Kind::below:
      return "< " + number;
    case Kind::not_installed:
      return "not installed";
    case Kind::failed:
      return "failed";
    case Kind::unknown:
      break;
  }
  return "-";
}

std::string reached(const Figure& figure, const Goal& goal) {
  const bool at_most = goal.sense == Goal::Sense::at_most;
  const bool holds = at_most ? figure.value <= goal.value : figure.value >= goal.value;
  if (figure.kind == Kind::exactly) return holds ? "yes" : "no";
  // A bound decides where the truth lies on the same side of it as it lies of the goal.
  const Kind needed = holds == at_most ? Kind::below : Kind::above;
  if (figure.kind == needed) return holds ? "yes" : "no";
  return "not known";
}

}  // namespace sightline::bench
