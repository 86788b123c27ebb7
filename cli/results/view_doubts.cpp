#include "cli/results/view_doubts.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

namespace sightline::cli {

namespace {

// Directions of length 1 at right angles, whatever the rows of a camera are.
struct CameraFrame {
  explicit CameraFrame(const Camera& camera)
      : origin(camera.origin),
        x(unit(camera.right - camera.right.dot(camera.forward) * camera.forward)),
        z(camera.forward) {
    const Vector3 across = unit(z.cross(x));
    y = across.dot(camera.up) < 0 ? Vector3(-across) : across;
  }
  [[nodiscard]] Vector3 place(const Point3& v) const {
    const Vector3 d = v - origin;
    return {x.dot(d), y.dot(d), z.dot(d)};
  }

  Point3 origin;
  Vector3 x, z;
  Vector3 y = Vector3::Zero();
};

// Where all corners are, in the camera's frame and in its window.
struct SeenExtent {
  Vector3 low = Vector3::Constant(std::numeric_limits<double>::infinity());
  Vector3 high = -low;
  // All corners are past that border of the window: right, left, above, below.
  std::array<bool, 4> past{true, true, true, true};
};

SeenExtent extent_of(const Visibility& view) {
  const CutMesh& mesh = view.mesh();
  const Camera& camera = view.scene.camera;
  const CameraFrame frame(camera);
  SeenExtent extent;
  for (std::size_t f = 0; f < mesh.uncut_facet_count(); ++f) {
    for (const VertexId corner : mesh.uncut_corners(UncutFacetId(f))) {
      const Point3& v = mesh.position(corner);
      const Vector3 place = frame.place(v);
      extent.low = extent.low.cwiseMin(place);
      extent.high = extent.high.cwiseMax(place);
      const double w = camera.projection == Projection::perspective ? place.z() : 1;
      const double across = camera.right.dot(v - camera.origin);
      const double upwards = camera.up.dot(v - camera.origin);
      const std::array<bool, 4> past{across > w, across<-w, upwards> w, upwards < -w};
      for (std::size_t i = 0; i < past.size(); ++i) extent.past[i] = extent.past[i] && past[i];
    }
  }
  return extent;
}

std::string words_of(const SeenExtent& extent) {
  return fmt::format(
      "in the camera's frame (x right, y up, z along the view) the mesh reaches from ({:.6g}, {:.6g}, {:.6g}) to "
      "({:.6g}, {:.6g}, {:.6g})",
      extent.low.x(), extent.low.y(), extent.low.z(), extent.high.x(), extent.high.y(), extent.high.z());
}

struct Whereabouts {
  std::string place;
  std::string remedy;
};

Whereabouts behind(const Camera& camera) {
  if (camera.matrix_sign) {
    return {"behind the camera",
            "look at where y points in P's image (image_y = \"up\" where it is up), or at P's axes"};
  }
  return {"behind the camera",
          "exchange eye and target, or look at the axes (OpenGL's cameras look along -z, OpenCV's along +z), or at "
          "whether R and t are those from world to camera"};
}

std::optional<std::string> side_of(const SeenExtent& extent) {
  constexpr std::array<const char*, 4> names{"right of the view", "left of the view", "above the view",
                                             "below the view"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (extent.past[i]) return names[i];
  }
  return std::nullopt;
}

Whereabouts whereabouts(const SeenExtent& extent, const Camera& camera) {
  const bool is_pinhole = camera.projection == Projection::perspective;
  if (is_pinhole && extent.high.z() <= 0) return behind(camera);
  if (camera.near_distance && extent.high.z() <= *camera.near_distance) {
    return {"nearer than near",
            fmt::format("near is {:.6g}: make it less, or look at the units of the camera and of the mesh",
                        *camera.near_distance)};
  }
  if (camera.far_distance && extent.low.z() >= *camera.far_distance) {
    return {"beyond far", fmt::format("far is {:.6g}: make it more, or look at the units of the camera and of the mesh",
                                      *camera.far_distance)};
  }
  const std::string remedy =
      "look at the camera's axes and at which axis of the mesh is up, or at the units of the camera and of the mesh";
  return {extent.low.z() > 0 || !is_pinhole ? side_of(extent).value_or("beside the view") : "beside the view", remedy};
}

ViewDoubt nothing_in_view(const SeenExtent& extent, const Camera& camera) {
  const auto [place, remedy] = whereabouts(extent, camera);
  return {fmt::format("nothing is in view: the mesh is {}", place),
          fmt::format("nothing is in view: {}, {}; {}", words_of(extent), place, remedy)};
}

// Whether part of the extent may be in front of the camera and in its window.
bool may_be_in_view(const SeenExtent& extent, const Camera& camera) {
  const bool is_pinhole = camera.projection == Projection::perspective;
  if (is_pinhole && extent.high.z() <= camera.near_distance.value_or(0)) return false;
  if (camera.far_distance && extent.low.z() >= *camera.far_distance) return false;
  return !(extent.low.z() > 0 || !is_pinhole) || !side_of(extent);
}

ViewDoubt all_turned_away(const SeenExtent& extent, Sides sides) {
  const char* const other_remedy = sides == Sides::front ? ", or set sides = \"both\"" : "";
  return {
      "all faces in view turn their backs",
      fmt::format("all faces in view turn their backs; {}; turn the order of the faces' corners, or look at whether "
                  "the eye is within the mesh{}",
                  words_of(extent), other_remedy)};
}

std::string matrix_words(int sign) {
  return sign > 0 ? "P was taken as it is" : "P was taken with the opposite sign, as -P";
}

ViewDoubt both_sides(const SeenExtent& extent, int sign) {
  return {"faces lie on both sides of the image plane of P",
          fmt::format("faces lie on both sides of the image plane of P, from z = {:.6g} to {:.6g}: P and -P see "
                      "different ones, and {}, which does not mirror the image; if its y points the other way, say so "
                      "by image_y",
                      extent.low.z(), extent.high.z(), matrix_words(sign))};
}

ViewDoubt opposite_sign() {
  return {"P was taken with the opposite sign",
          "P was taken with the opposite sign, as -P, which does not mirror the image; if its y points the other way "
          "(up, in OpenGL and VTK), say so by image_y, else give -P"};
}

// Backs that do not count have no area in view, wherever they are.
bool are_backs_in_view(const SeenExtent& extent, const Visibility& view, const InView& in_view) {
  if (!in_view.any_back) return false;
  return view.sides.sides == Sides::both ? in_view.area : may_be_in_view(extent, view.scene.camera);
}

}  // namespace

std::vector<ViewDoubt> doubts_about_view(const Visibility& view, const InView& in_view) {
  const Camera& camera = view.scene.camera;
  if (view.mesh().uncut_facet_count() == 0 || (in_view.front && !camera.matrix_sign)) return {};
  const SeenExtent extent = extent_of(view);
  std::vector<ViewDoubt> doubts;
  if (!in_view.front && are_backs_in_view(extent, view, in_view)) {
    doubts.push_back(all_turned_away(extent, view.sides.sides));
  } else if (!in_view.front && !in_view.area) {
    doubts.push_back(nothing_in_view(extent, camera));
  }
  if (!camera.matrix_sign) return doubts;
  if (extent.low.z() < 0 && extent.high.z() > 0) {
    doubts.push_back(both_sides(extent, *camera.matrix_sign));
  } else if (*camera.matrix_sign < 0) {
    doubts.push_back(opposite_sign());
  }
  return doubts;
}

}  // namespace sightline::cli
