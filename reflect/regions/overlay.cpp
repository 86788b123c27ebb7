#include "reflect/regions/overlay.h"

#include <algorithm>
#include <span>

namespace sightline::inline reflect {
namespace {

bool before(const ImagePlace& a, const ImagePlace& b) { return sweep_compare(a, b) < 0; }
bool runs_down(const BorderSegment& segment) { return before(segment.start, segment.end); }
const ImagePlace& upper(const BorderSegment& segment) { return runs_down(segment) ? segment.start : segment.end; }
const ImagePlace& lower(const BorderSegment& segment) { return runs_down(segment) ? segment.end : segment.start; }

constexpr std::size_t segments_per_band = 4;

double low_of(const BorderSegment& segment) { return std::min(segment.start.at.y, segment.end.at.y) - 1; }
double high_of(const BorderSegment& segment) { return std::max(segment.start.at.y, segment.end.at.y) + 1; }

// The index tells which segments of a border may be met at a height of the image. Bands have equal height, and there are
// no more of them than segments; a segment is in all that it touches, widened by a spacing, so that approximate places do.
class BandIndex {
 public:
  explicit BandIndex(const RegionBorder& border) : bands_(border.size() / segments_per_band + 1) {
    if (border.empty()) return;
    bottom_ = low_of(border.front());
    double top = high_of(border.front());
    for (const BorderSegment& segment : border) {
      bottom_ = std::min(bottom_, low_of(segment));
      top = std::max(top, high_of(segment));
    }
    bands_per_unit_ = static_cast<double>(bands_.size()) / (top - bottom_);
    for (std::size_t i = 0; i < border.size(); ++i) {
      const auto [low, high] = bands_beside(border[i]);
      for (std::size_t band = low; band <= high; ++band) bands_[band].push_back(static_cast<std::uint32_t>(i));
    }
  }

  // Returns the segments, by their place in the border, that may reach the height of p.
  [[nodiscard]] std::span<const std::uint32_t> at(const ImagePlace& p) const { return bands_[band_of(p.at.y)]; }

  // Calls visit(i) for the segments that may reach a height of the segment; some more than once.
  template <class Visit>
  void for_each_beside(const BorderSegment& segment, Visit visit) const {
    const auto [low, high] = bands_beside(segment);
    for (std::size_t band = low; band <= high; ++band) {
      for (const std::uint32_t i : bands_[band]) visit(std::size_t{i});
    }
  }

 private:
  struct BandRange {
    std::size_t low;
    std::size_t high;
  };
  [[nodiscard]] BandRange bands_beside(const BorderSegment& segment) const {
    return {band_of(low_of(segment)), band_of(high_of(segment))};
  }
  [[nodiscard]] std::size_t band_of(double y) const {
    const double band = (y - bottom_) * bands_per_unit_;
    return band <= 0 ? 0 : std::min(static_cast<std::size_t>(band), bands_.size() - 1);
  }

  double bottom_ = 0;
  double bands_per_unit_ = 0;
  std::vector<std::vector<std::uint32_t>> bands_;
};

// A segment comes with the places where it is to be divided.
struct Divided {
  BorderSegment segment;
  std::vector<ImagePlace> places;

  void add_if_inside(const ImagePlace& p) {
    if (before(upper(segment), p) && before(p, lower(segment))) places.push_back(p);
  }
};

// The windings say how often a region's border winds around what is just left and just right of a segment. The sweep
// line, from left to right, enters the region where it crosses a segment that runs down.
struct Windings {
  int left = 0;
  int right = 0;
};

Windings windings_beside(const RegionBorder& border, const BandIndex& bands, const BorderSegment& segment) {
  const ImagePlace& p = upper(segment);
  Windings windings;
  for (const std::uint32_t i : bands.at(p)) {
    const BorderSegment& other = border[i];
    if (before(p, upper(other)) || !before(p, lower(other))) continue;
    const Sign at_point = side(other.line, p);
    const Sign of_segment = at_point != 0 ? at_point : turn(other.line, segment.line);
    if (of_segment < 0) continue;  // the segment is left of the other
    const int change = runs_down(other) ? 1 : -1;
    windings.right += change;
    if (of_segment > 0) windings.left += change;
  }
  return windings;
}

std::vector<Divided> divided(const RegionBorder& border) {
  std::vector<Divided> result;
  for (const BorderSegment& segment : border) result.push_back({segment, {}});
  return result;
}

// Places are off by less than a spacing.
bool is_beside(const BorderSegment& s, const BorderSegment& t) {
  const auto left = [](const BorderSegment& b) { return std::min(b.start.at.x, b.end.at.x); };
  const auto right = [](const BorderSegment& b) { return std::max(b.start.at.x, b.end.at.x); };
  return right(s) + 2 < left(t) || right(t) + 2 < left(s) || high_of(s) < low_of(t) || high_of(t) < low_of(s);
}

void divide(Divided& s, Divided& t) {
  if (is_beside(s.segment, t.segment)) return;
  if (before(lower(s.segment), upper(t.segment)) || before(lower(t.segment), upper(s.segment))) return;
  const Sign s_start = side(t.segment.line, s.segment.start);
  const Sign s_end = side(t.segment.line, s.segment.end);
  const Sign t_start = side(s.segment.line, t.segment.start);
  const Sign t_end = side(s.segment.line, t.segment.end);
  if (s_start * s_end < 0 && t_start * t_end < 0) {
    const ImagePlace place = crossing_place(s.segment.line, t.segment.line);
    s.places.push_back(place);
    t.places.push_back(place);
    return;
  }
  if (s_start == 0) t.add_if_inside(s.segment.start);
  if (s_end == 0) t.add_if_inside(s.segment.end);
  if (t_start == 0) s.add_if_inside(t.segment.start);
  if (t_end == 0) s.add_if_inside(t.segment.end);
}

template <class Visit>
void for_each_part(Divided& divided, Visit visit) {
  std::ranges::sort(divided.places, before);
  if (!runs_down(divided.segment)) std::ranges::reverse(divided.places);
  divided.places.push_back(divided.segment.end);
  BorderSegment part{divided.segment.start, divided.segment.start, divided.segment.line};
  for (const ImagePlace& p : divided.places) {
    if (sweep_compare(part.start, p) == 0) continue;
    part.end = p;
    visit(part);
    part.start = p;
  }
}

class Overlay {
 public:
  Overlay(const RegionBorder& first, const RegionBorder& second)
      : first_(first), second_(second), bands_of_first_(first), bands_of_second_(second) {}

  RegionBorder run() {
    std::vector<Divided> of_first = divided(first_);
    std::vector<Divided> of_second = divided(second_);
    for (std::size_t i = 0; i < of_second.size(); ++i) {
      Divided& t = of_second[i];
      bands_of_first_.for_each_beside(t.segment, [&](std::size_t s) { divide(of_first[s], t); });
      bands_of_second_.for_each_beside(t.segment, [&](std::size_t s) {
        if (s < i) divide(of_second[s], t);
      });
    }
    for (Divided& s : of_first) for_each_part(s, [this](const BorderSegment& part) { add_of_first(part); });
    for (Divided& s : of_second) for_each_part(s, [this](const BorderSegment& part) { add_of_second(part); });
    drop_repeated();
    return std::move(result_);
  }

 private:
  void add_of_first(const BorderSegment& part) {
    const Windings of_second = windings_beside(second_, bands_of_second_, part);
    if ((runs_down(part) ? of_second.right : of_second.left) > 0) result_.push_back(part);
  }

  // Where a part runs along the first region's border, that border stands for it.
  void add_of_second(const BorderSegment& part) {
    const Windings of_second = windings_beside(second_, bands_of_second_, part);
    const bool down = runs_down(part);
    if ((down ? of_second.right : of_second.left) <= 0 || (down ? of_second.left : of_second.right) > 0) return;
    const Windings of_first = windings_beside(first_, bands_of_first_, part);
    if (of_first.left > 0 && of_first.right > 0) result_.push_back(part);
  }

  // Segments of the second region may lie on each other.
  void drop_repeated() {
    const auto order = [](const BorderSegment& a, const BorderSegment& b) {
      const int start = sweep_compare(a.start, b.start);
      return start != 0 ? start < 0 : before(a.end, b.end);
    };
    const auto same = [](const BorderSegment& a, const BorderSegment& b) {
      return sweep_compare(a.start, b.start) == 0 && sweep_compare(a.end, b.end) == 0;
    };
    std::ranges::stable_sort(result_, order);
    result_.erase(std::unique(result_.begin(), result_.end(), same), result_.end());
  }

  const RegionBorder& first_;
  const RegionBorder& second_;
  const BandIndex bands_of_first_;
  const BandIndex bands_of_second_;
  RegionBorder result_;
};

}  // namespace

RegionBorder without_seams(RegionBorder border) {
  const auto order = [](const BorderSegment& a, const BorderSegment& b) {
    const int uppers = sweep_compare(upper(a), upper(b));
    return uppers != 0 ? uppers < 0 : before(lower(a), lower(b));
  };
  std::ranges::stable_sort(border, order);
  RegionBorder result;
  for (auto first = border.begin(); first != border.end();) {
    const auto end = std::upper_bound(first, border.end(), *first, order);
    const auto up = std::stable_partition(first, end, runs_down);
    const auto seams = std::min(up - first, end - up);
    result.insert(result.end(), first + seams, up);
    result.insert(result.end(), up + seams, end);
    first = end;
  }
  return result;
}

std::vector<RegionBorder> divided_at_meetings(std::vector<RegionBorder> borders) {
  std::vector<std::vector<Divided>> all;
  for (const RegionBorder& border : borders) all.push_back(divided(border));
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (Divided& s : all[i]) {
        for (Divided& t : all[j]) divide(s, t);
      }
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    borders[i].clear();
    for (Divided& s : all[i]) for_each_part(s, [&](const BorderSegment& part) { borders[i].push_back(part); });
  }
  return borders;
}

RegionBorder common_part(const RegionBorder& first, const RegionBorder& second) { return Overlay(first, second).run(); }

}  // namespace sightline::inline reflect
