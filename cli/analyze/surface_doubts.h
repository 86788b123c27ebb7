// What of a surface may not be meant as it is written: faces that lie on each other, panels that lie on faces, warped faces.
//
// In:  the surface, the panels' world, the file's name for messages.
// Out: what there is, for the report, and a line per kind of doubt, which ends with what to do.
// Complexity: that of find_coincidences.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/cutting/coincidence.h"
#include "geometry/projection/camera.h"
#include "reflect/world/mirror_world.h"
#include "sightline/options.h"

namespace sightline::cli {

// A panel lies on a face of the surface, or on another panel.
struct PanelCoincidence : Coincidence {
  std::string panel;
  std::optional<FaceId> face;
  std::string other_panel;
};

// Panels are looked for that far, to tell somebody who wrote six digits that more or a larger distance are wanted.
constexpr double near_share = 1e-6;

struct WarpedFaces {
  std::size_t count = 0;         // of faces whose corners are not in one plane, exactly
  double largest_deviation = 0;  // of a corner from the plane that fits its face
  FaceId face;                   // the one with that corner
};

struct SurfaceDoubts {
  double size = 0;      // of the surface
  double distance = 0;  // what is closer counts as on each other, in units of the scene; 0: nothing is looked for
  std::vector<FaceCoincidence> faces;
  std::vector<PanelCoincidence> panels;
  std::vector<PanelCoincidence> near_panels;  // not so close, but closer than near_share of the surface's size
  WarpedFaces warped;
};

[[nodiscard]] SurfaceDoubts surface_doubts(const CutMesh& mesh, const MirrorWorld& world,
                                           const ReflectionOptions& options);

[[nodiscard]] std::vector<std::string> warnings_of(const SurfaceDoubts& doubts, const AnalysisOptions& options);

// Returns a line if the eye is on a face, or all but; nothing otherwise, and where there is no eye.
[[nodiscard]] std::optional<std::string> eye_warning(const PolygonMesh& mesh, const Camera& camera, double distance);

}  // namespace sightline::cli
