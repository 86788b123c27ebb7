#include "cli/scene/extreme_families.h"

#include <array>
#include <cmath>

namespace sightline::cli {

namespace {

class Draft {
 public:
  void add(std::span<const Point3> corners) {
    std::vector<VertexId> ids;
    for (const Point3& corner : corners) {
      ids.emplace_back(vertices_.size());
      vertices_.push_back(corner);
    }
    faces_.push_back(ids);
  }
  void add(std::initializer_list<Point3> corners) { add(std::span(corners.begin(), corners.size())); }
  [[nodiscard]] Mesh mesh() { return build_mesh(std::move(vertices_), std::move(faces_)); }

 private:
  std::vector<Point3> vertices_;
  PolygonList faces_;
};

std::vector<double> powers(double base, int from, int to, int step) {
  std::vector<double> values;
  for (int k = from; step > 0 ? k <= to : k >= to; k += step) values.push_back(std::pow(base, k));
  return values;
}

Camera pinhole(const Point3& eye, const Point3& target, double fov_y_degrees) {
  return perspective_camera("stability", {eye, target, {0, 1, 0}, 1, {}, {}}, fov_y_degrees);
}

// Five faces in layers that lie apart; all coordinates are multiples of 1/8, and so they stay when `scale` is a power of
// two and `offset` below 2^50.
const Point3 layers_eye{1.5, 0.75, 6};
const Point3 layers_target{0, 0, 0.5};

Mesh layers(double scale, double offset) {
  const std::vector<std::vector<Point3>> faces{
      {{-2, -1.5, 0}, {2, -1.25, 0}, {0.25, 2, 0}},
      {{-1.5, -1, 0.5}, {1, -1.25, 0.75}, {-0.25, 1.5, 0.5}},
      {{-0.5, -1.5, 1.25}, {1.5, -0.25, 1}, {0, 1.25, 1.125}},
      {{-1.75, 0.5, 1.5}, {1.75, 0.625, 1.625}, {1.75, 0.75, 1.625}},
      {{-1, -0.75, 2}, {-0.25, -0.875, 2}, {-0.25, 0.25, 2}, {-1, 0.125, 2}},
  };
  Draft draft;
  for (std::vector<Point3> face : faces) {
    for (Point3& p : face) p = scale * p + Vector3{offset, offset, offset};
    draft.add(face);
  }
  return draft.mesh();
}

Camera of_layers(double scale, double offset) {
  const Vector3 shift{offset, offset, offset};
  return pinhole(scale * layers_eye + shift, scale * layers_target + shift, 40);
}

// Three pairs of triangles. In each pair the upper one's edge crosses the lower one's at the angle.
FamilyScene crossing_angle(double angle) {
  const std::array<Point3, 3> centres{{{-0.45, -0.35, 0}, {0.45, -0.3, 0}, {0.02, 0.45, 0}}};
  Draft draft;
  for (const double height : {0.0, 1.0}) {
    for (std::size_t i = 0; i < centres.size(); ++i) {
      const double direction = 0.4 + 1.1 * static_cast<double>(i) + height * angle;
      const Vector3 along{std::cos(direction), std::sin(direction), 0};
      const Vector3 across{-along.y(), along.x(), 0};
      const Point3 centre = centres[i] + Vector3{0, 0, height};
      const double side = height == 0 ? 0.35 : -0.35;  // the lower one lies left of its edge, the upper one right
      draft.add({centre - 0.3 * along, centre + 0.25 * along, centre + side * across});
    }
  }
  const ViewPoint from_above{{0, 0, 8}, {0, 0, 0}, {0.3, 1, 0}, 1, {}, {}};
  return {draft.mesh(), orthographic_camera("stability", from_above, 2)};
}

// A triangle behind eight needles that share a vertex.
FamilyScene needle_width(double width) {
  const Point3 hub{0.013, -0.027, 1};
  Draft draft;
  draft.add({{-1.7, -1.2, 0}, {1.6, -1.3, 0}, {0.1, 1.9, 0}});
  for (int i = 0; i < 8; ++i) {
    const double direction = 0.2 + 0.77 * i;
    const Vector3 along{std::cos(direction), std::sin(direction), 0};
    const Vector3 across{-along.y(), along.x(), 0};
    const Point3 tip = hub + 0.8 * along;
    draft.add({hub, tip, tip + width * across});
  }
  return {draft.mesh(), pinhole({0.3, -0.2, 4}, {0, 0, 0}, 40)};
}

// Four faces in parallel steep planes, as far as rounded coordinates can be.
FamilyScene depth_gap(double gap) {
  const std::vector<std::vector<Point2>> outlines{{{-0.533, -0.364}, {0.541, -0.438}, {0.011, 0.531}},
                                                  {{-0.354, -0.433}, {0.441, 0.086}, {-0.26, 0.357}},
                                                  {{-0.182, -0.265}, {0.442, -0.176}, {0.178, 0.437}},
                                                  {{-0.263, -0.09}, {0.259, -0.183}, {0.044, 0.266}}};
  Draft draft;
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    std::vector<Point3> face;
    for (const Point2& p : outlines[i]) {
      face.push_back({p.x, p.y, 3.1 * p.x + 1.7 * p.y + static_cast<double>(i) * gap});
    }
    draft.add(face);
  }
  return {draft.mesh(), pinhole({-4.1, -2.2, 1.9}, {0, 0, 0}, 40)};
}

FamilyScene offset(double distance) { return {layers(1, distance), of_layers(1, distance)}; }

FamilyScene scale(double factor) { return {layers(factor, 0), of_layers(factor, 0)}; }

// A floor from before the near plane to beyond the far one; far away two tilted faces, one unit apart; a triangle near
// the eye.
FamilyScene far_near(double ratio) {
  const double far = ratio;
  const auto tilted = [far](double x, double y, double nearer) {
    return Point3{far * x, far * y, nearer - far * (0.75 + 0.23 * x + 0.11 * y)};
  };
  Draft draft;
  draft.add({{-1, -0.5, -0.5}, {1, -0.5, -0.5}, {far, -0.5, -2 * far}, {-far, -0.5, -2 * far}});
  draft.add({tilted(-0.253, 0.127, 0), tilted(0.249, 0.061, 0), tilted(0.067, 0.251, 0)});
  draft.add({tilted(-0.123, 0.033, 1), tilted(0.187, 0.129, 1), tilted(-0.061, 0.189, 1)});
  draft.add({{-0.5, -0.375, -1.125}, {-0.0625, -0.25, -1.125}, {-0.375, 0.25, -1.125}});
  const ViewPoint view{{0, 0, 0}, {0.03125, 0, -1}, {0.1, 1, 0}, 1, 1.0, far};
  return {draft.mesh(), perspective_camera("stability", view, 50)};
}

// The same layers, flatter the nearer the eye has to come to see them: half the window is one unit wide.
FamilyScene field_of_view(double half_window) {
  const double distance = 1 / half_window;
  const double thickness = std::min(1.0, distance) / 8;
  Draft draft;
  draft.add({{-0.9, -0.7, -3 * thickness}, {0.8, -0.75, -3 * thickness}, {0.1, 0.9, -2 * thickness}});
  draft.add({{-0.6, -0.8, -2 * thickness}, {0.9, 0.1, -thickness}, {-0.4, 0.6, -2 * thickness}});
  draft.add({{-0.7, 0.1, 0}, {0.3, -0.6, -thickness / 2}, {0.35, -0.5, -thickness / 2}});
  draft.add({{-0.2, -0.4, 0}, {0.5, 0.05, 0}, {-0.1, 0.55, 0}});
  const double degrees = 2 * std::atan(half_window) * 180 / std::acos(-1.0);
  return {draft.mesh(), pinhole({0.25 * distance, 0.125 * distance, distance}, {0, 0, 0}, degrees)};
}

FamilyScene grid_bits(double spacing) { return {layers(1, 0), of_layers(1, 0), static_cast<int>(-std::log2(spacing))}; }

std::vector<double> fields_of_view() {
  std::vector<double> values;
  for (const double degrees :
       {179.99, 179.9, 179.0, 170.0, 150.0, 120.0, 90.0, 40.0, 10.0, 1.0, 0.1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
    values.push_back(std::tan(degrees / 2 * std::acos(-1.0) / 180));
  }
  return values;
}

std::vector<double> scales() {
  std::vector<double> values;
  for (const int k : {-498, -400, -350, -300, -250, -200, -150, -100, -60, -45, -30, -15, 0,
                      15,   30,   45,   60,   100,  150,  200,  250,  300, 350, 400, 498}) {
    values.push_back(std::ldexp(1.0, k));
  }
  return values;
}

}  // namespace

const std::vector<ExtremeFamily>& extreme_families() {
  static const std::vector<ExtremeFamily> families{
      {"crossing_angle", "Crossing angle", "angle between the edges in the image, radians",
       "Three pairs of triangles seen by parallel rays; in each pair the upper one's edge crosses the lower one's at "
       "this angle, so that they overlap in a wedge.",
       powers(10, 0, -15, -1), crossing_angle},
      {"needle_width", "Needle width", "width of the needles, input units",
       "Eight needles with a common vertex before a triangle; the parameter is how wide they are at their ends, 0.8 "
       "from that vertex.",
       powers(10, -1, -16, -1), needle_width},
      {"depth_gap", "Depth gap", "height of each plane above the one before, input units",
       "Four triangles in parallel steep planes, each this far above the one before it, seen from about five units "
       "away; "
       "nearer ones come later in the file.",
       powers(2, 0, -48, -2), depth_gap},
      {"offset", "Offset", "distance from the origin, input units",
       "Five faces of about two units in layers; the whole scene, camera included, is moved away from the origin.",
       powers(10, 0, 15, 1), offset},
      {"scale", "Scale", "factor on every coordinate",
       "The same five faces and their camera, multiplied by a power of two.", scales(), scale},
      {"far_near", "Far / near", "far distance / near distance",
       "A floor that runs from before the near plane to beyond the far one, two tilted triangles far away that are one "
       "unit apart, and a triangle close by.",
       powers(2, 4, 50, 2), far_near},
      {"field_of_view", "Field of view", "half the window at distance 1: tan(fov / 2)",
       "Four triangles that fill the window at any field of view, from 179.99 to 0.000001 degrees: the eye is close to "
       "them where the field is wide and far off where it is narrow.",
       fields_of_view(), field_of_view},
      {"grid_bits", "Grid bits", "spacing of the image's grid, half windows",
       "The five faces of the family Offset, at the origin, on grids of 8 to 40 bits.", powers(2, -8, -40, -2),
       grid_bits},
  };
  return families;
}

}  // namespace sightline::cli
