#include "cli/analyze/normal_warnings.h"

#include <fmt/format.h>

namespace sightline::cli {
namespace {

// Means across a larger angle, in degrees, bend what hardly is meant to be one smooth surface.
constexpr double sharp = 60;

}  // namespace

std::vector<std::string> normal_warnings(const PolygonMesh& mesh, const std::vector<Vector3>& given,
                                         const ReflectionOptions& options) {
  const NormalDoubts doubts = doubts_about_normals(mesh, given, options.normal_options());
  std::vector<std::string> warnings;
  if (doubts.are_of_faces)
    warnings.push_back(fmt::format(
        "all normals (vn) of the file are those of its faces, so that mode \"{}\" mirrors flat faces: remove "
        "them to have means of faces instead",
        to_string(options.mode)));
  if (doubts.turned_corners > 0)
    warnings.push_back(
        fmt::format("normals (vn) that point to the back of their face at {} corner{}, first of face {}: turn "
                    "these normals, or the order of the face's corners",
                    doubts.turned_corners, doubts.turned_corners == 1 ? "" : "s", doubts.first_turned.value));
  if (doubts.sharpest_mean > sharp)
    warnings.push_back(
        fmt::format("normals are means across edges where faces meet at up to {:.0f} degrees (faces {} and {}): "
                    "set crease_angle_deg in [reflection] below that to keep such edges sharp",
                    doubts.sharpest_mean, doubts.sharpest[0].value, doubts.sharpest[1].value));
  return warnings;
}

}  // namespace sightline::cli
