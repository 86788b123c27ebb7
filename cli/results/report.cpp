#include "cli/results/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "cli/results/view_doubts.h"
#include "cli/system/resources.h"
#include "formats/writing/window_points.h"

namespace sightline::cli {

namespace {

constexpr std::size_t listed_faces = 100;

template <class Items, class Holds>
std::size_t count_of(const Items& items, Holds holds) {
  return static_cast<std::size_t>(std::count_if(items.begin(), items.end(), holds));
}

template <class Value>
void sort_distinct(std::vector<Value>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

// The pairs of faces that pass through each other. On the grid the mesh is cut along common lines; without rounding the pairs
// are those that are seen to.
std::size_t crossing_pair_count(const View& view) {
  const CutMesh& mesh = view.mesh();
  const auto face = [&](UncutFacetId uncut) { return mesh.facet_face[mesh.first_piece(uncut).index()]; };
  std::vector<std::array<FaceId, 2>> pairs;
  for (const auto& [a, b] : mesh.cuts.crossing) pairs.push_back({face(a), face(b)});
  const std::size_t scene_edges = view.scene.edge_count();
  for (const VisibleSegment& s : view.segments.segments) {
    if (s.edge.index() < scene_edges) continue;
    const auto& [a, b] = view.segments.swap_edges[s.edge.index() - scene_edges].surfaces;
    pairs.push_back({mesh.facet_face[a.index()], mesh.facet_face[b.index()]});
  }
  sort_distinct(pairs);
  return pairs.size();
}

Report::FaceCounts face_counts(const std::vector<FaceMeasures>& faces) {
  const auto with_label = [&](Label label) {
    return count_of(
        faces, [&](const FaceMeasures& face) { return face.facing != FaceFacing::skipped && face.label == label; });
  };
  const auto reflects = [](const FaceMeasures& face) {
    return std::any_of(face.reflecting_area.begin(), face.reflecting_area.end(), [](double area) { return area > 0; });
  };
  Report::FaceCounts counts;
  counts.visible = with_label(Label::visible);
  counts.reflecting = count_of(faces, reflects);
  counts.hidden = with_label(Label::hidden);
  counts.out_of_view = with_label(Label::out_of_view);
  counts.back_facing = with_label(Label::back_facing);
  counts.skipped = count_of(faces, [](const FaceMeasures& face) { return face.facing == FaceFacing::skipped; });
  return counts;
}

Report::Counts counts_of(const View& view, const std::vector<FaceMeasures>& faces) {
  const std::vector<VisiblePolygon>& polygons = view.polygons.polygons;
  Report::Counts counts;
  counts.faces = face_counts(faces);
  counts.edges = view.scene.edge_count();
  counts.sweep_points = view.segments.statistics.sweep_points;
  counts.crossings = view.segments.statistics.crossings;
  counts.visible_segments = view.segments.segments.size();
  counts.visible_polygons = polygons.size();
  counts.below_resolution = count_of(polygons, [](const VisiblePolygon& polygon) { return polygon.below_resolution; });
  counts.holes = view.polygons.ring_count() - polygons.size();
  counts.output_triangles = view.labelled.triangles.size();
  counts.crossing_pairs = crossing_pair_count(view);
  return counts;
}

double sum(const std::vector<FaceMeasures>& faces, double FaceMeasures::*area) {
  double total = 0;
  for (const FaceMeasures& face : faces) total += face.*area;
  return total;
}

// The polygons' areas are rounded, so that their sum may exceed all by a few units in the last place.
double uncovered_area(const Camera& camera, const VisiblePolygons& polygons) {
  const double all = camera.lens_image ? frame_area(*camera.lens_image) : 4;
  double covered = 0;
  for (const VisiblePolygon& polygon : polygons.polygons) covered += polygon.area;
  return std::max(0.0, all - covered);
}

Report::Areas areas_of(const View& view, const std::vector<FaceMeasures>& faces) {
  return {sum(faces, &FaceMeasures::area), sum(faces, &FaceMeasures::in_view_area),
          sum(faces, &FaceMeasures::visible_area), sum(faces, &FaceMeasures::visible_image_area),
          uncovered_area(view.scene.camera, view.polygons)};
}

bool is_of_interest(const MeshInput& input, std::size_t face) {
  return input.of_interest.empty() || input.of_interest[face] != 0;
}

Report::AreasOfInterest areas_of_interest(const MeshInput& input, const std::vector<FaceMeasures>& faces) {
  Report::AreasOfInterest areas;
  areas.were_chosen = !input.of_interest.empty();
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (!is_of_interest(input, f)) continue;
    ++areas.faces;
    areas.surface += faces[f].area;
    areas.in_view += faces[f].in_view_area;
    areas.visible += faces[f].visible_area;
    areas.image_visible += faces[f].visible_image_area;
  }
  return areas;
}

// Twice the area of a triangle in the window.
double twice_window_area(const Camera& camera, const LabelledMesh& labelled, const LabelledTriangle& t) {
  const auto place = [&](std::size_t i) { return window_place(camera, labelled.vertices[t.corners[i].index()]); };
  const Point2 a = place(0);
  const Point2 b = place(1);
  const Point2 c = place(2);
  return std::fabs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

void measure_triangles(const View& view, std::size_t panel, Report::ReflectedPanel& reflected) {
  for (const LabelledTriangle& t : view.labelled.triangles) {
    if ((t.reflecting >> panel & 1U) == 0) continue;
    ++reflected.polygons;
    reflected.image_area += twice_window_area(view.scene.camera, view.labelled, t) / 2;
  }
}

// Those below resolution are counted, but have no area.
void measure_polygons(const VisiblePolygons& polygons, Report::ReflectedPanel& reflected) {
  reflected.polygons = polygons.polygons.size();
  for (const VisiblePolygon& polygon : polygons.polygons)
    reflected.image_area += polygon.below_resolution ? 0 : polygon.area;
}

Report::ReflectedPanel reflected_panel(const Panel& panel, std::size_t index, const MeshInput& input, const View& view,
                                       const std::vector<FaceMeasures>& faces) {
  Report::ReflectedPanel reflected;
  reflected.name = panel.name;
  reflected.emits = panel.emits;
  reflected.deviation = fitted_panel(panel).deviation;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    reflected.area += faces[f].reflecting_area[index];
    if (is_of_interest(input, f)) reflected.area_of_interest += faces[f].reflecting_area[index];
  }
  reflected.uncertain_image_area = view.reflections.panels[index].uncertain_area;
  reflected.border_distance = view.reflections.panels[index].border_distance;
  if (view.reflections.mode == ReflectionMode::triangles) {
    measure_triangles(view, index, reflected);
  } else {
    measure_polygons(view.reflections.panels[index].polygons, reflected);
  }
  return reflected;
}

Report::Reflection reflection_of(const SceneDescription& scene, const MeshInput& input, const View& view,
                                 const std::vector<FaceMeasures>& faces) {
  const ReflectionStatistics& statistics = view.reflections.statistics;
  Report::Reflection reflection;
  reflection.asked = scene.reflection;
  for (std::size_t p = 0; p < view.reflections.panels.size(); ++p)
    reflection.panels.push_back(reflected_panel(scene.panels[p], p, input, view, faces));
  for (const Report::ReflectedPanel& panel : reflection.panels) {
    if (panel.image_area > 0)
      reflection.reached = std::max(reflection.reached, panel.uncertain_image_area / panel.image_area);
  }
  reflection.pyramids = statistics.pyramids;
  reflection.obstacles = statistics.obstacles;
  reflection.blocked = statistics.blocked;
  return reflection;
}

Report::BelowResolution below_resolution_of(const VisiblePolygons& polygons) {
  std::vector<FaceId> faces;
  for (const VisiblePolygon& polygon : polygons.polygons) {
    if (polygon.below_resolution) faces.push_back(polygon.face);
  }
  sort_distinct(faces);
  const std::size_t count = faces.size();
  faces.resize(std::min(count, listed_faces));
  return {count, faces};
}

// Warns of what was found before any camera looked, of an eye on a face, and of polygons below resolution.
std::vector<std::string> warnings_of(const MeshInput& input, const View& view, std::size_t faces_below_resolution) {
  std::vector<std::string> warnings = input.warnings;
  if (auto warning = eye_warning(view.mesh(), view.scene.camera, input.doubts.distance))
    warnings.push_back(*std::move(warning));
  if (faces_below_resolution > 0) {
    warnings.push_back(fmt::format("visible polygons below resolution, which do not count as visible, on {} face{}",
                                   faces_below_resolution, faces_below_resolution == 1 ? "" : "s"));
  }
  return warnings;
}

void add_doubts(const View& view, Report& report) {
  const Report::FaceCounts& faces = report.counts.faces;
  const InView in_view{faces.visible + faces.hidden > 0, report.areas.in_view > 0, faces.back_facing > 0};
  for (const ViewDoubt& doubt : doubts_about_view(view, in_view)) {
    report.warnings.push_back(doubt.full);
    report.doubts.push_back(doubt.brief);
  }
}

}  // namespace

double Report::Seconds::total() const {
  return read + stages.contacts + stages.cut + stages.sides + stages.project + stages.sweep + stages.reconstruct +
         stages.reflect + stages.label + write;
}

Report make_report(const SceneDescription& scene, const MeshInput& input, const ViewAnalysis& analysis,
                   const std::vector<FaceMeasures>& faces, double write_seconds) {
  const CutMesh& mesh = analysis.view.mesh();
  const View& view = analysis.view;
  Report report;
  report.surface = {scene.file,        scene.mesh_file,          mesh.input_vertex_count(),
                    mesh.face_count(), mesh.uncut_facet_count(), input.parts};
  report.camera = view.scene.camera;
  report.sides_asked = analysis.asked.sides;
  report.sides = view.sides;
  report.precision = {view.scene.arithmetic, view.scene.grid_bits};
  report.engine = analysis.asked.engine;
  report.counts = counts_of(view, faces);
  report.areas = areas_of(view, faces);
  report.of_interest = areas_of_interest(input, faces);
  report.reflection = reflection_of(scene, input, view, faces);
  report.below_resolution = below_resolution_of(view.polygons);
  report.seconds = {input.read_seconds, analysis.seconds, write_seconds};
  report.peak_memory_bytes = peak_memory_bytes();
  report.predicates = view.segments.statistics.predicates;
  report.surface_doubts = input.doubts;
  report.warnings = warnings_of(input, view, report.below_resolution.count);
  add_doubts(view, report);
  return report;
}

}  // namespace sightline::cli
