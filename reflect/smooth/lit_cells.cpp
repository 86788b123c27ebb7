#include "reflect/smooth/lit_cells.h"

#include <cmath>
#include <limits>
#include <map>

namespace sightline::inline reflect {
namespace {

double twice_area(const ImageTriangle& t) {
  return static_cast<double>(t[1].x - t[0].x) * static_cast<double>(t[2].y - t[0].y) -
         static_cast<double>(t[2].x - t[0].x) * static_cast<double>(t[1].y - t[0].y);
}

double length(const ImagePoint& p, const ImagePoint& q) {
  return std::hypot(static_cast<double>(q.x - p.x), static_cast<double>(q.y - p.y));
}

double diameter(const ImageTriangle& t) {
  return std::max({length(t[0], t[1]), length(t[1], t[2]), length(t[2], t[0])});
}

// How fast a linear function rises, per spacing.
double slope(const ImageTriangle& t, const CornerValues& values) {
  const double second = values[1] - values[0];
  const double third = values[2] - values[0];
  const auto dx = [&](std::size_t i) { return static_cast<double>(t[i].x - t[0].x); };
  const auto dy = [&](std::size_t i) { return static_cast<double>(t[i].y - t[0].y); };
  return std::hypot(second * dy(2) - third * dy(1), third * dx(1) - second * dx(2)) / twice_area(t);
}

using LinearConditions = boost::container::small_vector<LinearCondition, 8>;

LinearConditions linear(const ConvexPart& part) {
  LinearConditions result;
  for (const SeamedCondition& c : part) result.push_back(linear(c.condition));
  return result;
}

// Nothing beyond this is in the part.
BarycentricPolygon outer_part(BarycentricPolygon polygon, const LinearConditions& conditions) {
  for (const LinearCondition& c : conditions) polygon = part_above(polygon, c.values, -c.above);
  return polygon;
}

// All of the polygon is in the part.
bool covers(const LinearConditions& conditions, const BarycentricPolygon& polygon) {
  return std::ranges::all_of(conditions, [&](const LinearCondition& c) {
    return std::ranges::all_of(polygon, [&](const Barycentric& p) { return value_at(c.values, p) > c.below; });
  });
}

CornerValues negative(const CornerValues& values) { return {-values[0], -values[1], -values[2]}; }

// A place of the image, relative to a cell's first corner.
Point2 place_in(const ImageTriangle& t, const Barycentric& p) {
  const auto mean = [&](auto coordinate) { return p[1] * coordinate(1) + p[2] * coordinate(2); };
  return {mean([&](std::size_t i) { return static_cast<double>(t[i].x - t[0].x); }),
          mean([&](std::size_t i) { return static_cast<double>(t[i].y - t[0].y); })};
}

double distance_to_segment(const Point2& p, const Point2& a, const Point2& b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double square = dx * dx + dy * dy;
  const double along = square > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0.0;
  return std::hypot(p.x - a.x - along * dx, p.y - a.y - along * dy);
}

// How far a corner of a polygon is from another polygon, which is in it and convex.
double farthest_from(const ImageTriangle& t, const BarycentricPolygon& polygon, const BarycentricPolygon& other) {
  double farthest = 0;
  for (const Barycentric& corner : polygon) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < other.size(); ++i)
      nearest = std::min(nearest, distance_to_segment(place_in(t, corner), place_in(t, other[i]),
                                                      place_in(t, other[i + 1 == other.size() ? 0 : i + 1])));
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

// What may be uncertain of a part along the border of one of its conditions: a strip. What is in it and in the inner part is no
// further from the condition's line than the strip is wide; from outside the inner part, which is convex, no place is further than
// some corner.
CellPrecision uncertainty_along(const ImageTriangle& corners, const BarycentricPolygon& outer,
                                const BarycentricPolygon& inner, const LinearCondition& c) {
  const BarycentricPolygon strip = part_above(outer, negative(c.values), -c.below);
  const double share = share_of(strip);
  if (!(share > 0)) return {};
  const double width = (c.below + c.above) / slope(corners, c.values);
  const double outside = farthest_from(corners, part_above(strip, negative(c.values), 0), inner);
  return {share * twice_area(corners) / 2, std::min(diameter(corners), std::max(width, outside))};
}

// What is known of a cell without dividing it.
class CellMeasure {
 public:
  // Leaves out of the cell what no image, or no shadow that meets one, can be of.
  explicit CellMeasure(LitCell& cell) : corners_(cell.corners) {
    BarycentricPolygon seen = keep_those_within(whole_triangle(), cell.images, images_);
    is_dark_ = cell.images.empty();
    if (is_dark_) return;
    if (cell.images.size() > 1) seen = whole_triangle();
    keep_those_within(seen, cell.shadows, shadows_);
    is_dark_ = std::ranges::any_of(shadows_, [&](const Part& shadow) { return covers(shadow.conditions, seen); });
    if (is_dark_) return;
    add_borders(cell.images, images_);
    add_borders(cell.shadows, shadows_);
    uncertain_.area = std::min(uncertain_.area, twice_area(corners_) / 2);
  }

  [[nodiscard]] bool is_dark() const { return is_dark_; }
  [[nodiscard]] const CellPrecision& uncertain() const { return uncertain_; }
  // About so much is lit: the images less the shadows, as if none overlapped.
  [[nodiscard]] double lit_share() const {
    double share = 0;
    for (const Part& image : images_) share += share_of(image.outer);
    for (const Part& shadow : shadows_) share -= share_of(shadow.outer);
    return std::clamp(share, 0.0, 1.0);
  }

 private:
  struct Part {
    LinearConditions conditions;
    BarycentricPolygon outer;  // nothing beyond this is in the part

    // What the linear functions say.
    [[nodiscard]] BarycentricPolygon inner() const {
      BarycentricPolygon result = outer;
      for (const LinearCondition& c : conditions) result = part_above(result, c.values, 0);
      return result;
    }
  };

  // Returns the outer part of the last one.
  static BarycentricPolygon keep_those_within(const BarycentricPolygon& polygon, std::vector<ConvexPart>& parts,
                                              std::vector<Part>& measured) {
    std::erase_if(parts, [&](const ConvexPart& part) {
      LinearConditions conditions = linear(part);
      BarycentricPolygon outer = outer_part(polygon, conditions);
      if (!(share_of(outer) > 0)) return true;
      measured.push_back({std::move(conditions), std::move(outer)});
      return false;
    });
    return measured.empty() ? BarycentricPolygon{} : measured.back().outer;
  }

  // A seam of two parts is no border of both together.
  void add_borders(const std::vector<ConvexPart>& parts, const std::vector<Part>& measured) {
    const std::vector<std::uint32_t> seams = seams_of(parts);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      std::optional<BarycentricPolygon> inner;
      for (std::size_t k = 0; k < parts[i].size(); ++k) {
        if (std::ranges::binary_search(seams, other_side(parts[i][k].number))) continue;
        if (!inner) inner = measured[i].inner();
        const CellPrecision more = uncertainty_along(corners_, measured[i].outer, *inner, measured[i].conditions[k]);
        uncertain_.area += more.area;
        uncertain_.distance = std::max(uncertain_.distance, more.distance);
      }
    }
  }

  [[nodiscard]] static std::vector<std::uint32_t> seams_of(const std::vector<ConvexPart>& parts) {
    std::vector<std::uint32_t> seams;
    for (const ConvexPart& part : parts) {
      for (const SeamedCondition& c : part) seams.push_back(c.number);
    }
    std::ranges::sort(seams);
    return seams;
  }

  const ImageTriangle& corners_;
  std::vector<Part> images_;
  std::vector<Part> shadows_;
  bool is_dark_ = false;
  CellPrecision uncertain_;
};

// Returns the conditions that are open in the halves of a cell; nothing where one fails.
std::array<std::optional<ConvexPart>, 2> halves(const ConvexPart& part) {
  std::array<std::optional<ConvexPart>, 2> result{ConvexPart{}, ConvexPart{}};
  for (const SeamedCondition& c : part) {
    if (!result[0] && !result[1]) break;
    const std::array<Quartic, 2> values = c.condition.value.halves();
    for (std::size_t i = 0; i < 2; ++i) {
      const Condition half{values[i], c.condition.noise};
      const Standing at = standing(half);
      if (at == Standing::fails) result[i].reset();
      if (at == Standing::open && result[i]) result[i]->push_back({half, c.seam, c.line, c.number});
    }
  }
  return result;
}

// Shadows are halved where something may be lit.
std::optional<std::array<LitCell, 2>> halves(const LitCell& cell) {
  const auto& [a, b, c] = cell.corners;
  const std::optional<ImagePoint> m = middle(a, b);
  if (!m) return std::nullopt;
  std::array<LitCell, 2> result{LitCell{{c, a, *m}, {}, {}}, LitCell{{b, c, *m}, {}, {}}};
  for (const auto parts : {&LitCell::images, &LitCell::shadows}) {
    if (parts == &LitCell::shadows && result[0].images.empty() && result[1].images.empty()) break;
    for (const ConvexPart& part : cell.*parts) {
      std::array<std::optional<ConvexPart>, 2> found = halves(part);
      for (std::size_t i = 0; i < 2; ++i) {
        if (found[i]) (result[i].*parts).push_back(std::move(*found[i]));
      }
    }
  }
  return result;
}

bool may_be_lit(const LitCell& cell) {
  return !cell.images.empty() &&
         std::ranges::none_of(cell.shadows, [](const ConvexPart& part) { return part.empty(); });
}

// Facets that share an edge have the same line there, on whichever side of them rays meet them.
void number(LitCell& cell, std::uint32_t& count) {
  std::map<Seam, std::uint32_t> lines;
  std::map<Seam, std::uint32_t> seams;
  for (std::vector<ConvexPart>* parts : {&cell.images, &cell.shadows}) {
    for (ConvexPart& part : *parts) {
      for (SeamedCondition& c : part) {
        c.line = c.number = count;
        count += 2;
        if (!c.seam) continue;
        const Seam& seam = *c.seam;
        const auto [start, end] = std::minmax(seam.start, seam.end);
        c.line = lines.try_emplace({seam.object, true, start, end}, c.line).first->second;
        c.number = seams.try_emplace({seam.object, seam.from_front, start, end}, c.number).first->second;
        if (seam.start != start) c.number = other_side(c.number);
      }
    }
  }
}

bool is_precise(const CellPrecision& uncertain, const CellPrecision& wanted) {
  return uncertain.area <= wanted.area && uncertain.distance <= wanted.distance;
}

bool is_lit(const LitCell& cell) {
  return cell.shadows.empty() &&
         std::ranges::any_of(cell.images, [](const ConvexPart& image) { return image.empty(); });
}

bool is_outside(const ImageTriangle& t, const PolygonOutline& outline) {
  const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
  const auto [bottom, top] = std::minmax({t[0].y, t[1].y, t[2].y});
  return outline.place_of({left, bottom}, std::max(right - left, top - bottom)) == SquarePlace::outside;
}

}  // namespace

bool narrow_to_lit(LitCell& cell) { return may_be_lit(cell) && !CellMeasure(cell).is_dark(); }

bool is_lit_at(const LitCell& cell, const Point2& place) {
  const Barycentric at = barycentric(cell.corners, place);
  if (std::ranges::min(at) < 0) return false;
  const auto holds = [&](const SeamedCondition& c) { return c.condition.value.at(at) > c.condition.noise; };
  const auto fails = [&](const SeamedCondition& c) { return c.condition.value.at(at) < -c.condition.noise; };
  return std::ranges::any_of(cell.images, [&](const ConvexPart& image) { return std::ranges::all_of(image, holds); }) &&
         std::ranges::all_of(cell.shadows,
                             [&](const ConvexPart& shadow) { return std::ranges::any_of(shadow, fails); });
}

Standing standing(const Condition& condition) {
  if (condition.value.least() > condition.noise) return Standing::holds;
  return condition.value.greatest() > condition.noise ? Standing::open : Standing::fails;
}

CellsFound& CellsFound::operator+=(const CellsFound& more) {
  lit_area += more.lit_area;
  uncertain_area += more.uncertain_area;
  distance = std::max(distance, more.distance);
  largest_uncertain_area = std::max(largest_uncertain_area, more.largest_uncertain_area);
  is_all_lit = is_all_lit && more.is_all_lit;
  return *this;
}

void LitCells::add(LitCell cell, const PolygonOutline& outline, const CellPrecision& precision) {
  number(cell, number_count_);
  look_at(std::move(cell), outline, precision);
}

void LitCells::divide(const PolygonOutline& outline, const CellPrecision& precision) {
  std::vector<LitCell> cells;
  std::vector<Known> known;
  cells.swap(cells_);
  known.swap(known_);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!is_precise(known[i].uncertain, precision) && divide(cells[i], outline, precision)) continue;
    cells_.push_back(std::move(cells[i]));
    known_.push_back(known[i]);
  }
}

CellsFound LitCells::found() const {
  CellsFound result;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const auto& [uncertain, lit_area, is_least] = known_[i];
    result += {lit_area, uncertain.area, uncertain.distance, is_least ? 0 : uncertain.area, is_lit(cells_[i])};
  }
  result.is_all_lit = result.is_all_lit && !has_dark_;
  return result;
}

// Returns false where it cannot.
bool LitCells::divide(const LitCell& cell, const PolygonOutline& outline, const CellPrecision& precision) {
  auto parts = halves(cell);
  if (!parts) return false;
  halved_.insert(side_between(cell.corners[0], cell.corners[1]));
  for (LitCell& part : *parts) look_at(std::move(part), outline, precision);
  return true;
}

void LitCells::look_at(LitCell cell, const PolygonOutline& outline, const CellPrecision& precision) {
  if (is_outside(cell.corners, outline)) return;
  ++count_;
  const std::optional<CellMeasure> measure = may_be_lit(cell) ? std::optional<CellMeasure>(cell) : std::nullopt;
  if (!measure || measure->is_dark()) {
    has_dark_ = true;
    return;
  }
  if (!is_precise(measure->uncertain(), precision) && divide(cell, outline, precision)) return;
  known_.push_back({measure->uncertain(), measure->lit_share() * twice_area(cell.corners) / 2,
                    !middle(cell.corners[0], cell.corners[1])});
  cells_.push_back(std::move(cell));
}

}  // namespace sightline::inline reflect
