#include "reflect/world/panel.h"

#include <algorithm>
#include <charconv>
#include <string>

#include "geometry/faces/face_shape.h"
#include "geometry/faces/fitted_plane.h"
#include "reflect/world/uncut_facets.h"

namespace sightline::inline reflect {

namespace {

[[noreturn]] void refuse(const Panel& panel, const std::string& cause) {
  throw PanelError("panel \"" + panel.name + "\": " + cause);
}

std::vector<VertexId> all_corners(std::size_t count) {
  std::vector<VertexId> corners;
  for (std::size_t i = 0; i < count; ++i) corners.emplace_back(i);
  return corners;
}

std::vector<Point3> scaled(const std::vector<Point3>& corners, double scale) {
  std::vector<Point3> result;
  for (const Point3& corner : corners) result.push_back(scale * corner);
  return result;
}

bool are_in_one_plane(const std::vector<Point3>& corners) {
  return corners.size() <= 3 || is_planar({all_corners(corners.size()), corners});
}

double largest_distance(const std::vector<Point3>& corners) {
  double distance = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) distance = std::max(distance, norm(corners[i] - corners[j]));
  }
  return distance;
}

std::string text(double number) {
  std::array<char, 32> digits;
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr};
}

std::string text(const Point3& p) { return "[" + text(p.x()) + ", " + text(p.y()) + ", " + text(p.z()) + "]"; }

// Returns the corners from the lexicographically least one on, in the direction of its lesser neighbour: so that a panel that begins
// elsewhere, or is turned, has the same plane to the last bit.
std::vector<Point3> in_canonical_order(std::vector<Point3> corners) {
  std::rotate(corners.begin(), std::ranges::min_element(corners, lexicographically_less), corners.end());
  if (lexicographically_less(corners.back(), corners[1])) std::reverse(corners.begin() + 1, corners.end());
  return corners;
}

// Returns where a corner would be in the plane of the others.
Point3 place_among_others(const std::vector<Point3>& corners, std::size_t corner) {
  const double scale = unit_scale(corners);
  std::vector<Point3> others = scaled(corners, scale);
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(corner));
  return fitted_plane(others).foot(scale * corners[corner]) / scale;
}

[[noreturn]] void refuse_corner(const Panel& panel, std::size_t worst, double share, double distance) {
  const auto rounded = [](double number) { return text(static_cast<double>(static_cast<float>(number))); };
  refuse(panel, "its corners are not in one plane: corner " + std::to_string(worst + 1) + " of " +
                    std::to_string(panel.corners.size()) + " is " + rounded(distance) +
                    " off the plane that fits them, " + rounded(share) + " of the panel's size; write " +
                    text(place_among_others(panel.corners, worst)) + " there, or a larger planarity than " +
                    text(panel.planarity));
}

}  // namespace

// All is computed in a scale in which nothing overflows; it is a power of two, so that it rounds nothing.
FittedPanel fitted_panel(const Panel& panel) {
  if (are_in_one_plane(panel.corners)) return {panel.corners, 0};
  const double scale = unit_scale(panel.corners);
  const std::vector<Point3> corners = scaled(panel.corners, scale);
  const FittedPlane plane = fitted_plane(in_canonical_order(corners));
  if (plane.normal.isZero(0))
    refuse(panel, "its border crosses itself so that it has no front; list its corners in order");
  const auto off_plane = [&](const Point3& corner) { return std::fabs(plane.height(corner)); };
  const auto worst = std::ranges::max_element(corners, {}, off_plane);
  const double deviation = off_plane(*worst);
  const double size = largest_distance(corners);
  FittedPanel fitted{{}, deviation / scale};
  for (const Point3& corner : corners) fitted.corners.push_back(plane.foot(corner) / scale);
  if (deviation <= panel.planarity * size) return fitted;
  refuse_corner(panel, static_cast<std::size_t>(worst - corners.begin()), deviation / size, fitted.deviation);
}

Mesh panel_mesh(const Panel& panel) {
  PolygonList faces;
  faces.push_back(all_corners(panel.corners.size()));
  Mesh mesh = build_mesh(fitted_panel(panel).corners, std::move(faces));
  if (!mesh.defects.empty())
    refuse(panel, std::string(to_string(mesh.defects.front().defect)) +
                      "; give at least three corners, in order, that bound an area");
  return mesh;
}

std::array<Point3, 3> panel_plane(const CutMesh& panel) {
  if (panel.face_planar.front() != 0) return plane_points(panel, FacetId(0));
  const std::vector<Point3> corners = scaled(panel.vertices, unit_scale(panel.vertices));
  const auto index_of_largest = [&](auto measure) {
    return static_cast<std::size_t>(std::ranges::max_element(corners, {}, measure) - corners.begin());
  };
  const std::size_t b = index_of_largest([&](const Point3& p) { return norm(p - corners[0]); });
  const Vector3 along = corners[b] - corners[0];
  const std::size_t c = index_of_largest([&](const Point3& p) { return norm(along.cross(p - corners[0])); });
  const bool turns_left = along.cross(corners[c] - corners[0]).dot(area_vector(corners)) > 0;
  return {panel.vertices[0], panel.vertices[turns_left ? b : c], panel.vertices[turns_left ? c : b]};
}

}  // namespace sightline::inline reflect
