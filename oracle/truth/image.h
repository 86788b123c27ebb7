// Points and lines of the image are exact, in homogeneous integers.
//
// A point (x, y, w) is the place (x / w, y / w) in window units; a line (a, b, c) is where a x + b y + c w = 0, and its
// inner side is where that is positive. Both are the same for any positive factor.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>

namespace sightline::oracle::image {

using Integer = boost::multiprecision::cpp_int;

struct Point {
  Integer x;
  Integer y;
  Integer w;
};

struct Line {
  Integer a;
  Integer b;
  Integer c;
  friend bool operator==(const Line& l, const Line& m) { return l.a == m.a && l.b == m.b && l.c == m.c; }
};

// Divides by the numbers' greatest common divisor: then lines with one inner side are equal.
[[nodiscard]] Line reduced(const Line& line);
[[nodiscard]] Point reduced(const Point& point);

// Returns the line's form at the point: it is positive on the inner side of points with w > 0.
[[nodiscard]] Integer value(const Line& line, const Point& point);

// For places with w > 0, the inner side is to the left of the way from p to q.
[[nodiscard]] Line line_through(const Point& p, const Point& q);

// Precondition: the lines are not parallel; w has the sign of the turn from l to m.
[[nodiscard]] Point meeting_point(const Line& l, const Line& m);

[[nodiscard]] Line opposite(const Line& line);
[[nodiscard]] Point opposite(const Point& point);

}  // namespace sightline::oracle::image
