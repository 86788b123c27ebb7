// Mesh and camera in, everything sightline knows about the view out: the one way through the stages.
//
// In:  a mesh, once; then cameras, and panels if there are any.
// Out: per camera a View.
// Method: nothing is rounded, and facets that pass through each other change places in the sweep. On a grid, which the
//      options may ask for, they are found and cut, once for all cameras. A view decides which sides of the
//      faces count, projects, sweeps, rebuilds the visible polygons, reflects the panels, and labels the surface. The
//      stages are functions of their own (docs/how-it-works.md) for whoever wants some of them only.
// Holds: views of one analyzer may be asked for by several threads at once, if the hook allows that. A view keeps the
//      surface alive and does not need the analyzer any more.
// Complexity: that of the stages; each header says its own.
//      What a camera with a lens sees is of the surface cut along its frame (geometry/projection/frame_cut.h).
// Errors: std::invalid_argument from build_mesh; CameraError for a lens on a grid; InternalError; in float and double ArithmeticError instead; what the hook
//      throws.
// Source: docs/design.md.
#pragma once

#include <memory>
#include <optional>

#include "geometry/cutting/interpenetration.h"
#include "geometry/numbers/export.h"
#include "sightline/options.h"
#include "sightline/view.h"

namespace sightline {

class SIGHTLINE_EXPORT Analyzer {
 public:
  explicit Analyzer(Mesh mesh, AnalysisOptions options = {});

  // A mesh that is taken as it is: without rounding any; on a grid one that was cut by the caller, or is known not to pass
  // through itself (uncrossed in cut_mesh.h).
  // contacts: how it met itself before it was cut; where that is not known, automatic sides count as both.
  explicit Analyzer(std::shared_ptr<const CutMesh> mesh, AnalysisOptions options = {},
                    std::optional<MeshContacts> contacts = std::nullopt);
  explicit Analyzer(CutMesh mesh, AnalysisOptions options = {}, std::optional<MeshContacts> contacts = std::nullopt);

  [[nodiscard]] const CutMesh& mesh() const { return *mesh_; }
  [[nodiscard]] std::shared_ptr<const CutMesh> shared_mesh() const { return mesh_; }
  [[nodiscard]] const AnalysisOptions& options() const { return options_; }

  // Returns what the camera sees, and the surface labelled by it.
  [[nodiscard]] View view(const Camera& camera) const;

  // The same, and which part of that mirrors the panels into the camera. Errors: PanelError.
  [[nodiscard]] View view(const Camera& camera, const std::vector<Panel>& panels) const;

  // The same with what all cameras share prepared once. Precondition: the world is this analyzer's.
  [[nodiscard]] View view(const Camera& camera, const MirrorWorld& world) const;

  // Returns what can be reflected, and what can be in the way. Errors: PanelError.
  [[nodiscard]] MirrorWorld world(std::vector<Panel> panels) const;

  // Runs the stages up to the visible polygons; nothing is labelled.
  [[nodiscard]] Visibility visible(const Camera& camera) const;

  // Returns which sides of the faces count for the camera.
  [[nodiscard]] SidesDecision sides(const Camera& camera) const;

 private:
  // The mesh, or what the camera's lens makes of it: cut along its frame.
  [[nodiscard]] std::shared_ptr<const CutMesh> framed(const Camera& camera) const;
  [[nodiscard]] static MirrorWorld framed(const MirrorWorld& world, const View& view);
  [[nodiscard]] Visibility find_visible(const Camera& camera) const;
  void reflect(const MirrorWorld& world, View& view) const;
  void label(View& view) const;
  [[nodiscard]] View find_view(const Camera& camera, const MirrorWorld* world) const;

  AnalysisOptions options_;
  std::optional<MeshContacts> contacts_;
  std::shared_ptr<const CutMesh> mesh_;
};

}  // namespace sightline
