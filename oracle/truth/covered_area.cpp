#include "oracle/truth/covered_area.h"

#include <algorithm>

#include "oracle/truth/rise.h"

namespace sightline::oracle::image {
namespace {

// Returns the x at this y on the line a x + b y + c = 0.
Fraction x_at(const Line& line, const Fraction& y) {
  return fraction(-(line.b * y.top + line.c * y.bottom), line.a * y.bottom);
}

// This is a rise where it passes through a slab.
struct Standing {
  Fraction x;
  std::size_t rise = 0;
};

// The span says which slabs a rise passes through: [first, end).
struct Span {
  std::size_t first = 0;
  std::size_t end = 0;
};

class Decomposition {
 public:
  Decomposition(const std::vector<Shape>& shapes, const Wanted& wanted)
      : wanted_(wanted), rises_(rises_of(shapes)), heights_(heights_of(rises_)), windings_(shapes.size()) {
    const auto place = [&](const Fraction& y) {
      return static_cast<std::size_t>(std::lower_bound(heights_.begin(), heights_.end(), y) - heights_.begin());
    };
    for (const Rise& rise : rises_) spans_.push_back({place(rise.bottom), place(rise.top)});
  }

  [[nodiscard]] Rational area() {
    std::vector<Rational> terms;
    std::vector<int> below(rises_.size());
    for (std::size_t h = 0; h < heights_.size(); ++h) {
      const std::vector<int> above = h + 1 < heights_.size() ? border_in(h) : std::vector<int>(rises_.size());
      for (std::size_t r = 0; r < rises_.size(); ++r) {
        if (below[r] != above[r]) terms.push_back((below[r] - above[r]) * integral(rises_[r].line, heights_[h]));
      }
      below = above;
    }
    return sum(std::move(terms));
  }

 private:
  // Returns, per rise, whether in this slab what counts ends there (+1), begins there (-1), or neither. Of rises that
  // coincide it is the first.
  [[nodiscard]] std::vector<int> border_in(std::size_t slab) {
    std::vector<int> border(rises_.size());
    const std::vector<Standing> standing = standing_in(slab);
    std::fill(windings_.begin(), windings_.end(), 0);
    bool before = false;
    for (std::size_t i = 0; i < standing.size();) {
      const std::size_t first = standing[i].rise;
      for (; i < standing.size() && rises_[standing[i].rise].line == rises_[first].line; ++i) {
        const Rise& rise = rises_[standing[i].rise];
        windings_[rise.shape] += rise.winding;
      }
      const bool after = windings_[0] > 0 && wanted_(windings_);
      border[first] = (before ? 1 : 0) - (after ? 1 : 0);
      before = after;
    }
    return border;
  }

  // The rises stand left to right; those on one line are together.
  [[nodiscard]] std::vector<Standing> standing_in(std::size_t slab) const {
    const Fraction y = between(heights_[slab], heights_[slab + 1]);
    std::vector<Standing> result;
    for (std::size_t r = 0; r < rises_.size(); ++r) {
      if (spans_[r].first <= slab && slab < spans_[r].end) result.push_back({x_at(rises_[r].line, y), r});
    }
    std::sort(result.begin(), result.end(), [](const Standing& a, const Standing& b) {
      if (a.x.key != b.x.key) return a.x.key < b.x.key;
      return a.x == b.x ? a.rise < b.rise : a.x < b.x;
    });
    return result;
  }

  // Returns the integral of x dy on the line from y = 0: x = -(b y + c) / a.
  [[nodiscard]] static Rational integral(const Line& line, const Fraction& y) {
    return {-y.top * (line.b * y.top + 2 * line.c * y.bottom), 2 * line.a * y.bottom * y.bottom};
  }

  // Neighbours are added first, so that few sums have long denominators.
  [[nodiscard]] static Rational sum(std::vector<Rational> terms) {
    for (std::size_t n = terms.size(); n > 1; n = (n + 1) / 2) {
      for (std::size_t i = 0; i < n / 2; ++i) terms[i] = terms[2 * i] + terms[2 * i + 1];
      if (n % 2 != 0) terms[n / 2] = terms[n - 1];
    }
    return terms.empty() ? Rational() : terms.front();
  }

  const Wanted& wanted_;
  std::vector<Rise> rises_;
  std::vector<Fraction> heights_;
  std::vector<Span> spans_;
  std::vector<int> windings_;
};

}  // namespace

Rational area_where(const std::vector<Shape>& shapes, const Wanted& wanted) {
  return Decomposition(shapes, wanted).area();
}

}  // namespace sightline::oracle::image
