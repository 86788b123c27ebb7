// The report has, in values, what was analysed for one camera, how, what came out, and what it cost. report_json.h writes
// them.
//
// Equal between runs except for the seconds and the peak memory. Lengths and areas in input units, image areas in the
// window [-1, 1]^2.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/analyze/view_analysis.h"
#include "cli/results/face_measures.h"
#include "cli/scene/scene_file.h"

namespace sightline::cli {

struct Report {
  struct Surface {
    std::string scene_file;
    std::string mesh_file;
    std::size_t vertices = 0;
    std::size_t faces = 0;
    std::size_t facets = 0;  // before they were cut along common lines
    std::vector<ScenePart> parts;
  };

  // Input faces by the highest label of their triangles.
  struct FaceCounts {
    std::size_t visible = 0;
    std::size_t reflecting = 0;  // some panel, whatever the label
    std::size_t hidden = 0;
    std::size_t out_of_view = 0;
    std::size_t back_facing = 0;
    std::size_t skipped = 0;
  };

  struct Counts {
    FaceCounts faces;
    std::size_t edges = 0;
    std::size_t sweep_points = 0;
    std::size_t crossings = 0;
    std::size_t visible_segments = 0;
    std::size_t visible_polygons = 0;
    std::size_t below_resolution = 0;  // of the polygons
    std::size_t holes = 0;
    std::size_t output_triangles = 0;
    std::size_t crossing_pairs = 0;  // of faces that pass through each other
  };

  struct Areas {
    double surface = 0;
    double in_view = 0;
    double visible = 0;
    double image_visible = 0;
    double image_uncovered = 0;  // of the window's area 4, or of the area of a lens's frame
  };

  // The same on the faces of interest; of all faces where none were chosen.
  struct AreasOfInterest {
    bool were_chosen = false;
    std::size_t faces = 0;
    double surface = 0;
    double in_view = 0;
    double visible = 0;
    double image_visible = 0;
  };

  struct ReflectedPanel {
    std::string name;
    Emits emits = Emits::both;
    double area = 0;              // of the surface that reflects it
    double area_of_interest = 0;  // of it on faces of interest
    double image_area = 0;
    std::size_t polygons = 0;         // in the image: triangles in the mode of this name, else polygons
    double uncertain_image_area = 0;  // in smooth mode: at most so much of image_area may be wrong
    double border_distance = 0;       // and so far, in half windows, its border may be from where it should be
    double deviation = 0;             // of a corner, as given, from the panel's plane
  };

  struct Reflection {
    ReflectionOptions asked;
    double reached = 0;  // in smooth mode: the largest share of a panel's image area that may be wrong
    std::vector<ReflectedPanel> panels;
    std::uint64_t pyramids = 0;
    std::uint64_t obstacles = 0;
    std::uint64_t blocked = 0;
  };

  struct BelowResolution {
    std::size_t count = 0;      // of faces with a visible polygon below resolution
    std::vector<FaceId> faces;  // the first of them
  };

  // read, and of the stages contacts and cut, are shared by all cameras of a scene.
  struct Seconds {
    double read = 0;
    StageSeconds stages;
    double write = 0;  // the other files

    [[nodiscard]] double total() const;
  };

  Surface surface;
  Camera camera;
  SidesPolicy sides_asked = SidesPolicy::automatic;
  SidesDecision sides;
  Precision precision;
  Engine engine = Engine::fast;
  Counts counts;
  Areas areas;
  AreasOfInterest of_interest;
  Reflection reflection;
  BelowResolution below_resolution;
  SurfaceDoubts surface_doubts;
  Seconds seconds;
  std::uint64_t peak_memory_bytes = 0;
  predicates::Counts predicates;
  std::vector<std::string> warnings;
  std::vector<std::string> doubts;  // of the warnings those about the camera, in brief
};

// faces: measure_faces(analysis.view). write_seconds: for the other files.
[[nodiscard]] Report make_report(const SceneDescription& scene, const MeshInput& input, const ViewAnalysis& analysis,
                                 const std::vector<FaceMeasures>& faces, double write_seconds);

}  // namespace sightline::cli
