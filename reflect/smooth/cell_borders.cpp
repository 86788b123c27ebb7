#include "reflect/smooth/cell_borders.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <unordered_map>

#include "reflect/regions/lit_region.h"

namespace sightline::inline reflect {
namespace {

// A condition's border through a cell. What is kept is to its left.
struct Chord {
  ImagePoint start;
  ImagePoint end;
  std::array<std::optional<ImagePoint>, 3> on_sides;  // where it meets the cell's sides
  const SeamedCondition* condition = nullptr;
};

// What is to the left of all of them.
using ChordPart = std::vector<Chord>;

struct ChordCell {
  std::vector<ChordPart> images;
  std::vector<ChordPart> shadows;
};

constexpr std::size_t no_side = 3;

// The edge from a corner runs along a side of the cell, by its number, or along a chord.
struct CellCorner {
  ImagePoint place;
  std::size_t side = no_side;
  const Chord* chord = nullptr;
};
using CellPolygon = boost::container::small_vector<CellCorner, 8>;

ImagePoint rounded_between(const ImagePoint& p, const ImagePoint& q, double share) {
  return {p.x + std::llround(share * static_cast<double>(q.x - p.x)),
          p.y + std::llround(share * static_cast<double>(q.y - p.y))};
}

// The corner that two edges of a facet share.
struct FacetCorner {
  std::uint32_t object = 0;
  std::uint32_t vertex = 0;
  friend constexpr bool operator==(const FacetCorner&, const FacetCorner&) = default;
};

std::optional<FacetCorner> common_corner(const SeamedCondition& a, const SeamedCondition& b) {
  if (!a.seam || !b.seam || a.seam->object != b.seam->object) return std::nullopt;
  for (const std::uint32_t vertex : {a.seam->start, a.seam->end}) {
    if (vertex == b.seam->start || vertex == b.seam->end) return FacetCorner{a.seam->object, vertex};
  }
  return std::nullopt;
}

// Returns where both conditions are zero, near a place where they are, nearly: Newton's method with the derivatives of their linear
// functions.
Barycentric common_zero(const Condition& a, const Condition& b, Barycentric at) {
  const CornerValues of_a = a.value.corners();
  const CornerValues of_b = b.value.corners();
  const double determinant = (of_a[1] - of_a[0]) * (of_b[2] - of_b[0]) - (of_a[2] - of_a[0]) * (of_b[1] - of_b[0]);
  for (int step = 0; step < 3; ++step) {
    const double at_a = a.value.at(at);
    const double at_b = b.value.at(at);
    at[1] -= (at_a * (of_b[2] - of_b[0]) - (of_a[2] - of_a[0]) * at_b) / determinant;
    at[2] -= ((of_a[1] - of_a[0]) * at_b - at_a * (of_b[1] - of_b[0])) / determinant;
    at[0] = 1 - at[1] - at[2];
  }
  return at;
}

// Parts of one cell. Facets around a vertex have it at the same place as long as that is where their conditions allow it to be:
// then there is no gap between their shadows.
class CellParts {
 public:
  explicit CellParts(const ImageTriangle& corners) : corners_(corners) {}

  [[nodiscard]] CellPolygon part_left_of(const ChordPart& part, CellPolygon polygon) {
    for (const Chord& chord : part) polygon = part_left_of(chord, polygon);
    return polygon;
  }

 private:
  struct Vertex {
    FacetCorner corner;
    ImagePoint place;
  };

  // This is one side of Sutherland and Hodgman's clipping.
  [[nodiscard]] CellPolygon part_left_of(const Chord& chord, const CellPolygon& polygon) {
    CellPolygon result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const CellCorner& from = polygon[i];
      const ImagePoint& to = polygon[i + 1 == polygon.size() ? 0 : i + 1].place;
      const bool from_is_left = orientation(chord.start, chord.end, from.place) >= 0;
      const bool to_is_left = orientation(chord.start, chord.end, to) >= 0;
      if (from_is_left) result.push_back(from);
      if (from_is_left && !to_is_left) result.push_back({crossing_of(from, to, chord), no_side, &chord});
      if (!from_is_left && to_is_left) result.push_back({crossing_of(from, to, chord), from.side, from.chord});
    }
    return result;
  }

  // Where the edge that begins at a corner crosses the chord.
  [[nodiscard]] ImagePoint crossing_of(const CellCorner& from, const ImagePoint& to, const Chord& chord) {
    if (from.side != no_side && chord.on_sides[from.side]) return *chord.on_sides[from.side];
    const auto at_from = static_cast<double>(twice_area(chord.start, chord.end, from.place));
    const auto at_to = static_cast<double>(twice_area(chord.start, chord.end, to));
    const ImagePoint crossing = rounded_between(from.place, to, at_from / (at_from - at_to));
    if (from.chord == nullptr) return crossing;
    const auto corner = common_corner(*from.chord->condition, *chord.condition);
    return corner ? place_of(*corner, crossing, *from.chord->condition, *chord.condition) : crossing;
  }

  [[nodiscard]] ImagePoint place_of(const FacetCorner& corner, const ImagePoint& crossing, const SeamedCondition& a,
                                    const SeamedCondition& b) {
    auto known = std::ranges::find(vertices_, corner, &Vertex::corner);
    if (known == vertices_.end()) {
      vertices_.push_back(
          {corner, inside(common_zero(a.condition, b.condition, barycentric_of(crossing))).value_or(crossing)});
      known = std::prev(vertices_.end());
    }
    return may_be_at(known->place, a) && may_be_at(known->place, b) ? known->place : crossing;
  }

  [[nodiscard]] Barycentric barycentric_of(const ImagePoint& p) const {
    return barycentric(corners_, {static_cast<double>(p.x), static_cast<double>(p.y)});
  }

  // Nothing where it is not in the cell.
  [[nodiscard]] std::optional<ImagePoint> inside(const Barycentric& p) const {
    if (!(std::ranges::min(p) >= 0)) return std::nullopt;
    const auto along = [&](auto coordinate) {
      const auto way = [&](std::size_t i) { return p[i] * static_cast<double>(coordinate(i) - coordinate(0)); };
      return coordinate(0) + std::llround(way(1) + way(2));
    };
    return ImagePoint{along([&](std::size_t i) { return corners_[i].x; }),
                      along([&](std::size_t i) { return corners_[i].y; })};
  }

  // Returns whether the condition's border may pass there.
  [[nodiscard]] bool may_be_at(const ImagePoint& place, const SeamedCondition& c) const {
    const LinearCondition line = linear(c.condition);
    const double value = value_at(line.values, barycentric_of(place));
    return -line.above <= value && value <= line.below;
  }

  const ImageTriangle& corners_;
  std::vector<Vertex> vertices_;
};

// Segments by how often they run from their first end, in sweep order, to the second, less how often they run back.
class WoundSegments {
 public:
  void add(const ImagePoint& from, const ImagePoint& to, int times) {
    if (from == to) return;
    const CellSide ends = side_between(from, to);
    segments_.push_back({ends, ends.first == from ? times : -times});
  }

  [[nodiscard]] RegionBorder border() {
    const auto order = [](const Segment& s) {
      return std::tuple(s.ends.first.x, s.ends.first.y, s.ends.second.x, s.ends.second.y);
    };
    std::sort(segments_.begin(), segments_.end(),
              [&](const Segment& a, const Segment& b) { return order(a) < order(b); });
    RegionBorder border;
    for (auto s = segments_.begin(); s != segments_.end();) {
      const CellSide ends = s->ends;
      int times = 0;
      for (; s != segments_.end() && s->ends == ends; ++s) times += s->times;
      for (; times > 0; --times) border.push_back(border_segment(ends.first, ends.second));
      for (; times < 0; ++times) border.push_back(border_segment(ends.second, ends.first));
    }
    return border;
  }

 private:
  struct Segment {
    CellSide ends;
    int times = 0;
  };
  std::vector<Segment> segments_;
};

class CellBorders {
 public:
  CellBorders(const std::vector<LitCell>& cells, const CellSides& halved) : cells_(cells), halved_(halved) {}

  RegionBorder run() {
    std::vector<ChordCell> chords;
    for (const LitCell& cell : cells_)
      chords.push_back({parts_of(cell.corners, cell.images), parts_of(cell.corners, cell.shadows)});
    for (std::size_t i = 0; i < cells_.size(); ++i) add_lit(cells_[i].corners, chords[i]);
    return segments_.border();
  }

 private:
  [[nodiscard]] std::vector<ChordPart> parts_of(const ImageTriangle& corners, const std::vector<ConvexPart>& parts) {
    std::vector<ChordPart> result;
    for (const ConvexPart& part : parts) {
      if (std::optional<ChordPart> chords = part_of(corners, part)) result.push_back(std::move(*chords));
    }
    return result;
  }

  // Nothing where the part is empty.
  [[nodiscard]] std::optional<ChordPart> part_of(const ImageTriangle& corners, const ConvexPart& part) {
    ChordPart result;
    for (const SeamedCondition& c : part) {
      const CornerValues values = c.condition.value.corners();
      if (!std::ranges::all_of(values, [](double value) { return std::isfinite(value); })) return std::nullopt;
      const auto positive = std::ranges::count_if(values, [](double value) { return value >= 0; });
      if (positive == 0) return std::nullopt;
      if (positive == 3) continue;
      const Chord chord = chord_of(corners, c, values);
      if (chord.start != chord.end)
        result.push_back(chord);
      else if (positive == 1)
        return std::nullopt;
    }
    return result;
  }

  [[nodiscard]] Chord chord_of(const ImageTriangle& corners, const SeamedCondition& c, const CornerValues& values) {
    Chord chord{{}, {}, {}, &c};
    for (std::size_t side = 0; side < 3; ++side) {
      const bool from_positive = values[side] >= 0;
      if (from_positive == (values[(side + 1) % 3] >= 0)) continue;
      const ImagePoint zero = zero_on(corners, side, c);
      chord.on_sides[side] = zero;
      (from_positive ? chord.start : chord.end) = zero;
    }
    return chord;
  }

  // Precondition: the condition changes its sign from the side's one end to the other.
  [[nodiscard]] ImagePoint zero_on(const ImageTriangle& corners, std::size_t side, const SeamedCondition& c) {
    struct End {
      ImagePoint place;
      Barycentric at{};
      double value = 0;
    };
    const auto corner = [&](std::size_t i) {
      End end{corners[i], {}, c.condition.value.corners()[i]};
      end.at[i] = 1;
      return end;
    };
    End p = corner(side);
    End q = corner((side + 1) % 3);
    while (halved_.contains(side_between(p.place, q.place))) {
      End m{*middle(p.place, q.place), between(p.at, q.at, 0.5), 0};
      m.value = c.condition.value.at(m.at);
      ((m.value >= 0) == (p.value >= 0) ? p : q) = m;
    }
    return zero_between(c.line, p.place, q.place, p.value / (p.value - q.value));
  }

  // Who asks first says where it is.
  [[nodiscard]] ImagePoint zero_between(std::uint32_t line, const ImagePoint& p, const ImagePoint& q, double share) {
    auto& zeros = zeros_[side_between(p, q)];
    for (const Zero& zero : zeros) {
      if (zero.line == line) return zero.place;
    }
    zeros.push_back({line, rounded_between(p, q, share)});
    return zeros.back().place;
  }

  // Adds the places of a side but the last one.
  void add_places(const ImagePoint& p, const ImagePoint& q, std::vector<ImagePoint>& places) const {
    const CellSide side = side_between(p, q);
    if (halved_.contains(side)) {
      const ImagePoint m = *middle(p, q);
      add_places(p, m, places);
      add_places(m, q, places);
      return;
    }
    places.push_back(p);
    const auto zeros = zeros_.find(side);
    if (zeros == zeros_.end()) return;
    std::vector<ImagePoint> inside;
    for (const Zero& zero : zeros->second) inside.push_back(zero.place);
    const auto along = [&](const ImagePoint& z) { return std::abs(z.x - side.first.x) + std::abs(z.y - side.first.y); };
    std::ranges::sort(inside, {}, [&](const ImagePoint& z) { return std::tuple(along(z), z.x, z.y); });
    if (p != side.first) std::ranges::reverse(inside);
    places.insert(places.end(), inside.begin(), inside.end());
  }

  using SidePlaces = std::array<std::vector<ImagePoint>, 3>;

  void add_lit(const ImageTriangle& corners, const ChordCell& cell) {
    SidePlaces places;
    CellPolygon triangle;
    for (std::size_t side = 0; side < 3; ++side) {
      add_places(corners[side], corners[(side + 1) % 3], places[side]);
      places[side].push_back(corners[(side + 1) % 3]);
      triangle.push_back({corners[side], side, nullptr});
    }
    CellParts parts(corners);
    for (const ChordPart& image : cell.images) {
      const CellPolygon seen = parts.part_left_of(image, triangle);
      add_ring(seen, places, 1);
      for (const ChordPart& shadow : cell.shadows) add_ring(parts.part_left_of(shadow, seen), places, -1);
    }
  }

  void add_ring(const CellPolygon& polygon, const SidePlaces& places, int times) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const CellCorner& from = polygon[i];
      const ImagePoint& to = polygon[i + 1 == polygon.size() ? 0 : i + 1].place;
      if (from.side == no_side)
        segments_.add(from.place, to, times);
      else
        add_along(places[from.side], from.place, to, times);
    }
  }

  void add_along(const std::vector<ImagePoint>& places, const ImagePoint& from, const ImagePoint& to, int times) {
    const auto first = std::ranges::find(places, from);
    const auto last = std::find(first, places.end(), to);
    if (last == places.end()) {
      segments_.add(from, to, times);
      return;
    }
    for (auto place = first; place != last; ++place) segments_.add(*place, *(place + 1), times);
  }

  struct Zero {
    std::uint32_t line = 0;
    ImagePoint place;
  };

  const std::vector<LitCell>& cells_;
  const CellSides& halved_;
  std::unordered_map<CellSide, boost::container::small_vector<Zero, 2>, CellSideHash> zeros_;
  WoundSegments segments_;
};

}  // namespace

CellSide side_between(const ImagePoint& p, const ImagePoint& q) {
  return sweeps_before(p, q) ? CellSide{p, q} : CellSide{q, p};
}

std::size_t CellSideHash::operator()(const CellSide& side) const {
  std::uint64_t hash = 0;
  for (const std::int64_t c : {side.first.x, side.first.y, side.second.x, side.second.y})
    hash = (hash ^ static_cast<std::uint64_t>(c)) * 0x9e3779b97f4a7c15U ^ (hash >> 29U);
  return hash;
}

std::optional<ImagePoint> middle(const ImagePoint& p, const ImagePoint& q) {
  const std::int64_t x = p.x + q.x;
  const std::int64_t y = p.y + q.y;
  if (x % 2 != 0 || y % 2 != 0) return std::nullopt;
  return ImagePoint{x / 2, y / 2};
}

RegionBorder border_of_cells(const std::vector<LitCell>& cells, const CellSides& halved) {
  return CellBorders(cells, halved).run();
}

}  // namespace sightline::inline reflect
