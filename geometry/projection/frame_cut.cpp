#include "geometry/projection/frame_cut.h"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/cutting/mesh_of_pieces.h"
#include "geometry/mesh/facet_plane.h"
#include "geometry/numbers/bounded.h"
#include "geometry/numbers/mix.h"
#include "geometry/numbers/parallel.h"
#include "geometry/projection/camera_forms.h"

namespace sightline::inline geometry {
namespace {

constexpr int frame_bits = 48;  // corners of frames are multiples of 2^-48

// A rectangle of the window.
struct WindowBox {
  double left = std::numeric_limits<double>::infinity();
  double right = -std::numeric_limits<double>::infinity();
  double bottom = std::numeric_limits<double>::infinity();
  double top = -std::numeric_limits<double>::infinity();

  void add(double x, double y, double radius) {
    left = std::min(left, x - radius);
    right = std::max(right, x + radius);
    bottom = std::min(bottom, y - radius);
    top = std::max(top, y + radius);
  }
  [[nodiscard]] bool meets(const WindowBox& other) const {
    return left <= other.right && other.left <= right && bottom <= other.top && other.bottom <= top;
  }
  [[nodiscard]] bool is_inside(const WindowBox& other) const {
    return left > other.left && right < other.right && bottom > other.bottom && top < other.top;
  }
};

// Makes planes through the eye of lines of the window: a x + b y + c > 0 is in front.
class EyePlanes {
 public:
  explicit EyePlanes(const Camera& camera)
      : exponent_(common_exponent(camera)), forms_(integer_forms(camera, exponent_)) {}

  // X = right . (v - origin) and so on, where rows and origin are integers times 2^exponent.
  [[nodiscard]] ExactPlane of(const BigInteger& a, const BigInteger& b, const BigInteger& c) const {
    const ExactVector normal = a * forms_.right + b * forms_.up + c * forms_.forward;
    const BigInteger offset = -dot(normal, forms_.origin);
    const auto shift = static_cast<unsigned>(std::abs(exponent_));
    if (exponent_ >= 0) return {normal, offset << shift};
    return {normal.unaryExpr([shift](const BigInteger& n) { return BigInteger(n << shift); }), offset};
  }

 private:
  int exponent_;
  CameraForms<BigInteger> forms_;
};

// A side of the frame, with what is inside to its left.
struct FrameSide {
  Point2 from;
  Point2 to;
  ExactPlane line;    // in front: left of it
  ExactPlane after;   // in front: beyond its start
  ExactPlane before;  // in front: before its end
  ExactPlane level;   // in front: above its start
  WindowBox box;
};

class Frame {
 public:
  explicit Frame(const Camera& camera) : planes_(camera) {
    const std::vector<Point2>& corners = camera.lens_image->frame;
    for (std::size_t i = 0; i < corners.size(); ++i)
      sides_.push_back(side(corners[i], corners[(i + 1) % corners.size()]));
    window_ = {planes_.of(1, 0, 1), planes_.of(-1, 0, 1), planes_.of(0, 1, 1), planes_.of(0, -1, 1)};
    find_inner_box();
  }

  [[nodiscard]] const std::vector<FrameSide>& sides() const { return sides_; }
  [[nodiscard]] const WindowBox& inner_box() const { return inner_box_; }

  // Returns what of the polygon is in the window.
  [[nodiscard]] CutPolygon in_window(CutPolygon polygon) const {
    for (const ExactPlane& bound : window_) {
      if (!polygon.empty()) polygon = part_in_front(polygon, bound);
    }
    return polygon;
  }

  // Counts the sides that a ray to the right meets. Precondition: the place is in the window, and not on the frame.
  [[nodiscard]] bool has(const ExactPosition& p) const {
    bool inside = false;
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      const bool from_below = sides_[i].level.side(p) >= 0;
      const bool to_below = sides_[i + 1 == sides_.size() ? 0 : i + 1].level.side(p) >= 0;
      if (from_below == to_below) continue;
      if ((sides_[i].line.side(p) > 0) == from_below) inside = !inside;
    }
    return inside;
  }

  // The same in double; nothing where it is not certain.
  [[nodiscard]] std::optional<bool> certainly_has(const Bounded& x, const Bounded& y) const {
    bool inside = false;
    for (const FrameSide& s : sides_) {
      const auto above_from = certain_sign(y - Bounded(s.from.y));
      const auto above_to = certain_sign(y - Bounded(s.to.y));
      if (!above_from || !above_to) return std::nullopt;
      if ((*above_from >= 0) == (*above_to >= 0)) continue;
      const auto left = certain_sign((Bounded(s.to.x) - s.from.x) * (y - Bounded(s.from.y)) -
                                     (Bounded(s.to.y) - s.from.y) * (x - Bounded(s.from.x)));
      if (!left) return std::nullopt;
      if ((*left > 0) == (*above_from >= 0)) inside = !inside;
    }
    return inside;
  }

 private:
  [[nodiscard]] FrameSide side(const Point2& from, const Point2& to) const {
    const auto on_grid = [](double c) { return BigInteger(static_cast<std::int64_t>(std::ldexp(c, frame_bits))); };
    const BigInteger one = BigInteger(1) << frame_bits;
    const BigInteger x0 = on_grid(from.x);
    const BigInteger y0 = on_grid(from.y);
    const BigInteger x1 = on_grid(to.x);
    const BigInteger y1 = on_grid(to.y);
    const BigInteger dx = x1 - x0;
    const BigInteger dy = y1 - y0;
    FrameSide s{from,
                to,
                planes_.of(-dy * one, dx * one, x0 * y1 - x1 * y0),
                planes_.of(dx * one, dy * one, -(dx * x0 + dy * y0)),
                planes_.of(-dx * one, -dy * one, dx * x1 + dy * y1),
                planes_.of(0, one, -y0),
                {}};
    s.box.add(from.x, from.y, 0);
    s.box.add(to.x, to.y, 0);
    return s;
  }

  // A rectangle that no side of the frame enters, around the window's middle, if that is in the frame: it is narrowed at the
  // side that costs less of it.
  void find_inner_box() {
    inner_box_ = {-1, 1, -1, 1};
    for (const FrameSide& s : sides_) {
      if (!s.box.meets(inner_box_)) continue;
      const double x_reach = std::max(s.box.left, -s.box.right);  // positive where all of the side is beside the middle
      const double y_reach = std::max(s.box.bottom, -s.box.top);
      if (x_reach <= 0 && y_reach <= 0) {
        inner_box_ = {};
        return;
      }
      if (x_reach >= y_reach) {
        (s.box.left > 0 ? inner_box_.right : inner_box_.left) = s.box.left > 0 ? s.box.left : s.box.right;
      } else {
        (s.box.bottom > 0 ? inner_box_.top : inner_box_.bottom) = s.box.bottom > 0 ? s.box.bottom : s.box.top;
      }
    }
    if (certainly_has(Bounded(0.0), Bounded(0.0)) != true) inner_box_ = {};
  }

  EyePlanes planes_;
  std::vector<FrameSide> sides_;
  std::vector<ExactPlane> window_;
  WindowBox inner_box_;
};

// What the frame does to one facet.
struct FramedFacet {
  std::vector<CutPolygon> pieces;     // none where it stays whole
  std::vector<std::uint8_t> outside;  // per piece, or of the whole
};

// A place inside a convex polygon.
ExactPosition middle_of(const CutPolygon& polygon) {
  ExactPosition sum{ExactVector::Zero(), 1};
  for (const CutCorner& corner : polygon) {
    sum.xyz = sum.xyz * corner.position.w + corner.position.xyz * sum.w;
    sum.w *= corner.position.w;
  }
  sum.w *= polygon.size();
  return sum;
}

// A place of the window, known up to its radii.
struct BoundedPlace {
  Bounded x;
  Bounded y;
};

// Returns where the points are seen; nothing where not all of them are known to be before the eye.
using BoundedPlaces = boost::container::small_vector<BoundedPlace, 8>;
std::optional<BoundedPlaces> places_of(const CameraForms<Bounded>& forms, std::span<const BoundedVector> points) {
  BoundedPlaces places;
  for (const BoundedVector& p : points) {
    const CameraPlace<Bounded> place = forms.at(p);
    if (!place.w.is_positive()) return std::nullopt;
    places.push_back({place.x / place.w, place.y / place.w});
    if (!std::isfinite(places.back().x.radius) || !std::isfinite(places.back().y.radius)) return std::nullopt;
  }
  return places;
}

WindowBox box_around(const BoundedPlaces& places) {
  WindowBox box;
  for (const BoundedPlace& p : places)
    box.add(p.x.value, p.y.value, Bounded::widened(std::max(p.x.radius, p.y.radius)));
  return box;
}

// The middle of a convex polygon's corners is inside it.
BoundedPlace middle_of(const BoundedPlaces& places) {
  BoundedPlace sum;
  for (const BoundedPlace& p : places) sum = {sum.x + p.x, sum.y + p.y};
  const Bounded count(static_cast<double>(places.size()));
  return {sum.x / count, sum.y / count};
}

// Returns whether the side is known not to enter the convex polygon: all of this lies on one side of its line, before its
// start or beyond its end.
bool passes_by(const FrameSide& side, const BoundedPlaces& polygon) {
  const Bounded dx = Bounded(side.to.x) - side.from.x;
  const Bounded dy = Bounded(side.to.y) - side.from.y;
  bool left = true;
  bool right = true;
  bool before = true;
  bool beyond = true;
  for (const BoundedPlace& p : polygon) {
    const Bounded across = dx * (p.y - side.from.y) - dy * (p.x - side.from.x);
    left = left && across.is_positive();
    right = right && across.is_negative();
    before = before && (dx * (p.x - side.from.x) + dy * (p.y - side.from.y)).is_negative();
    beyond = beyond && (dx * (p.x - side.to.x) + dy * (p.y - side.to.y)).is_positive();
  }
  return left || right || before || beyond;
}

class FramedFacets {
 public:
  FramedFacets(const CutMesh& mesh, const Camera& camera) : mesh_(mesh), forms_(camera), frame_(camera) {}

  [[nodiscard]] FramedFacet framed(FacetId f) const {
    std::vector<BoundedVector> corners;
    for (const VertexId v : mesh_.corners(f)) corners.push_back(bounded(mesh_.position(v)));
    const auto places = places_of(forms_, corners);
    if (places) {
      const WindowBox box = box_around(*places);
      if (!box.meets({-1, 1, -1, 1})) return {{}, {1}};
      if (box.is_inside(frame_.inner_box())) return {{}, {0}};
    }
    FramedFacet result;
    result.pieces = pieces_of(f, places);
    if (result.pieces.empty()) result.outside.push_back(is_outside(facet_polygon(mesh_, f)) ? 1 : 0);
    for (const CutPolygon& piece : result.pieces) result.outside.push_back(is_outside(piece) ? 1 : 0);
    return result;
  }

 private:
  struct EnteringSide {
    std::size_t number;
    Chord chord;
  };

  // Cutters come in an order that is as good as random: then few planes are looked at for each.
  [[nodiscard]] std::vector<CutPolygon> pieces_of(FacetId f, const std::optional<BoundedPlaces>& places) const {
    std::vector<EnteringSide> entering = entering_sides(f, places);
    if (entering.empty()) return {};
    std::ranges::sort(entering, {}, [](const EnteringSide& e) { return mix(e.number); });
    std::vector<Cutter> cutters;
    for (const EnteringSide& e : entering) cutters.push_back({&frame_.sides()[e.number].line, &e.chord});
    return cut_facet(facet_polygon(mesh_, f), cutters);
  }

  // Where it is not known that all of the facet is before the eye, what is in the window is.
  [[nodiscard]] std::vector<EnteringSide> entering_sides(FacetId f, const std::optional<BoundedPlaces>& places) const {
    const CutPolygon whole = facet_polygon(mesh_, f);
    const CutPolygon seen = places ? whole : frame_.in_window(whole);
    std::vector<EnteringSide> entering;
    for (std::size_t i = 0; i < frame_.sides().size() && !seen.empty(); ++i) {
      const FrameSide& side = frame_.sides()[i];
      if (places && passes_by(side, *places)) continue;
      if (auto chord = chord_of(side, seen)) entering.push_back({i, std::move(*chord)});
    }
    return entering;
  }

  // Returns where a side of the frame runs inside the polygon; nothing where it does not.
  [[nodiscard]] static std::optional<Chord> chord_of(const FrameSide& side, const CutPolygon& polygon) {
    CutPolygon part = part_in_front(polygon, side.after);
    if (!part.empty()) part = part_in_front(part, side.before);
    const auto has_corner_at = [&](Sign wanted) {
      return std::ranges::any_of(part, [&](const CutCorner& c) { return side.line.side(c.position) == wanted; });
    };
    if (!has_corner_at(1) || !has_corner_at(-1)) return std::nullopt;
    return meet(part, side.line);
  }

  // Precondition: no side of the frame enters the polygon.
  [[nodiscard]] bool is_outside(const CutPolygon& polygon) const {
    std::vector<BoundedVector> corners;
    for (const CutCorner& corner : polygon) {
      corners.push_back(corner.vertex.valid() ? bounded(mesh_.position(corner.vertex))
                                              : rounded_once(corner.position.rounded()));
    }
    if (const auto places = places_of(forms_, corners)) {
      const BoundedPlace middle = middle_of(*places);
      if (const auto has = frame_.certainly_has(middle.x, middle.y)) return !*has;
    }
    const CutPolygon seen = frame_.in_window(polygon);
    return seen.empty() || !frame_.has(middle_of(seen));
  }

  [[nodiscard]] static BoundedVector rounded_once(const Point3& p) {
    return p.unaryExpr([](double c) { return Bounded{c, Bounded::widened(unit_roundoff * std::fabs(c))}; });
  }

  const CutMesh& mesh_;
  const CameraForms<Bounded> forms_;
  const Frame frame_;
};

}  // namespace

CutMesh cut_along_frame(const CutMesh& mesh, const Camera& camera) {
  const FramedFacets frame(mesh, camera);
  std::vector<FramedFacet> framed(mesh.facet_count());
  parallel_for_each(framed.size(), 64, [&](std::size_t f) { framed[f] = frame.framed(FacetId(f)); });
  std::vector<std::vector<CutPolygon>> pieces(framed.size());
  std::vector<std::uint8_t> outside;
  bool any = false;
  for (std::size_t f = 0; f < framed.size(); ++f) {
    any = any || !framed[f].pieces.empty();
    pieces[f] = std::move(framed[f].pieces);
    outside.insert(outside.end(), framed[f].outside.begin(), framed[f].outside.end());
  }
  CutMesh cut = any ? mesh_of_pieces(mesh, pieces) : mesh;
  cut.cuts.outside_frame = std::move(outside);
  cut.snapped_to = mesh.snapped_to;
  return cut;
}

FacetId surface_before_frame(const CutMesh& mesh, FacetId surface) {
  if (mesh.cuts.outside_frame.empty() || !surface.valid()) return surface;
  return FacetId(mesh.uncut_facet(surface).index());
}

}  // namespace sightline::inline geometry
