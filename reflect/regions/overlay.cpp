#include "reflect/regions/overlay.h"

#include <algorithm>
#include <span>

namespace sightline::inline reflect {
namespace {

bool before(const ImagePlace& a, const ImagePlace& b) { return sweep_compare(a, b) < 0; }
bool runs_down(const BorderPiece& piece) { return before(piece.start, piece.end); }
const ImagePlace& upper(const BorderPiece& piece) { return runs_down(piece) ? piece.start : piece.end; }
const ImagePlace& lower(const BorderPiece& piece) { return runs_down(piece) ? piece.end : piece.start; }

constexpr std::size_t pieces_per_band = 4;

double low_of(const BorderPiece& piece) { return std::min(piece.start.at.y, piece.end.at.y) - 1; }
double high_of(const BorderPiece& piece) { return std::max(piece.start.at.y, piece.end.at.y) + 1; }

// The index tells which pieces of a border may be met at a height of the image. Bands have equal height, and there are
// no more of them than pieces; a piece is in all that it touches, widened by a spacing, so that approximate places do.
class BandIndex {
 public:
  explicit BandIndex(const RegionBorder& border) : bands_(border.size() / pieces_per_band + 1) {
    if (border.empty()) return;
    bottom_ = low_of(border.front());
    double top = high_of(border.front());
    for (const BorderPiece& piece : border) {
      bottom_ = std::min(bottom_, low_of(piece));
      top = std::max(top, high_of(piece));
    }
    bands_per_unit_ = static_cast<double>(bands_.size()) / (top - bottom_);
    for (std::size_t i = 0; i < border.size(); ++i) {
      const auto [low, high] = bands_beside(border[i]);
      for (std::size_t band = low; band <= high; ++band) bands_[band].push_back(static_cast<std::uint32_t>(i));
    }
  }

  // Returns the pieces, by their place in the border, that may reach the height of p.
  [[nodiscard]] std::span<const std::uint32_t> at(const ImagePlace& p) const { return bands_[band_of(p.at.y)]; }

  // Calls visit(i) for the pieces that may reach a height of the piece; some more than once.
  template <class Visit>
  void for_each_beside(const BorderPiece& piece, Visit visit) const {
    const auto [low, high] = bands_beside(piece);
    for (std::size_t band = low; band <= high; ++band) {
      for (const std::uint32_t i : bands_[band]) visit(std::size_t{i});
    }
  }

 private:
  struct BandRange {
    std::size_t low;
    std::size_t high;
  };
  [[nodiscard]] BandRange bands_beside(const BorderPiece& piece) const {
    return {band_of(low_of(piece)), band_of(high_of(piece))};
  }
  [[nodiscard]] std::size_t band_of(double y) const {
    const double band = (y - bottom_) * bands_per_unit_;
    return band <= 0 ? 0 : std::min(static_cast<std::size_t>(band), bands_.size() - 1);
  }

  double bottom_ = 0;
  double bands_per_unit_ = 0;
  std::vector<std::vector<std::uint32_t>> bands_;
};

// A piece comes with the places where it is to be divided.
struct Divided {
  BorderPiece piece;
  std::vector<ImagePlace> places;

  void add_if_inside(const ImagePlace& p) {
    if (before(upper(piece), p) && before(p, lower(piece))) places.push_back(p);
  }
};

// The windings say how often a region's border winds around what is just left and just right of a piece. The sweep
// line, from left to right, enters the region where it crosses a piece that runs down.
struct Windings {
  int left = 0;
  int right = 0;
};

Windings windings_beside(const RegionBorder& border, const BandIndex& bands, const BorderPiece& piece) {
  const ImagePlace& p = upper(piece);
  Windings windings;
  for (const std::uint32_t i : bands.at(p)) {
    const BorderPiece& other = border[i];
    if (before(p, upper(other)) || !before(p, lower(other))) continue;
    const Sign at_point = side(other.line, p);
    const Sign of_piece = at_point != 0 ? at_point : turn(other.line, piece.line);
    if (of_piece < 0) continue;  // the piece is left of the other
    const int change = runs_down(other) ? 1 : -1;
    windings.right += change;
    if (of_piece > 0) windings.left += change;
  }
  return windings;
}

std::vector<Divided> divided(const RegionBorder& border) {
  std::vector<Divided> result;
  for (const BorderPiece& piece : border) result.push_back({piece, {}});
  return result;
}

void divide(Divided& s, Divided& t) {
  if (before(lower(s.piece), upper(t.piece)) || before(lower(t.piece), upper(s.piece))) return;
  const Sign s_start = side(t.piece.line, s.piece.start);
  const Sign s_end = side(t.piece.line, s.piece.end);
  const Sign t_start = side(s.piece.line, t.piece.start);
  const Sign t_end = side(s.piece.line, t.piece.end);
  if (s_start * s_end < 0 && t_start * t_end < 0) {
    const ImagePlace place = crossing_place(s.piece.line, t.piece.line);
    s.places.push_back(place);
    t.places.push_back(place);
    return;
  }
  if (s_start == 0) t.add_if_inside(s.piece.start);
  if (s_end == 0) t.add_if_inside(s.piece.end);
  if (t_start == 0) s.add_if_inside(t.piece.start);
  if (t_end == 0) s.add_if_inside(t.piece.end);
}

template <class Visit>
void for_each_part(Divided& divided, Visit visit) {
  std::ranges::sort(divided.places, before);
  if (!runs_down(divided.piece)) std::ranges::reverse(divided.places);
  divided.places.push_back(divided.piece.end);
  BorderPiece part{divided.piece.start, divided.piece.start, divided.piece.line};
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
      bands_of_first_.for_each_beside(t.piece, [&](std::size_t s) { divide(of_first[s], t); });
      bands_of_second_.for_each_beside(t.piece, [&](std::size_t s) {
        if (s < i) divide(of_second[s], t);
      });
    }
    for (Divided& s : of_first) for_each_part(s, [this](const BorderPiece& part) { add_of_first(part); });
    for (Divided& s : of_second) for_each_part(s, [this](const BorderPiece& part) { add_of_second(part); });
    drop_repeated();
    return std::move(result_);
  }

 private:
  void add_of_first(const BorderPiece& part) {
    const Windings of_second = windings_beside(second_, bands_of_second_, part);
    if ((runs_down(part) ? of_second.right : of_second.left) > 0) result_.push_back(part);
  }

  // Where a part runs along the first region's border, that border stands for it.
  void add_of_second(const BorderPiece& part) {
    const Windings of_second = windings_beside(second_, bands_of_second_, part);
    const bool down = runs_down(part);
    if ((down ? of_second.right : of_second.left) <= 0 || (down ? of_second.left : of_second.right) > 0) return;
    const Windings of_first = windings_beside(first_, bands_of_first_, part);
    if (of_first.left > 0 && of_first.right > 0) result_.push_back(part);
  }

  // Pieces of the second region may lie on each other.
  void drop_repeated() {
    const auto order = [](const BorderPiece& a, const BorderPiece& b) {
      const int start = sweep_compare(a.start, b.start);
      return start != 0 ? start < 0 : before(a.end, b.end);
    };
    const auto same = [](const BorderPiece& a, const BorderPiece& b) {
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
  const auto order = [](const BorderPiece& a, const BorderPiece& b) {
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
    for (Divided& s : all[i]) for_each_part(s, [&](const BorderPiece& part) { borders[i].push_back(part); });
  }
  return borders;
}

RegionBorder common_part(const RegionBorder& first, const RegionBorder& second) { return Overlay(first, second).run(); }

}  // namespace sightline::inline reflect
