#include "peers/pixels/warnock.h"

#include <algorithm>
#include <array>
#include <utility>

#include "peers/pixels/image_rectangle.h"
#include "peers/scene/nearest.h"

namespace sightline::peers {
namespace {

// A list of polygons is the first of them; links say who follows.
using List = PolygonNumber;

using Depths = std::array<double, 4>;

// Returns whether the first is nearer wherever both are over the rectangle: at no corner is it deeper.
bool is_closer(const Depths& p, const Depths& q, bool has_lower_index) {
  bool closer_somewhere = has_lower_index;
  for (std::size_t v = 0; v < 4; ++v) {
    if (!(p[v] <= q[v])) return false;
    closer_somewhere = closer_somewhere || p[v] < q[v];
  }
  return closer_somewhere;
}

class Subdivision {
 public:
  Subdivision(const FlatScene& scene, int resolution)
      : polygons_(scene.polygons), links_(scene.polygons.size(), no_polygon), framebuffer_(resolution) {
    for (const FlatPolygon& polygon : polygons_) extents_.push_back(extent_of(polygon.corners));
  }

  Outcome run() && {
    const PixelRange all{0, framebuffer_.resolution()};
    List ilist = no_polygon;
    for (PolygonNumber p = 0; p < polygons_.size(); ++p) push(ilist, p);
    warnock({all, all}, no_polygon, no_polygon, ilist);
    return {std::move(framebuffer_),
            {{"rectangles", rectangles_}, {"pixels decided alone", pixels_}, {"overlap tests", overlap_tests_}}};
  }

 private:
  void warnock(const Rectangle& r, List dlist, List slist, List& ilist) {
    if (r.empty()) return;
    ++rectangles_;
    const List shold = slist;
    const List dhold = dlist;
    distribute(r, dlist, slist, ilist);
    if ((slist != no_polygon || ilist != no_polygon) && !paint(r, slist, ilist)) {
      for (const Rectangle& part : parts_of(r)) warnock(part, dlist, slist, ilist);
    }
    give_back(slist, shold, ilist);
    give_back(dlist, dhold, ilist);
  }

  void distribute(const Rectangle& r, List& dlist, List& slist, List& ilist) {
    const Vertices vertices = vertices_of(r, framebuffer_.resolution());
    List rest = ilist;
    ilist = no_polygon;
    while (rest != no_polygon) {
      const PolygonNumber p = pop(rest);
      const Overlap overlap = overlap_of(polygons_[p].corners, extents_[p], vertices);
      ++overlap_tests_;
      if (overlap == Overlap::disjoint) push(dlist, p);
      if (overlap == Overlap::intersecting) push(ilist, p);
      if (overlap == Overlap::enclosing) push(slist, p);
    }
  }

  // Returns whether that was possible without subdividing.
  bool paint(const Rectangle& r, List slist, List ilist) {
    if (r.is_pixel()) {
      paint_pixel(r.columns.begin, r.rows.begin, slist, ilist);
      return true;
    }
    const PolygonNumber front = closest(r, slist, ilist);
    if (front == no_polygon) return false;
    for (int row = r.rows.begin; row < r.rows.end; ++row) {
      for (int column = r.columns.begin; column < r.columns.end; ++column) {
        framebuffer_.paint(column, row, polygons_[front].face);
      }
    }
    return true;
  }

  // Returns the member of slist that is closer than all others of slist and ilist, if there is one: then its depths at
  // the rectangle's corners come first in every order.
  PolygonNumber closest(const Rectangle& r, List slist, List ilist) const {
    const Vertices vertices = vertices_of(r, framebuffer_.resolution());
    if (slist == no_polygon) return no_polygon;
    std::pair front{depths_of(slist, vertices), slist};
    for (List p = slist; p != no_polygon; p = links_[p]) front = std::min(front, {depths_of(p, vertices), p});
    const bool hides_all = hides(front, slist, vertices) && hides(front, ilist, vertices);
    return hides_all ? front.second : no_polygon;
  }

  bool hides(const std::pair<Depths, PolygonNumber>& front, List list, const Vertices& vertices) const {
    for (List p = list; p != no_polygon; p = links_[p]) {
      if (p != front.second && !is_closer(front.first, depths_of(p, vertices), front.second < p)) return false;
    }
    return true;
  }

  Depths depths_of(PolygonNumber p, const Vertices& vertices) const {
    Depths depths{};
    for (std::size_t v = 0; v < 4; ++v) depths[v] = polygons_[p].plane.at(vertices[v].x, vertices[v].y);
    return depths;
  }

  void paint_pixel(int column, int row, List slist, List ilist) {
    const Point2 centre{framebuffer_.x_of(column), framebuffer_.y_of(row)};
    Nearest nearest;
    ++pixels_;
    for (const List list : {slist, ilist}) {
      for (List p = list; p != no_polygon; p = links_[p]) {
        if (covers(polygons_[p].corners, centre)) nearest.consider(p, polygons_[p].plane.at(centre.x, centre.y));
      }
    }
    if (nearest.found()) framebuffer_.paint(column, row, polygons_[nearest.polygon].face);
  }

  void push(List& list, PolygonNumber p) {
    links_[p] = list;
    list = p;
  }
  PolygonNumber pop(List& list) {
    const PolygonNumber first = list;
    list = links_[first];
    return first;
  }
  void give_back(List list, List hold, List& ilist) {
    while (list != hold) push(ilist, pop(list));
  }

  const std::vector<FlatPolygon>& polygons_;
  std::vector<Extent> extents_;       // per polygon
  std::vector<PolygonNumber> links_;  // per polygon: the next one of the list that it is in
  ItemBuffer framebuffer_;
  std::uint64_t rectangles_ = 0;
  std::uint64_t pixels_ = 0;
  std::uint64_t overlap_tests_ = 0;
};

}  // namespace

Peer warnock() {
  return {
      "warnock",
      "Warnock's area subdivision",
      "slides 001, \"Warnockov algoritem\"; slides 003, \"Warnock-ov postupak\"",
      ComputedAt::image_precision,
      "Looks at a rectangle of the image, first the whole of it. Where no polygon is in it, it stays background; where "
      "one polygon encloses it and is nearer than all others at its four corners, it is painted as a whole. Anything "
      "else is cut into four rectangles, down to single pixels, whose centres decide. Three lists of polygons, "
      "disjoint, enclosing and undecided, pass from each rectangle to its parts, so that a question that was answered "
      "once is not asked again.",
      "Its item buffer is that of ray casting: large empty or uniform areas cost little, but edges end in pixels, and "
      "there the centre decides. It follows hidden edges down to the pixel, too, where no enclosing polygon is "
      "known to be in front. So the steps along edges are the same as the z-buffer's, and the price of a finer image "
      "grows with the length of the edges instead of the area.",
      [](const FlatScene& scene, int resolution) { return Subdivision(scene, resolution).run(); }};
}

}  // namespace sightline::peers
