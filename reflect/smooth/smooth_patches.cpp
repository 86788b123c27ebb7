#include "reflect/smooth/smooth_patches.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/mesh/facet_plane.h"
#include "reflect/world/uncut_facets.h"

namespace sightline::inline reflect {
namespace {

using Corners = std::array<VertexId, 3>;

Vector3 normal_of(const std::array<Point3, 3>& corners) {
  return (corners[1] - corners[0]).cross(corners[2] - corners[0]);
}

// Returns the normal at the face's corner that is this vertex; that of its plane where there is none.
Vector3 corner_normal(const MirrorWorld& world, FaceId face, VertexId vertex, const Vector3& of_plane) {
  const auto corners = world.surface->faces[face.index()];
  const auto corner = std::ranges::find(corners, vertex);
  if (world.normals.empty() || corner == corners.end()) return of_plane;
  const auto at = world.surface->faces.begin[face.index()] + static_cast<std::size_t>(corner - corners.begin());
  const Vector3 normal = unit(world.normals[at]);
  return normal == Vector3::Zero() ? of_plane : normal;
}

// A place of the grid, up to rounding.
struct Place {
  double x = 0;
  double y = 0;
};

Place operator-(const Place& p, const Place& q) { return {p.x - q.x, p.y - q.y}; }
double cross(const Place& p, const Place& q) { return p.x * q.y - p.y * q.x; }
double length(const Place& p) { return std::hypot(p.x, p.y); }

// A line of the image: positive on its left.
struct Line {
  double a = 0, b = 0, c = 0;

  [[nodiscard]] double at(const Place& p) const { return a * p.x + b * p.y + c; }
};

// Where a camera sees positions, in spacings of the grid.
class GridView {
 public:
  explicit GridView(const ProjectedScene& scene) : camera_(scene.camera), half_(std::ldexp(1.0, scene.grid_bits)) {}

  [[nodiscard]] double half_window() const { return half_; }

  [[nodiscard]] Vector3 homogeneous(const Point3& p) const {
    const Vector3 from = p - camera_.origin;
    const double weight = camera_.projection == Projection::perspective ? camera_.forward.dot(from) : 1;
    return {half_ * camera_.right.dot(from), half_ * camera_.up.dot(from), weight};
  }

  // Nothing where it is not before the camera.
  [[nodiscard]] std::optional<Place> place_of(const Point3& p) const {
    const Vector3 h = homogeneous(p);
    if (!(h.z() > 0)) return std::nullopt;
    return Place{h.x() / h.z(), h.y() / h.z()};
  }

  // The line through the images of both, scaled to a distance.
  [[nodiscard]] Line line_through(const Point3& p, const Point3& q) const {
    const Vector3 line = homogeneous(p).cross(homogeneous(q));
    const double size = std::hypot(line.x(), line.y());
    return {line.x() / size, line.y() / size, line.z() / size};
  }

 private:
  const Camera& camera_;
  double half_;
};

constexpr double margin = 4;  // in spacings: more than a place is off by once it is rounded

ImagePoint rounded(const Place& p, double step, double half) {
  const auto coordinate = [&](double x) {
    return static_cast<std::int64_t>(std::clamp(step * std::round(x / step), -half, half));
  };
  return {coordinate(p.x), coordinate(p.y)};
}

bool is_in_window(const Place& p, double half) { return std::fabs(p.x) <= half && std::fabs(p.y) <= half; }

// Puts the longest side between the first two corners.
ImageTriangle longest_first(const ImageTriangle& t) {
  const auto side = [&](std::size_t i) {
    const ImagePoint& p = t[i];
    const ImagePoint& q = t[(i + 1) % 3];
    return std::hypot(static_cast<double>(q.x - p.x), static_cast<double>(q.y - p.y));
  };
  std::size_t longest = 0;
  for (std::size_t i = 1; i < 3; ++i) longest = side(i) > side(longest) ? i : longest;
  return {t[longest], t[(longest + 1) % 3], t[(longest + 2) % 3]};
}

// The triangle made larger around the middle of its inscribed circle, so that each side is at least two steps and the margin further out;
// nothing where that is not in the window, or much larger.
std::optional<ImageTriangle> cover_of(const std::array<Place, 3>& t, double half) {
  const std::array sides{length(t[2] - t[1]), length(t[0] - t[2]), length(t[1] - t[0])};
  const double around = sides[0] + sides[1] + sides[2];
  const double radius = std::fabs(cross(t[1] - t[0], t[2] - t[0])) / around;
  const double step = std::exp2(std::max(0.0, std::floor(std::log2(radius / 16))));
  const double growth = (2 * step + margin) / radius;
  if (!(growth < 1)) return std::nullopt;
  Place middle;
  for (std::size_t i = 0; i < 3; ++i)
    middle = {middle.x + sides[i] / around * t[i].x, middle.y + sides[i] / around * t[i].y};
  ImageTriangle result;
  for (std::size_t i = 0; i < 3; ++i) {
    const Place corner{t[i].x + growth * (t[i].x - middle.x), t[i].y + growth * (t[i].y - middle.y)};
    if (!is_in_window(corner, half)) return std::nullopt;
    result[i] = rounded(corner, step, half);
  }
  if (cross(t[1] - t[0], t[2] - t[0]) < 0) std::swap(result[1], result[2]);
  return longest_first(result);
}

// Two triangles around everything that is seen of the surface: halves of a rectangle.
std::vector<ImageTriangle> box_covers(const ProjectedScene& scene, FacetId surface, double half) {
  Place low{half, half};
  Place high{-half, -half};
  for (std::size_t f = surface.index(); f < end_of_surface(scene.mesh(), surface).index(); ++f) {
    for (const ClippedCorner& corner : scene.polygon(FacetId(f))) {
      const ImagePoint& p = scene.point(corner.point);
      low = {std::min(low.x, static_cast<double>(p.x)), std::min(low.y, static_cast<double>(p.y))};
      high = {std::max(high.x, static_cast<double>(p.x)), std::max(high.y, static_cast<double>(p.y))};
    }
  }
  if (!(low.x <= high.x)) return {};
  const double narrowest = std::max(1.0, std::min(high.x - low.x, high.y - low.y));
  const double step = std::exp2(std::max(0.0, std::floor(std::log2(narrowest / 16))));
  const auto outwards = [&](double x, double direction) {
    const double at = x / step + direction * margin;
    return static_cast<std::int64_t>(std::clamp(step * (direction < 0 ? std::floor(at) : std::ceil(at)), -half, half));
  };
  const std::int64_t left = outwards(low.x, -1);
  const std::int64_t bottom = outwards(low.y, -1);
  const std::int64_t right = outwards(high.x, 1);
  const std::int64_t top = outwards(high.y, 1);
  return {longest_first({{{left, bottom}, {right, bottom}, {left, top}}}),
          longest_first({{{right, top}, {left, top}, {right, bottom}}})};
}

// What of the window is left of a line; all of it, or nothing, where the line does not cross it.
ImagePolygon half_plane(const Line& line, double half) {
  const std::array<Place, 4> window{{{-half, -half}, {half, -half}, {half, half}, {-half, half}}};
  ImagePolygon polygon;
  for (std::size_t i = 0; i < 4; ++i) {
    const Place& p = window[i];
    const Place& q = window[(i + 1) % 4];
    const double at_p = line.at(p);
    const double at_q = line.at(q);
    if (at_p >= 0) polygon.push_back(rounded(p, 1, half));
    if ((at_p >= 0) == (at_q >= 0)) continue;
    const double share = at_p / (at_p - at_q);
    polygon.push_back(rounded({p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)}, 1, half));
  }
  return polygon;
}

// The line of a side that neighbours share is the same for both; any other is moved outwards by the margin, so that no border of the
// surface is lost.
std::vector<ImagePolygon> half_planes(const CutMesh& mesh, const GridView& view, const std::vector<Corners>& all,
                                      const Corners& corners) {
  std::vector<ImagePolygon> result;
  const auto has_side = [](const Corners& c, VertexId p, VertexId q) {
    return (c[0] == p && c[1] == q) || (c[1] == p && c[2] == q) || (c[2] == p && c[0] == q);
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const VertexId p = corners[i];
    const VertexId q = corners[(i + 1) % 3];
    const VertexId inside = corners[(i + 2) % 3];
    const bool is_shared = std::ranges::any_of(all, [&](const Corners& c) { return has_side(c, q, p); });
    Line line = view.line_through(mesh.position(std::min(p, q)), mesh.position(std::max(p, q)));
    const Vector3 h = view.homogeneous(mesh.position(inside));
    // The form is linear in space: it has one sign in all of the triangle, and so at each place where that is seen.
    if (line.a * h.x() + line.b * h.y() + line.c * h.z() < 0) line = {-line.a, -line.b, -line.c};
    if (!is_shared) line.c += margin;
    result.push_back(half_plane(line, view.half_window()));
  }
  return result;
}

SmoothPatch patch_of(const MirrorWorld& world, FaceId face, const Corners& corners, const Vector3& towards_eye) {
  SmoothPatch patch;
  patch.triangle.towards_eye = towards_eye;
  for (std::size_t i = 0; i < 3; ++i) {
    patch.triangle.corners[i] = world.scale * world.surface->position(corners[i]);
    patch.triangle.normals[i] = corner_normal(world, face, corners[i], towards_eye);
  }
  return patch;
}

}  // namespace

std::vector<SmoothPatch> smooth_patches(const MirrorWorld& world, const ProjectedScene& scene, FacetId surface) {
  const CutMesh& mesh = *world.surface;
  const std::vector<Corners> triangles = fans_of(mesh, surface);
  const GridView view(scene);
  std::array<Point3, 3> plane = plane_points(mesh, surface);
  for (Point3& p : plane) p *= world.scale;
  Vector3 towards_eye = unit(normal_of(plane));
  if (scene.facing[surface.index()] == FacetFacing::back) towards_eye = -towards_eye;
  std::vector<SmoothPatch> patches;
  for (const Corners& corners : triangles) {
    SmoothPatch patch = patch_of(world, mesh.facet_face[surface.index()], corners, towards_eye);
    std::array<std::optional<Place>, 3> places;
    for (std::size_t i = 0; i < 3; ++i) places[i] = view.place_of(mesh.position(corners[i]));
    std::optional<ImageTriangle> cover;
    if (places[0] && places[1] && places[2]) cover = cover_of({*places[0], *places[1], *places[2]}, view.half_window());
    patch.covers = cover ? std::vector{*cover} : box_covers(scene, surface, view.half_window());
    if (triangles.size() > 1) patch.half_planes = half_planes(mesh, view, triangles, corners);
    patches.push_back(std::move(patch));
  }
  return patches;
}

}  // namespace sightline::inline reflect
