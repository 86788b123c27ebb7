#include "peers/lines/floating_horizon.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/projection/camera_forms.h"
#include "peers/lines/cohen_sutherland.h"
#include "peers/lines/height_field.h"

namespace sightline::peers {
namespace {

// These are the window's columns, from left to right.
class Columns {
 public:
  explicit Columns(int resolution) : count_(resolution) {}

  [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(count_); }
  [[nodiscard]] double border(int column) const { return 2.0 * column / count_ - 1; }  // its left one
  [[nodiscard]] double centre(int column) const { return (2 * column + 1.0) / count_ - 1; }
  [[nodiscard]] int around(double x) const {
    const double column = std::floor((x + 1) / 2 * count_);
    return static_cast<int>(std::clamp(column, 0.0, count_ - 1.0));
  }

  // Calls visit(column, y) where the line from a to b meets the columns' centres.
  template <class Visit>
  void for_each_on(const Point2& a, const Point2& b, Visit visit) const {
    const auto [least, most] = std::minmax(a.x, b.x);
    for (int column = around(least); column <= around(most); ++column) {
      const double x = centre(column);
      if (x < least || x > most) continue;
      visit(column, std::lerp(a.y, b.y, a.x == b.x ? 0 : (x - a.x) / (b.x - a.x)));
      if (a.x == b.x) visit(column, b.y);
    }
  }

 private:
  int count_;
};

struct Horizon {
  explicit Horizon(const Columns& columns)
      : YMAX(columns.count(), -std::numeric_limits<double>::infinity()),
        YMIN(columns.count(), std::numeric_limits<double>::infinity()) {}

  [[nodiscard]] bool shows(int column, double y) const {
    const auto c = static_cast<std::size_t>(column);
    return y >= YMAX[c] || y <= YMIN[c];
  }
  void enter(int column, double y) {
    const auto c = static_cast<std::size_t>(column);
    YMAX[c] = std::max(YMAX[c], y);
    YMIN[c] = std::min(YMIN[c], y);
  }

  std::vector<double> YMAX;
  std::vector<double> YMIN;
};

class Drawing {
 public:
  Drawing(const FlatScene& scene, int resolution) : scene_(scene), columns_(resolution), horizon_(columns_) {}

  Outcome draw(const HeightField& field) {
    for (std::size_t i = 0; i < field.polylines.size(); ++i) {
      const std::vector<Point2> polyline = image_of(field.polylines[i]);
      draw_seen(polyline);
      for (std::size_t p = 0; p + 1 < polyline.size(); ++p) enter(polyline[p], polyline[p + 1]);
      for (const auto& ends : field.joins[i]) enter(image_of(ends[0]), image_of(ends[1]));
    }
    return {std::move(lines_), {{"polylines", field.polylines.size()}, {"columns touched", touched_}}};
  }

 private:
  [[nodiscard]] Point2 image_of(VertexId vertex) const {
    const CameraPlace<double> place = CameraForms<double>(scene_.projected->camera).at(scene_.mesh->position(vertex));
    return {place.x / place.w, place.y / place.w};
  }

  [[nodiscard]] std::vector<Point2> image_of(const std::vector<VertexId>& polyline) const {
    std::vector<Point2> image;
    for (const VertexId v : polyline) image.push_back(image_of(v));
    if (image.front().x > image.back().x) std::reverse(image.begin(), image.end());
    return image;
  }

  void draw_seen(const std::vector<Point2>& polyline) {
    std::vector<bool> is_seen(columns_.count(), false);
    for (std::size_t p = 0; p + 1 < polyline.size(); ++p) {
      columns_.for_each_on(polyline[p], polyline[p + 1], [&](int column, double y) {
        is_seen[static_cast<std::size_t>(column)] = horizon_.shows(column, y);
      });
    }
    for (std::size_t p = 0; p + 1 < polyline.size(); ++p) draw_seen(polyline[p], polyline[p + 1], is_seen);
  }

  // Draws a part for each run of columns in which the polyline is seen.
  void draw_seen(const Point2& a, const Point2& b, const std::vector<bool>& is_seen) {
    const int last = columns_.around(b.x);
    for (int column = columns_.around(a.x); column <= last; ++column) {
      if (!is_seen[static_cast<std::size_t>(column)]) continue;
      const double begin = columns_.border(column);
      while (column < last && is_seen[static_cast<std::size_t>(column) + 1]) ++column;
      draw_part(a, b, std::max(begin, a.x), std::min(columns_.border(column + 1), b.x));
    }
  }

  void draw_part(const Point2& a, const Point2& b, double from_x, double to_x) {
    if (!(from_x < to_x)) return;
    const auto at = [&](double x) { return Point2{x, std::lerp(a.y, b.y, (x - a.x) / (b.x - a.x))}; };
    if (const auto part = cohen_sutherland({at(from_x), at(to_x)}, Window{})) lines_.push_back({part->from, part->to});
  }

  void enter(const Point2& a, const Point2& b) {
    columns_.for_each_on(a, b, [this](int column, double y) {
      horizon_.enter(column, y);
      ++touched_;
    });
  }

  const FlatScene& scene_;
  Columns columns_;
  Horizon horizon_;
  VisibleLines lines_;
  std::uint64_t touched_ = 0;
};

Outcome draw_height_field(const FlatScene& scene, int resolution) {
  return Drawing(scene, resolution).draw(height_field(scene));
}

}  // namespace

Peer floating_horizon() {
  return {
      "floating-horizon",
      "Horizon line algorithm",
      "slides 004, Horizon Line Algorithm",
      ComputedAt::image_precision,
      "Draws a height field as lines, the nearest first. For each column of the picture it remembers how high and how "
      "low the lines have come so far, the horizon. Of the next line only what is above or below the horizon is "
      "drawn; then the line raises the horizon, and so do the edges of the surface up to the line behind it.",
      "It decides once per column, so the parts that it draws end up to half a column too early or too late, and what "
      "happens between the middles of two columns is missed. It works on height fields only, and only where the "
      "picture's "
      "columns are upright planes: it refuses everything else.",
      draw_height_field};
}

}  // namespace sightline::peers
