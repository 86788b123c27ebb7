// Ids, labels, and per face area and orientation; conformity.h has the rest.
//
// Rounding: the corners of the pieces are points of the face, rounded, and areas are evaluated in double. With u =
// 2^-53 and M the largest coordinate of the face:
//   - lift.h computes p = a + t * (b - a), or the same with two directions. Differences, products and sums take each
//     coordinate off the edge or plane by at most 8 u M (what is wrong in t moves p along the edge, and area from one
//     piece to the next), so p by sqrt(3) * 8 u M < 14 u M. Moving a corner of a triangle by that changes its area by
//     at most half of it times the opposite side: 7 u M times the perimeter in all.
//   - Each component of the cross product of two sides r and s is off by at most 4 u |r| |s|, its length by less than
//     7 u |r| |s|. Half of that, |r| being at most half the perimeter and |s| the diameter 2 sqrt(3) M, is below 7 u M
//     times the perimeter.
// Together below 16 u M = 2^-49 M times the perimeter of the piece. Sums are compensated, so that their length does not
// matter.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "geometry/common_lines.h"
#include "geometry/facet_plane.h"
#include "reconstruct/conformity.h"
#include "reconstruct/labelled_mesh.h"

namespace sightline {
namespace {

using Messages = std::vector<std::string>;

constexpr double rounding = 0x1p-49;
constexpr double relative_area_error = 1e-12;

std::string triangle_name(std::size_t t) { return "triangle " + std::to_string(t); }
std::string name(FaceId f) { return "face " + std::to_string(f.value); }
std::string name(VertexId v) { return "vertex " + std::to_string(v.value); }

bool same_bits(const Point3& a, const Point3& b) {
  const auto bits = [](const Point3& p) {
    return std::array{std::bit_cast<std::uint64_t>(p.x), std::bit_cast<std::uint64_t>(p.y),
                      std::bit_cast<std::uint64_t>(p.z)};
  };
  return bits(a) == bits(b);
}

void check_vertices(const LabelledMesh& labelled, const Mesh& mesh, Messages& messages) {
  if (labelled.vertices.size() < mesh.vertices.size()) {
    messages.emplace_back("vertices: fewer than the input's");
    return;
  }
  for (std::size_t v = 0; v < labelled.vertices.size(); ++v) {
    const Point3& p = labelled.vertices[v];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      messages.push_back(name(VertexId(v)) + " is not finite");
    if (v < mesh.vertices.size() && !same_bits(p, mesh.vertices[v]))
      messages.push_back(name(VertexId(v)) + " is not where the input has it");
  }
}

void check_triangle(const LabelledMesh& labelled, const Mesh& mesh, std::size_t index, Messages& messages) {
  const LabelledTriangle& t = labelled.triangles[index];
  const auto& [a, b, c] = t.corners;
  const auto report = [&](bool wrong, const std::string& what) {
    if (wrong) messages.push_back(triangle_name(index) + what);
  };
  report(std::ranges::any_of(t.corners, [&](VertexId v) { return v.index() >= labelled.vertices.size(); }),
         " has a corner that is no vertex");
  report(a == b || b == c || c == a, " has a corner twice");
  report(t.label > Label::visible, " has no such label");
  report(t.label != Label::back_facing && t.seen != (t.label == Label::visible), " is seen or not, against its label");
  report(index > 0 && t.face < labelled.triangles[index - 1].face, " is not listed with its face");
  const bool is_face = t.face.index() < mesh.face_count();
  report(!is_face, " is of no face");
  report(is_face && mesh.first_facet(t.face) == mesh.end_facet(t.face),
         " is of " + name(t.face) + ", which is skipped");
}

// Surfaces are named by the facets of the mesh as it was cut.
void check_surfaces(const LabelledMesh& labelled, const Mesh& mesh, Messages& messages) {
  FacetId last(0);
  for (std::size_t i = 0; i < labelled.triangles.size(); ++i) {
    const LabelledTriangle& t = labelled.triangles[i];
    const bool is_surface = t.surface.index() < mesh.facet_count() && surface_of(mesh, t.surface) == t.surface;
    if (!is_surface || mesh.facet_face[t.surface.index()] != t.face) {
      messages.push_back(triangle_name(i) + " is on no surface of its face");
    } else if (t.surface < last) {
      messages.push_back(triangle_name(i) + " is not listed with its surface");
    } else {
      last = t.surface;
    }
  }
}

// A sum whose error does not grow with its length (Neumaier 1974).
class Sum {
 public:
  Sum& operator+=(double value) {
    const double sum = sum_ + value;
    const bool larger = std::fabs(sum_) >= std::fabs(value);
    lost_ += larger ? (sum_ - sum) + value : (value - sum) + sum_;
    sum_ = sum;
    return *this;
  }
  [[nodiscard]] double value() const { return sum_ + lost_; }

 private:
  double sum_ = 0;
  double lost_ = 0;
};

double component(const Vector3& v, int axis) { return axis == 0 ? v.x : (axis == 1 ? v.y : v.z); }

// A triangle with its coordinates divided by a power of two, so that squares neither overflow nor vanish.
struct ScaledTriangle {
  Vector3 twice_area;  // as a vector
  double perimeter = 0;

  ScaledTriangle(const Point3& a, const Point3& b, const Point3& c, int exponent) {
    const auto scaled = [exponent](const Point3& p) {
      return Point3{std::ldexp(p.x, -exponent), std::ldexp(p.y, -exponent), std::ldexp(p.z, -exponent)};
    };
    const Vector3 ab = scaled(b) - scaled(a);
    const Vector3 ac = scaled(c) - scaled(a);
    twice_area = cross(ab, ac);
    perimeter = (norm(ab) + norm(ac)) + norm(ac - ab);
  }
  [[nodiscard]] double area() const { return norm(twice_area) / 2; }
};

class FaceCheck {
 public:
  FaceCheck(const LabelledMesh& labelled, const Mesh& mesh, const ProjectedScene& scene, FaceId face,
            Messages& messages)
      : labelled_(labelled), mesh_(mesh), scene_(scene), face_(face), messages_(messages) {
    double largest = 0;
    for (std::size_t f = mesh.first_facet(face); f < mesh.end_facet(face); ++f) {
      for (const VertexId v : mesh.corners(FacetId(f))) {
        const Point3& p = mesh.position(v);
        largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
      }
    }
    exponent_ = std::ilogb(largest) + 1;  // M is now at most 1
    rounding_ = std::max(rounding, std::ldexp(2.0, std::numeric_limits<double>::min_exponent - 53 - exponent_));
  }

  void run(std::size_t first, std::size_t end) {
    check_area(first, end);
    if (mesh_.face_planar[face_.index()] == 0) return;  // its border has a direction too: see conformity.h
    const auto [axis, sign] = seen_orientation();
    for (std::size_t t = first; t < end; ++t) {
      const ScaledTriangle piece = scaled(labelled_.triangles[t].corners, labelled_.vertices);
      const bool turned = sign * component(piece.twice_area, axis) / 2 < -rounding_ * piece.perimeter;
      if (turned && !is_narrow(labelled_.triangles[t].corners))
        messages_.push_back(triangle_name(t) + " is turned over against " + name(face_));
    }
  }

 private:
  [[nodiscard]] ScaledTriangle scaled(const std::array<VertexId, 3>& corners,
                                      const std::vector<Point3>& vertices) const {
    return {vertices[corners[0].index()], vertices[corners[1].index()], vertices[corners[2].index()], exponent_};
  }

  void check_area(std::size_t first, std::size_t end) {
    Sum difference;
    Sum area;
    Sum perimeters;
    for (std::size_t f = mesh_.first_facet(face_); f < mesh_.end_facet(face_); ++f) {
      const auto corners = mesh_.corners(FacetId(f));
      for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const ScaledTriangle part = scaled({corners[0], corners[i], corners[i + 1]}, mesh_.vertices);
        area += part.area();
        difference += -part.area();
        perimeters += part.perimeter;
      }
    }
    for (std::size_t t = first; t < end; ++t) {
      const ScaledTriangle piece = scaled(labelled_.triangles[t].corners, labelled_.vertices);
      difference += piece.area();
      perimeters += piece.perimeter;
    }
    if (!(std::fabs(difference.value()) <= relative_area_error * area.value() + rounding_ * perimeters.value()))
      messages_.push_back(name(face_) + " has triangles of another area");
  }

  // Whether in the image, unrounded, the triangle is narrower than what rounding can turn over. Every corner lies within
  // half a spacing per axis, 0.71 in all, of where it was when the triangle was made the right way round; on the way it
  // had no width, and the width changes by twice that at most.
  [[nodiscard]] bool is_narrow(const std::array<VertexId, 3>& corners) const {
    constexpr double widest = 1.5;
    std::array<Point2, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3 offset = labelled_.vertices[corners[i].index()] - scene_.camera.origin;
      const bool pinhole = scene_.camera.projection == Projection::perspective;
      const double w = std::ldexp(pinhole ? dot(scene_.camera.forward, offset) : 1, -scene_.grid_bits);
      if (!(w > 0)) return false;
      p[i] = {dot(scene_.camera.right, offset) / w, dot(scene_.camera.up, offset) / w};
    }
    const double twice_area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      longest = std::max(longest, std::hypot(p[(i + 1) % 3].x - p[i].x, p[(i + 1) % 3].y - p[i].y));
    }
    return std::fabs(twice_area) <= widest * longest;
  }

  // An axis along which to look at a planar face, the best one as far as rounding tells, and the face's exact
  // orientation seen so.
  struct SeenOrientation {
    int axis = 0;
    Sign sign = 0;
  };
  [[nodiscard]] SeenOrientation seen_orientation() const {
    const auto corners = plane_corners(mesh_, FacetId(mesh_.first_facet(face_)));
    const Vector3 normal = scaled(corners, mesh_.vertices).twice_area;
    std::array<int, 3> axes{0, 1, 2};
    std::ranges::sort(axes, std::greater{}, [&](int axis) { return std::fabs(component(normal, axis)); });
    const auto dropped = [&](std::size_t corner, int axis) { return drop_axis(mesh_.position(corners[corner]), axis); };
    for (const int axis : axes) {
      const Sign sign = orient2d(dropped(0, axis), dropped(1, axis), dropped(2, axis));
      if (sign != 0) return {axis, sign};
    }
    return {};
  }

  const LabelledMesh& labelled_;
  const Mesh& mesh_;
  const ProjectedScene& scene_;
  FaceId face_;
  Messages& messages_;
  int exponent_ = 0;
  double rounding_ = 0;  // not below two spacings of the denormal numbers
};

void check_faces(const LabelledMesh& labelled, const Mesh& mesh, const ProjectedScene& scene, Messages& messages) {
  std::size_t first = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    std::size_t end = first;
    while (end < labelled.triangles.size() && labelled.triangles[end].face == FaceId(f)) ++end;
    if (mesh.first_facet(FaceId(f)) != mesh.end_facet(FaceId(f)))
      FaceCheck(labelled, mesh, scene, FaceId(f), messages).run(first, end);
    first = end;
  }
}

// uncut: the mesh without the lines along which it was cut.
void check_against(const Mesh& uncut, const LabelledMesh& labelled, const ProjectedScene& scene, Messages& messages) {
  check_vertices(labelled, uncut, messages);
  for (std::size_t t = 0; t < labelled.triangles.size(); ++t) check_triangle(labelled, uncut, t, messages);
  if (!messages.empty()) return;
  check_faces(labelled, uncut, scene, messages);
  check_conformity(labelled, uncut, messages);
}

}  // namespace

std::vector<std::string> validate(const LabelledMesh& labelled, const Mesh& mesh, const ProjectedScene& scene) {
  Messages messages;
  if (mesh.is_cut()) {
    check_against(without_cuts(mesh), labelled, scene, messages);
  } else {
    check_against(mesh, labelled, scene, messages);
  }
  check_surfaces(labelled, mesh, messages);
  return messages;
}

}  // namespace sightline
