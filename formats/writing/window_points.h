// The places of a view's points in the window, for the writers: computed once, since each crossing costs wide integers.
//
// Out: per point (scene points, then crossings) its x and y in [-1, 1], the exact value rounded to double.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "formats/writing/text_buffer.h"
#include "geometry/numbers/export.h"
#include "sightline/view.h"

namespace sightline::inline formats {

[[nodiscard]] SIGHTLINE_EXPORT std::vector<Point2> window_points(const View& view);

// Returns these places as pixels of the image that the camera's lens bends. Precondition: it has one.
[[nodiscard]] SIGHTLINE_EXPORT std::vector<Point2> bent_pixels(const Camera& camera, const std::vector<Point2>& places);

// Returns the place of a point that the camera sees, in floating point.
[[nodiscard]] SIGHTLINE_EXPORT Point2 window_place(const Camera& camera, const Point3& p);

// These places as text, as TextBuffer writes them, for writers that name each point several times: a number is put into
// digits once.
class PlaceTexts {
 public:
  explicit PlaceTexts(const std::vector<Point2>& places) {
    TextBuffer text;
    begin_.reserve(2 * places.size() + 1);
    for (const Point2& place : places) {
      for (const double coordinate : {place.x, place.y}) {
        begin_.push_back(text.size());
        text << coordinate;
      }
    }
    begin_.push_back(text.size());
    text_ = text.take();
  }

  [[nodiscard]] std::string_view x(PointId p) const { return number(2 * p.index()); }
  [[nodiscard]] std::string_view y(PointId p) const { return number(2 * p.index() + 1); }

 private:
  [[nodiscard]] std::string_view number(std::size_t i) const {
    return std::string_view(text_).substr(begin_[i], begin_[i + 1] - begin_[i]);
  }

  std::string text_;
  std::vector<std::size_t> begin_;  // per coordinate and one more
};

}  // namespace sightline::inline formats
