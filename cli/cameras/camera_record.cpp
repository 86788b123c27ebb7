#include "cli/cameras/camera_record.h"

#include <fmt/format.h>

#include <algorithm>

#include "geometry/numbers/errors.h"

namespace sightline::cli {

namespace {

[[noreturn]] void refuse_camera_record(const std::string& name, const char* cause) {
  throw CameraError(fmt::format("camera \"{}\": {}", name, cause));
}

Camera calibrated(const Calibration& calibration, const CameraRecord& record, const std::string& name,
                  const ViewLimits& limits) {
  if (!(calibration.width > 0 && calibration.height > 0))
    refuse_camera_record(name, "the file does not say the size of the image; add image = [width, height]");
  const Lens lens = calibration.lens.value_or(Lens{});
  const PixelImage image{calibration.width, calibration.height, calibration.origin, limits.near_distance,
                         limits.far_distance};
  if (const auto* pose = std::get_if<CameraPose>(&record.place))
    return posed_camera(name, calibration.k, *pose, image, lens, limits.frame_tolerance);
  if (const auto* pose = std::get_if<WorldToCamera>(&record.place))
    return calibrated_camera(name, calibration.k, pose->r, pose->t, image, lens, limits.frame_tolerance);
  const Camera looking = pinhole_camera(name, std::get<ViewPoint>(record.place), 1);
  CameraPose pose;
  pose.rotation << looking.right.transpose(), -looking.up.transpose(), looking.forward.transpose();
  pose.eye = looking.origin;
  return posed_camera(name, calibration.k, pose, image, lens, limits.frame_tolerance);
}

// The same place as eye, view direction and up.
ViewPoint view_point(const CameraPose& pose) {
  ViewPoint view;
  view.eye = pose.eye;
  view.direction = Vector3(pose.rotation.row(2));
  view.up = -pose.rotation.row(1);
  return view;
}

Camera with_window(const WindowShape& window, const CameraRecord& record, const std::string& name,
                   const ViewLimits& limits) {
  ViewPoint view;
  if (const auto* given = std::get_if<ViewPoint>(&record.place)) view = *given;
  if (const auto* pose = std::get_if<CameraPose>(&record.place)) {
    require_rotation(name, pose->rotation);
    view = view_point(*pose);
  }
  if (const auto* pose = std::get_if<WorldToCamera>(&record.place)) {
    require_rotation(name, pose->r);
    const Camera placed = calibrated_camera(name, Matrix3::Identity(), pose->r, pose->t, {2, 2});
    view = view_point({pose->r, placed.origin});
  }
  view.aspect = window.aspect;
  view.near_distance = limits.near_distance;
  view.far_distance = limits.far_distance;
  return pinhole_camera(name, view, window.half_height);
}

}  // namespace

Camera camera_of(const CameraRecord& record, const std::string& name, const ViewLimits& limits) {
  if (std::holds_alternative<std::monostate>(record.place)) {
    refuse_camera_record(name,
                         "the file does not say where it is; add R and t, or name a file of poses, with this one as "
                         "its intrinsics");
  }
  if (const auto* calibration = std::get_if<Calibration>(&record.image))
    return calibrated(*calibration, record, name, limits);
  if (const auto* window = std::get_if<WindowShape>(&record.image)) return with_window(*window, record, name, limits);
  refuse_camera_record(name, "the file has poses only; add fov_y_deg, or intrinsics = \"FILE\" with the calibration");
}

std::string numbered(const std::string& stem, std::size_t index, std::size_t count) {
  const std::size_t digits = std::max<std::size_t>(2, std::to_string(count).size());
  return fmt::format("{}-{:0{}}", stem, index + 1, digits);
}

}  // namespace sightline::cli
