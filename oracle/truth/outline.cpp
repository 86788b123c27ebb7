#include "oracle/truth/outline.h"

namespace sightline::oracle::image {
namespace {

// Returns the line in the direction from p to q, which both lie on it: p x q is a multiple of it.
Line directed(const Line& line, const Point& p, const Point& q) {
  Integer multiple = line.a * (p.y * q.w - p.w * q.y);
  if (multiple == 0) multiple = line.b * (p.w * q.x - p.x * q.w);
  if (multiple == 0) multiple = line.c * (p.x * q.y - p.y * q.x);
  if (multiple == 0) return {};
  return multiple > 0 ? line : opposite(line);
}

// A side from p to q passes to the outer side at (p x q) x form = q (form . p) - p (form . q), a positive sum.
Point way_out(const Side& side, const Line& form) { return meeting_point(side.line, form); }
Point way_in(const Side& side, const Line& form) { return meeting_point(form, side.line); }

void direct_along(Outline& outline, const std::vector<std::size_t>& along) {
  for (const std::size_t i : along) {
    outline[i].line = directed(outline[i].line, outline[i].start, outline[(i + 1) % outline.size()].start);
  }
}

}  // namespace

Outline outline_of(const std::vector<Point>& corners) {
  Outline outline;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    outline.push_back({corners[i], line_through(corners[i], corners[(i + 1) % corners.size()])});
  }
  return outline;
}

Outline cut(const Outline& outline, const Line& form) {
  std::vector<int> sign;
  for (const Side& side : outline) sign.push_back(value(form, side.start).sign());
  Outline result;
  std::vector<std::size_t> along;  // the sides of the result that run along the cut
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const int here = sign[i];
    const int next = sign[(i + 1) % outline.size()];
    if (here >= 0) result.push_back(outline[i]);
    if (here > 0 && next < 0) result.push_back({way_out(outline[i], form), form});
    if (here >= 0 && next < 0) along.push_back(result.size() - 1);
    if (here < 0 && next > 0) result.push_back({way_in(outline[i], form), outline[i].line});
  }
  for (const std::size_t i : along) result[i].line = form;
  direct_along(result, along);
  return result;
}

Outline cut_to_window(const Outline& outline) {
  Outline result = outline;
  for (const Line& border : {Line{1, 0, 1}, Line{-1, 0, 1}, Line{0, 1, 1}, Line{0, -1, 1}})
    result = cut(result, border);
  return result;
}

Outline window() { return outline_of({{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}); }

}  // namespace sightline::oracle::image
