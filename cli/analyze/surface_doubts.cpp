#include "cli/analyze/surface_doubts.h"

#include <fmt/format.h>

#include <algorithm>

#include "geometry/faces/fitted_plane.h"

namespace sightline::cli {
namespace {

WarpedFaces warped_faces(const PolygonMesh& mesh) {
  WarpedFaces warped;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if (mesh.face_planar[f] != 0 || mesh.first_facet(FaceId(f)) == mesh.end_facet(FaceId(f))) continue;
    std::vector<Point3> corners;
    for (const VertexId v : mesh.faces[f]) corners.push_back(mesh.position(v));
    const FittedPlane plane = fitted_plane(corners);
    double deviation = 0;
    for (const Point3& corner : corners) deviation = std::max(deviation, std::fabs(plane.height(corner)));
    if (warped.count++ == 0 || deviation > warped.largest_deviation) {
      warped.largest_deviation = deviation;
      warped.face = FaceId(f);
    }
  }
  return warped;
}

// Facets of one face count together.
void add_faces(const CutMesh& mesh, const std::string& panel, const Flush& flush,
               std::vector<PanelCoincidence>& found) {
  const std::size_t first = found.size();
  for (const FlushFacet& part : flush.facets) {
    const FaceId face = mesh.facet_face[mesh.first_piece(part.facet).index()];
    if (found.size() == first || found.back().face != face) found.push_back({{0, 0}, panel, face, ""});
    found.back().distance = std::max(found.back().distance, part.distance);
    found.back().overlap += part.overlap;
  }
}

std::vector<PanelCoincidence> coincidences_of_panels(const CutMesh& mesh, const MirrorWorld& world) {
  std::vector<PanelCoincidence> found;
  for (std::size_t p = 0; p < world.flush.size(); ++p) {
    add_faces(mesh, world.panels[p].name, world.flush[p], found);
    for (const FlushPanel& flush : world.flush[p].panels) {
      if (flush.panel > p) found.push_back({flush, world.panels[p].name, std::nullopt, world.panels[flush.panel].name});
    }
  }
  return found;
}

// Faces that panels all but lie on, farther from them than what counts as on them.
std::vector<PanelCoincidence> near_panels(const CutMesh& mesh, const MirrorWorld& world,
                                          const std::vector<PanelCoincidence>& known) {
  std::vector<PanelCoincidence> found;
  const double distance = near_share * size_of(mesh);
  for (std::size_t p = 0; p < world.panel_meshes.size(); ++p)
    add_faces(mesh, world.panels[p].name, find_flush(mesh, world.obstacles, world.panel_meshes, p, distance), found);
  std::erase_if(found, [&](const PanelCoincidence& near) {
    return near.distance == 0 || std::ranges::any_of(known, [&](const PanelCoincidence& pair) {
             return pair.panel == near.panel && pair.face == near.face;
           });
  });
  return found;
}

std::string pairs(std::size_t count) { return fmt::format("{} pair{}", count, count == 1 ? "" : "s"); }

std::string faces_of(const FaceCoincidence& pair) {
  return fmt::format("{} and {}", pair.first.value, pair.second.value);
}

// Calls with how many pairs there are of a kind, and the first, if there are any.
template <class Kind, class Say>
void for_kind(const std::vector<FaceCoincidence>& faces, Kind is_of_kind, Say say) {
  const auto first = std::ranges::find_if(faces, is_of_kind);
  if (first != faces.end()) say(static_cast<std::size_t>(std::ranges::count_if(faces, is_of_kind)), *first);
}

// What is on a grid is not snapped, nor are warped faces, and others that hang together but are too far apart.
std::string remedy(const AnalysisOptions& options) {
  if (!options.reflection.snaps) return "set policy = \"snap\" in [coincidence], or move one";
  return options.precision.arithmetic == Arithmetic::unrounded ? "no one plane is so near to both, so move one"
                                                               : "leave --arithmetic out, since a grid snaps no faces";
}

// Of coplanar pairs a rule says which is in front, of others the last digits do.
void warn_about_faces(const SurfaceDoubts& doubts, const AnalysisOptions& options, std::vector<std::string>& warnings) {
  const auto is_exact = [](const FaceCoincidence& pair) { return pair.distance == 0; };
  const auto is_open = [](const FaceCoincidence& pair) { return pair.distance > 0 && !pair.is_snapped; };
  const auto is_snapped = [](const FaceCoincidence& pair) { return pair.distance > 0 && pair.is_snapped; };
  for_kind(doubts.faces, is_open, [&](std::size_t count, const FaceCoincidence& first) {
    warnings.push_back(
        fmt::format("{} of faces lie on each other but for rounding (closer than {:.3g}; first: {}), so that the last "
                    "digits of their corners decide which is seen: {}",
                    pairs(count), doubts.distance, faces_of(first), remedy(options)));
  });
  for_kind(doubts.faces, is_snapped, [&](std::size_t count, const FaceCoincidence& first) {
    warnings.push_back(
        fmt::format("{} of faces lie on each other but for rounding (closer than {:.3g}; first: {}), and count as "
                    "coplanar",
                    pairs(count), doubts.distance, faces_of(first)));
  });
  for_kind(doubts.faces, is_exact, [&](std::size_t count, const FaceCoincidence& first) {
    const std::string where =
        fmt::format("{} of faces lie on each other in one plane (first: {}), where a rule says which is seen",
                    pairs(count), faces_of(first));
    warnings.push_back(options.reflection.snaps
                           ? where
                           : where +
                                 ", until the scene is turned and rounded: set policy = \"snap\" in [coincidence], "
                                 "or move one");
  });
}

std::string panel_warning(const PanelCoincidence& pair, bool snaps) {
  const std::string what = pair.face ? fmt::format("face {}", pair.face->value) : "panel \"" + pair.other_panel + "\"";
  const std::string where =
      fmt::format("panel \"{}\" lies on {} but for rounding ({:.3g} apart)", pair.panel, what, pair.distance);
  if (snaps) return where + ", and counts as in its plane";
  return where +
         ", so that the last digits of its corners decide what hides it: set policy = \"snap\" in [coincidence], or "
         "move it";
}

std::string near_panel_warning(const PanelCoincidence& pair, double size) {
  return fmt::format(
      "panel \"{}\" is near to face {} ({:.3g} apart): if it is meant to lie on it, set distance = {:.0e} in "
      "[coincidence] and "
      "policy = \"snap\", or write more digits",
      pair.panel, pair.face->value, pair.distance, 2 * pair.distance / size);
}

}  // namespace

SurfaceDoubts surface_doubts(const CutMesh& mesh, const MirrorWorld& world, const ReflectionOptions& options) {
  SurfaceDoubts doubts;
  doubts.distance = options.coincidence * size_of(mesh);
  doubts.warped = warped_faces(mesh);
  if (options.coincidence > 0) doubts.faces = find_coincidences(mesh, doubts.distance);
  doubts.panels = coincidences_of_panels(mesh, world);
  doubts.size = size_of(mesh);
  if (options.coincidence < near_share) doubts.near_panels = near_panels(mesh, world, doubts.panels);
  return doubts;
}

std::vector<std::string> warnings_of(const SurfaceDoubts& doubts, const AnalysisOptions& options) {
  std::vector<std::string> warnings;
  warn_about_faces(doubts, options, warnings);
  for (const PanelCoincidence& pair : doubts.panels) {
    if (pair.distance > 0) warnings.push_back(panel_warning(pair, options.reflection.snaps));
  }
  for (const PanelCoincidence& pair : doubts.near_panels) warnings.push_back(near_panel_warning(pair, doubts.size));
  return warnings;
}

std::optional<std::string> eye_warning(const PolygonMesh& mesh, const Camera& camera, double distance) {
  if (camera.projection != Projection::perspective) return std::nullopt;
  const std::vector<FaceId> faces = faces_at(mesh, camera.origin, distance);
  if (faces.empty()) return std::nullopt;
  return fmt::format(
      "the eye is on face {} (closer than {:.3g}), so that rounding decides whether the face is seen: move the eye "
      "away from it",
      faces.front().value, distance);
}

}  // namespace sightline::cli
