#include "reconstruct/labelling/face_areas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "geometry/mesh/facet_plane.h"
#include "geometry/projection/camera_forms.h"

namespace sightline::inline reconstruct {
namespace {

constexpr double u = 0x1p-53;
constexpr double root_of_3 = 1.7321;  // not below it

// The header's bound for a triangle's area is rounding * M * P. A face has no more vertices than ids of 32 bits, and
// fewer than twice as many triangles, and its own parts.
constexpr double rounding = 0x1p-48;
constexpr double of_corners = root_of_3 * 4 * u;
constexpr double of_evaluation = (6 + root_of_3 * 5 / 2) * u;
constexpr double most_terms = 0x1p34;
constexpr double of_sum = (most_terms * u) * (most_terms * u) * (most_terms * u) * root_of_3 / 2;
static_assert(of_corners + of_evaluation + of_sum < 0.6 * rounding);

// This bound is in units of the spacing between denormal numbers, and counts where that is more. What it adds is below
// the two fifths left above.
constexpr double denormal_rounding = 5;
static_assert(root_of_3 <= 0.4 * denormal_rounding);

// The sum of n numbers is off by at most (n u)^3 times the sum of their magnitudes, and by the rounding of the result:
// what rounding loses of the first part is summed in the second, and what it loses of that in the third (Klein 2006).
class Sum {
 public:
  Sum& operator+=(double value) {
    for (double& part : parts_) value = add(part, value);
    return *this;
  }
  [[nodiscard]] double value() const { return parts_[0] + (parts_[1] + parts_[2]); }

 private:
  // Returns what the sum has lost, exactly (Knuth's TwoSum).
  static double add(double& part, double value) {
    const double sum = part + value;
    const double added = sum - part;
    const double lost = (part - (sum - added)) + (value - added);
    part = sum;
    return lost;
  }

  std::array<double, 3> parts_{};
};

// This triangle has its coordinates divided by a power of two, so that squares neither overflow nor vanish.
struct ScaledTriangle {
  Vector3 twice_area = Vector3::Zero();  // as a vector
  double perimeter = 0;

  ScaledTriangle(const Point3& a, const Point3& b, const Point3& c, int exponent) {
    const auto scaled = [exponent](const Point3& p) {
      return Point3{std::ldexp(p.x(), -exponent), std::ldexp(p.y(), -exponent), std::ldexp(p.z(), -exponent)};
    };
    const Vector3 ab = scaled(b) - scaled(a);
    const Vector3 ac = scaled(c) - scaled(a);
    twice_area = ab.cross(ac);
    perimeter = (norm(ab) + norm(ac)) + norm(ac - ab);
  }
  [[nodiscard]] double area() const { return norm(twice_area) / 2; }
};

// Returns whether in the image, unrounded, the triangle is narrower than what rounding can turn over. Every corner lies
// within half a spacing per axis, 0.71 in all, of where it was when the triangle was made the right way round; on the
// way it had no width, and the width changes by twice that at most.
bool is_narrow(const std::array<Point3, 3>& corners, const ProjectedScene& scene) {
  constexpr double widest = 1.5;
  const CameraForms<double> forms(scene.camera);
  std::array<Point2, 3> p;
  for (std::size_t i = 0; i < 3; ++i) {
    const CameraPlace<double> place = forms.at(corners[i]);
    const double w = std::ldexp(place.w, -scene.grid_bits);
    if (!(w > 0)) return false;
    p[i] = {place.x / w, place.y / w};
  }
  const double twice_area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
  double longest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    longest = std::max(longest, std::hypot(p[(i + 1) % 3].x - p[i].x, p[(i + 1) % 3].y - p[i].y));
  }
  return std::fabs(twice_area) <= widest * longest;
}

class FaceCheck {
 public:
  FaceCheck(const LabelledMesh& labelled, const PolygonMesh& uncut, const ProjectedScene& scene,
            std::vector<std::string>& messages)
      : labelled_(labelled), mesh_(scene.mesh()), uncut_(uncut), scene_(scene), messages_(messages) {}

  // The face has, of all the triangles, those from first to end.
  void run(FaceId face, std::size_t first, std::size_t end) {
    choose_scale(face);
    surplus_ = perimeters_ = undecided_ = Sum{};
    add_face(face);
    SurfaceOrientation orientation;
    for (std::size_t t = first; t < end; ++t) {
      const FacetId surface = labelled_.triangles[t].surface;
      if (t == first || surface != labelled_.triangles[t - 1].surface) orientation = orientation_of(surface);
      add_triangle(t, orientation);
    }
    const double allowed = rounding_ * perimeters_.value() + 2 * undecided_.value();
    if (!(std::fabs(surplus_.value()) <= allowed))
      messages_.push_back("face " + std::to_string(face.value) + " has triangles of another area");
  }

 private:
  // A surface is looked at along the best axis, as far as rounding tells, and its orientation seen so is exact.
  struct SurfaceOrientation {
    int axis = 0;
    Sign sign = 0;
  };

  void choose_scale(FaceId face) {
    double largest = 0;
    for (std::size_t f = uncut_.first_facet(face); f < uncut_.end_facet(face); ++f) {
      for (const VertexId v : uncut_.corners(FacetId(f))) {
        const Point3& p = uncut_.position(v);
        largest = std::max(largest, largest_coordinate(p));
      }
    }
    exponent_ = std::ilogb(largest) + 1;  // M is now at most 1
    const int spacing = std::numeric_limits<double>::min_exponent - std::numeric_limits<double>::digits;
    rounding_ = std::max(rounding, std::ldexp(denormal_rounding, spacing - exponent_));
  }

  void add_face(FaceId face) {
    for (std::size_t f = uncut_.first_facet(face); f < uncut_.end_facet(face); ++f) {
      const auto corners = uncut_.corners(FacetId(f));
      for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const ScaledTriangle part = scaled(positions(uncut_.vertices, {corners[0], corners[i], corners[i + 1]}));
        surplus_ += -part.area();
        perimeters_ += part.perimeter;
      }
    }
  }

  void add_triangle(std::size_t index, const SurfaceOrientation& seen) {
    const LabelledTriangle& triangle = labelled_.triangles[index];
    const auto corners = positions(labelled_.vertices, triangle.corners);
    const ScaledTriangle measures = scaled(corners);
    const double seen_area = seen.sign * measures.twice_area[seen.axis] / 2;
    const double off_by = rounding_ * measures.perimeter;
    const bool is_turned = seen_area < -off_by;
    surplus_ += is_turned ? -measures.area() : measures.area();
    perimeters_ += measures.perimeter;
    if (std::fabs(seen_area) <= off_by) undecided_ += measures.area();
    if (is_turned && !is_narrow(corners, scene_)) {
      messages_.push_back("triangle " + std::to_string(index) + " is turned over against face " +
                          std::to_string(triangle.face.value));
    }
  }

  [[nodiscard]] SurfaceOrientation orientation_of(FacetId surface) const {
    const auto corners = positions(mesh_.vertices, plane_corners(mesh_, surface));
    const Vector3 normal = scaled(corners).twice_area;
    std::array<int, 3> axes{0, 1, 2};
    std::ranges::sort(axes, std::greater{}, [&](int axis) { return std::fabs(normal[axis]); });
    const auto dropped = [&](std::size_t corner, int axis) { return drop_axis(corners[corner], axis); };
    for (const int axis : axes) {
      const Sign sign = orient2d(dropped(0, axis), dropped(1, axis), dropped(2, axis));
      if (sign != 0) return {axis, sign};
    }
    return {};
  }

  static std::array<Point3, 3> positions(const std::vector<Point3>& vertices, const std::array<VertexId, 3>& corners) {
    return {vertices[corners[0].index()], vertices[corners[1].index()], vertices[corners[2].index()]};
  }

  [[nodiscard]] ScaledTriangle scaled(const std::array<Point3, 3>& p) const { return {p[0], p[1], p[2], exponent_}; }

  const LabelledMesh& labelled_;
  const CutMesh& mesh_;
  const PolygonMesh& uncut_;
  const ProjectedScene& scene_;
  std::vector<std::string>& messages_;
  int exponent_ = 0;
  double rounding_ = 0;
  Sum surplus_;  // of the triangles' areas over the face's
  Sum perimeters_;
  Sum undecided_;  // areas of triangles that may be turned over or not
};

}  // namespace

void check_face_areas(const LabelledMesh& labelled, const PolygonMesh& uncut, const ProjectedScene& scene,
                      std::vector<std::string>& messages) {
  FaceCheck check(labelled, uncut, scene, messages);
  std::size_t first = 0;
  for (std::size_t f = 0; f < uncut.face_count(); ++f) {
    std::size_t end = first;
    while (end < labelled.triangles.size() && labelled.triangles[end].face == FaceId(f)) ++end;
    if (uncut.first_facet(FaceId(f)) != uncut.end_facet(FaceId(f))) check.run(FaceId(f), first, end);
    first = end;
  }
}

}  // namespace sightline::inline reconstruct
