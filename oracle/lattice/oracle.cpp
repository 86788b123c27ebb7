#include "oracle/lattice/oracle.h"

#include <algorithm>
#include <stdexcept>

namespace sightline::lattice {
namespace {

using boost::multiprecision::cpp_int;

cpp_int to_integer(Int128 value) { return cpp_int(value); }

Rational fraction(Int128 numerator, Int128 denominator) { return {to_integer(numerator), to_integer(denominator)}; }

Rational x_of(const Rise& rise, const Fraction& y) {
  const Place place = place_on(rise, y);
  return fraction(place.x, place.denominator);
}

// A tower is a run of trapezoids on top of each other between the same rises, all with the same face in front.
struct Tower {
  std::size_t left;
  std::size_t right;
  std::size_t front;
  Fraction bottom;
};

Rational area_of(const Tower& tower, const Fraction& top, const std::vector<Rise>& rises) {
  const auto width = [&](const Fraction& y) { return x_of(rises[tower.right], y) - x_of(rises[tower.left], y); };
  const Rational height =
      fraction(top.numerator, top.denominator) - fraction(tower.bottom.numerator, tower.bottom.denominator);
  return height * (width(tower.bottom) + width(top)) / 2;
}

bool comes_first_in_plane(const OracleFace& a, const OracleFace& b) {
  return a.is_front == b.is_front ? a.number < b.number : a.is_front;
}

std::size_t front_of(const std::vector<OracleFace>& faces, const std::vector<Rise>& rises, const Slab& slab,
                     const Trapezoid& trapezoid) {
  const Fraction y{slab.bottom.numerator * slab.top.denominator + slab.top.numerator * slab.bottom.denominator,
                   2 * slab.bottom.denominator * slab.top.denominator};
  const Place place = middle(place_on(rises[trapezoid.left], y), place_on(rises[trapezoid.right], y));
  std::size_t best = trapezoid.inside.front();
  for (const std::size_t f : trapezoid.inside) {
    if (best == faces.size()) best = f;
    if (f == faces.size()) continue;
    const int order = nearer(faces[f].plane, faces[best].plane, place);
    if (order > 0 || (order == 0 && comes_first_in_plane(faces[f], faces[best]))) best = f;
  }
  return best;
}

// Returns the trapezoids of a slab, joined where neighbours show the same face number.
std::vector<Tower> joined(const std::vector<OracleFace>& faces, std::size_t numbers, const std::vector<Rise>& rises,
                          const Slab& slab) {
  std::vector<Tower> result;
  for (const Trapezoid& t : slab.trapezoids) {
    if (t.inside.empty()) continue;
    const std::size_t front = front_of(faces, rises, slab, t);
    const std::size_t number = front == faces.size() ? numbers : faces[front].number;
    if (!result.empty() && result.back().front == number && result.back().right == t.left) {
      result.back().right = t.right;
    } else {
      result.push_back({t.left, t.right, number, slab.bottom});
    }
  }
  return result;
}

// Goes on with the towers of the slab below where they have the same walls; adds up those that end.
void stack(std::vector<Tower>& standing, std::vector<Tower> next, const Fraction& y, const std::vector<Rise>& rises,
           std::vector<Rational>& area) {
  const auto same = [](const Tower& a, const Tower& b) {
    return a.left == b.left && a.right == b.right && a.front == b.front;
  };
  for (const Tower& old : standing) {
    const auto goes_on = std::find_if(next.begin(), next.end(), [&](const Tower& t) { return same(t, old); });
    if (goes_on != next.end()) {
      goes_on->bottom = old.bottom;
    } else {
      area[old.front] += area_of(old, y, rises);
    }
  }
  standing = std::move(next);
}

std::vector<CameraPoint> in_camera_space(const PolygonMesh& mesh, std::span<const VertexId> corners,
                                         const Camera& camera) {
  std::vector<CameraPoint> result;
  for (const VertexId v : corners) result.push_back(to_camera_space(camera, mesh.position(v)));
  return result;
}

void add(std::vector<OracleFace>& faces, std::size_t number, const std::vector<CameraPoint>& corners, Sides sides) {
  const int turn = facing(corners);
  if (turn == 0 || (sides == Sides::front && turn < 0)) return;
  const auto ring = clipped_image_of(corners);
  const auto plane = plane_of(corners);
  if (!ring || !plane) throw std::logic_error("face " + std::to_string(number) + " is not on the oracle's grid");
  if (ring->size() >= 3) faces.push_back({number, *ring, *plane, turn > 0});
}

}  // namespace

// The nearness is -(a x + b y + d) / c; image coordinates are in oracle units, hence the factor half_window at d.
int nearer(const Plane& a, const Plane& b, const Place& place) {
  const auto height = [&](const Plane& p) {
    return Wide(Wide(p.a) * Wide(place.x) + Wide(p.b) * Wide(place.y) +
                Wide(p.d) * half_window * Wide(place.denominator));
  };
  const Wide difference = height(b) * a.c - height(a) * b.c;
  const int sign = difference.sign();
  return (a.c > 0) == (b.c > 0) ? sign : -sign;
}

Visibility visibility(const std::vector<OracleFace>& faces, std::size_t numbers) {
  std::vector<Ring> rings;
  for (const OracleFace& face : faces) rings.push_back(face.ring);
  constexpr std::int64_t h = half_window;
  rings.push_back({{-h, -h}, {h, -h}, {h, h}, {-h, h}});
  const Decomposition decomposition = decompose(rings);

  std::vector<Rational> area(numbers + 1);
  std::vector<Tower> standing;
  for (const Slab& slab : decomposition.slabs) {
    stack(standing, joined(faces, numbers, decomposition.rises, slab), slab.bottom, decomposition.rises, area);
  }
  stack(standing, {}, decomposition.slabs.back().top, decomposition.rises, area);
  const Rational uncovered = area.back();
  area.pop_back();
  return {area, uncovered};
}

Rational in_grid_units(const Rational& area, int grid_bits) {
  const Rational unit(cpp_int(1) << static_cast<unsigned>(grid_bits), cpp_int(half_window));
  return area * unit * unit;
}

std::vector<OracleFace> oracle_faces(const PolygonMesh& mesh, const Camera& camera, Sides sides) {
  std::vector<OracleFace> faces;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const FaceId face(f);
    if (mesh.first_facet(face) == mesh.end_facet(face)) continue;
    if (mesh.face_planar[f] != 0) {
      add(faces, f, in_camera_space(mesh, mesh.faces[f], camera), sides);
      continue;
    }
    for (std::size_t k = mesh.first_facet(face); k < mesh.end_facet(face); ++k) {
      add(faces, f, in_camera_space(mesh, mesh.corners(FacetId(k)), camera), sides);
    }
  }
  return faces;
}

}  // namespace sightline::lattice
