#include "oracle/truth/image.h"

namespace sightline::oracle::image {

Line reduced(const Line& line) {
  const Integer divisor = gcd(gcd(line.a, line.b), line.c);
  return divisor <= 1 ? line : Line{line.a / divisor, line.b / divisor, line.c / divisor};
}

Point reduced(const Point& point) {
  const Integer divisor = gcd(gcd(point.x, point.y), point.w);
  return divisor <= 1 ? point : Point{point.x / divisor, point.y / divisor, point.w / divisor};
}

Integer value(const Line& line, const Point& point) { return line.a * point.x + line.b * point.y + line.c * point.w; }

Line line_through(const Point& p, const Point& q) {
  return reduced(Line{p.y * q.w - p.w * q.y, p.w * q.x - p.x * q.w, p.x * q.y - p.y * q.x});
}

Point meeting_point(const Line& l, const Line& m) {
  return {l.b * m.c - l.c * m.b, l.c * m.a - l.a * m.c, l.a * m.b - l.b * m.a};
}

Line opposite(const Line& line) { return {-line.a, -line.b, -line.c}; }

Point opposite(const Point& point) { return {-point.x, -point.y, -point.w}; }

}  // namespace sightline::oracle::image
