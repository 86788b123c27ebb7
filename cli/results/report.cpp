#include "cli/results/report.h"

#include <algorithm>
#include <cmath>

#include "cli/results/report_warnings.h"
#include "cli/system/resources.h"
#include "formats/writing/window_points.h"

namespace sightline::cli {

namespace {

constexpr std::size_t listed_faces = 100;

Report as_json(const Vector3& v) { return {v.x(), v.y(), v.z()}; }

Report as_json(const std::optional<double>& value) { return value ? Report(*value) : Report(nullptr); }

Report scene_part(const Scene& scene, const Mesh& mesh) {
  return {{"file", scene.file},
          {"mesh", scene.mesh_file},
          {"vertices", mesh.input_vertex_count()},
          {"faces", mesh.face_count()},
          {"facets", mesh.whole_count()}};
}

Report camera_part(const Camera& camera) {
  const Vector3& eye = camera.eye.xyz;
  return {
      {"name", camera.name},
      {"kind", camera.projection == Projection::perspective ? "perspective" : "orthographic"},
      {"rows", {{"right", as_json(camera.right)}, {"up", as_json(camera.up)}, {"forward", as_json(camera.forward)}}},
      {"origin", as_json(camera.origin)},
      {"eye", {eye.x(), eye.y(), eye.z(), camera.eye.w}},
      {"near", as_json(camera.near_distance)},
      {"far", as_json(camera.far_distance)},
      {"aspect", camera.aspect}};
}

const char* to_string(SidesPolicy policy) {
  if (policy == SidesPolicy::automatic) return "auto";
  return policy == SidesPolicy::front ? "front" : "both";
}

Report sides_part(const ViewAnalysis& analysis) {
  return {{"asked", to_string(analysis.asked.sides)},
          {"used", analysis.sides.sides == Sides::front ? "front" : "both"},
          {"reason", analysis.sides.reason}};
}

Report face_counts(const std::vector<FaceMeasures>& faces) {
  const auto with_label = [&](Label label) {
    return std::count_if(faces.begin(), faces.end(), [&](const FaceMeasures& face) {
      return face.facing != FaceFacing::skipped && face.label == label;
    });
  };
  const auto skipped = std::count_if(faces.begin(), faces.end(),
                                     [](const FaceMeasures& face) { return face.facing == FaceFacing::skipped; });
  const auto reflecting = std::count_if(faces.begin(), faces.end(), [](const FaceMeasures& face) {
    return std::any_of(face.reflecting_area.begin(), face.reflecting_area.end(), [](double area) { return area > 0; });
  });
  return {{"visible", with_label(Label::visible)},         {"reflecting", reflecting},
          {"hidden", with_label(Label::hidden)},           {"out_of_view", with_label(Label::out_of_view)},
          {"back_facing", with_label(Label::back_facing)}, {"skipped", skipped}};
}

Report counts_part(const MeshInput& input, const View& view, const std::vector<FaceMeasures>& faces) {
  const VisiblePolygons& polygons = view.polygons;
  const auto below = std::count_if(polygons.polygons.begin(), polygons.polygons.end(),
                                   [](const VisiblePolygon& polygon) { return polygon.below_resolution; });
  return {{"faces", face_counts(faces)},
          {"edges", view.scene.edge_count()},
          {"sweep_points", view.segments.statistics.sweep_points},
          {"crossings", view.segments.statistics.crossings},
          {"visible_segments", view.segments.segments.size()},
          {"visible_polygons", polygons.polygons.size()},
          {"below_resolution", below},
          {"holes", polygons.ring_count() - polygons.polygons.size()},
          {"output_triangles", view.labelled.triangles.size()},
          {"crossing_pairs", crossing_faces(input.mesh).size()}};
}

double sum(const std::vector<FaceMeasures>& faces, double FaceMeasures::*area) {
  double total = 0;
  for (const FaceMeasures& face : faces) total += face.*area;
  return total;
}

// Of the window's area 4. The polygons' areas are rounded, so that their sum may exceed 4 by a few units in the last
// place.
double uncovered_area(const VisiblePolygons& polygons) {
  double covered = 0;
  for (const VisiblePolygon& polygon : polygons.polygons) covered += polygon.area;
  return std::max(0.0, 4 - covered);
}

Report areas_part(const View& view, const std::vector<FaceMeasures>& faces) {
  return {{"surface", sum(faces, &FaceMeasures::area)},
          {"in_view", sum(faces, &FaceMeasures::in_view_area)},
          {"visible", sum(faces, &FaceMeasures::visible_area)},
          {"image_visible", sum(faces, &FaceMeasures::visible_image_area)},
          {"image_uncovered", uncovered_area(view.polygons)}};
}

// Twice the area of a triangle in the window.
double twice_window_area(const Camera& camera, const LabelledMesh& labelled, const LabelledTriangle& t) {
  const auto place = [&](std::size_t i) { return window_place(camera, labelled.vertices[t.corners[i].index()]); };
  const Point2 a = place(0);
  const Point2 b = place(1);
  const Point2 c = place(2);
  return std::fabs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

// What reflects a panel, in the image: polygons above resolution, or triangles.
Report in_image(const View& view, std::size_t panel) {
  double area = 0;
  if (view.reflections.mode == ReflectionMode::triangles) {
    std::size_t count = 0;
    for (const LabelledTriangle& t : view.labelled.triangles) {
      if ((t.reflecting >> panel & 1U) == 0) continue;
      ++count;
      area += twice_window_area(view.scene.camera, view.labelled, t) / 2;
    }
    return {{"image_area", area}, {"triangles", count}};
  }
  const VisiblePolygons& polygons = view.reflections.panels[panel].polygons;
  for (const VisiblePolygon& polygon : polygons.polygons) area += polygon.below_resolution ? 0 : polygon.area;
  return {{"image_area", area}, {"polygons", polygons.polygons.size()}};
}

// What the mode was asked for, and how far it came.
Report mode_part(const ReflectionOptions& options, const ReflectionStatistics& statistics) {
  Report part = {{"mode", to_string(options.mode)}};
  if (options.mode == ReflectionMode::triangles) part["normals"] = to_string(options.normals);
  if (options.mode == ReflectionMode::smooth) {
    const double looked = statistics.looked_area;
    part["tolerance"] = options.tolerance;
    part["reached"] = looked > 0 ? statistics.changed_area / looked : 0.0;
  }
  return part;
}

// area: on the surface.
Report reflections_part(const Scene& scene, const View& view, const std::vector<FaceMeasures>& faces) {
  const Reflections& reflections = view.reflections;
  Report panels = Report::array();
  for (std::size_t p = 0; p < reflections.panels.size(); ++p) {
    double area = 0;
    for (const FaceMeasures& face : faces) area += face.reflecting_area[p];
    Report panel = {{"name", scene.panels[p].name},
                    {"emits", scene.panels[p].emits == Emits::front ? "front" : "both"},
                    {"area", area}};
    panel.update(in_image(view, p));
    panels.push_back(std::move(panel));
  }
  Report part = mode_part(scene.reflection, reflections.statistics);
  part.update({{"panels", panels},
               {"pyramids", reflections.statistics.pyramids},
               {"obstacles", reflections.statistics.obstacles},
               {"blocked", reflections.statistics.blocked}});
  return part;
}

Report below_resolution_part(const VisiblePolygons& polygons) {
  const std::vector<FaceId> faces = faces_below_resolution(polygons);
  Report list = Report::array();
  for (std::size_t i = 0; i < std::min(faces.size(), listed_faces); ++i) list.push_back(faces[i].value);
  return {{"count", faces.size()}, {"faces", list}};
}

// total is the sum of the others; read, contacts and cut are shared by all cameras of a scene.
Report times_part(const MeshInput& input, const StageSeconds& seconds, double write_seconds) {
  Report times = {{"read", input.read_seconds},
                  {"contacts", input.contacts_seconds},
                  {"cut", input.cut_seconds},
                  {"sides", seconds.sides},
                  {"project", seconds.project},
                  {"sweep", seconds.sweep},
                  {"reconstruct", seconds.reconstruct},
                  {"reflect", seconds.reflect},
                  {"label", seconds.label},
                  {"write", write_seconds}};
  double total = 0;
  for (const auto& time : times) total += time.get<double>();
  times["total"] = total;
  return times;
}

Report predicates_part(const predicates::Counts& counts) {
  const double share = counts.calls == 0 ? 1 : static_cast<double>(counts.filtered) / static_cast<double>(counts.calls);
  return {{"calls", counts.calls}, {"filter_share", share}};
}

}  // namespace

Report make_report(const Scene& scene, const MeshInput& input, const ViewAnalysis& analysis,
                   const std::vector<FaceMeasures>& faces, double write_seconds) {
  const View& view = analysis.view;
  return {{"scene", scene_part(scene, input.mesh)},
          {"camera", camera_part(view.scene.camera)},
          {"sides", sides_part(analysis)},
          {"precision", {{"arithmetic", to_string(view.scene.arithmetic)}, {"grid_bits", view.scene.grid_bits}}},
          {"engine", analysis.asked.engine == Engine::fast ? "fast" : "full"},
          {"counts", counts_part(input, view, faces)},
          {"areas", areas_part(view, faces)},
          {"reflections", reflections_part(scene, view, faces)},
          {"below_resolution", below_resolution_part(view.polygons)},
          {"times_s", times_part(input, analysis.seconds, write_seconds)},
          {"peak_memory_bytes", peak_memory_bytes()},
          {"predicates", predicates_part(view.segments.statistics.predicates)},
          {"warnings", report_warnings(input, view)}};
}

std::string report_text(const Report& report) {
  return report.dump(2, ' ', false, Report::error_handler_t::replace) + "\n";
}

}  // namespace sightline::cli
