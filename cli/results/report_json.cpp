#include "cli/results/report_json.h"

#include <algorithm>

namespace sightline::cli {

namespace {

constexpr std::size_t most_listed = 100;

Json part_json(const ScenePart& part) {
  return {{"file", part.file}, {"name", part.name}, {"first_face", part.first_face}, {"faces", part.face_count}};
}

Json surface_json(const Report::Surface& surface) {
  return {{"file", surface.scene_file}, {"mesh", surface.mesh_file}, {"vertices", surface.vertices},
          {"faces", surface.faces},     {"facets", surface.facets},  {"meshes", list_json(surface.parts, part_json)}};
}

Json warped_json(const WarpedFaces& warped) {
  Json part = {{"count", warped.count}, {"largest_deviation", warped.largest_deviation}};
  part["face"] = warped.count > 0 ? Json(warped.face.value) : Json(nullptr);
  return part;
}

// Lists the first pairs of faces; there may be as many as there are faces.
Json coincidences_json(const SurfaceDoubts& doubts, bool snaps) {
  const auto face_pair = [](const FaceCoincidence& pair) -> Json {
    return {{"faces", {pair.first.value, pair.second.value}},
            {"distance", pair.distance},
            {"overlap", pair.overlap},
            {"coplanar", pair.distance == 0 || pair.is_snapped}};
  };
  const auto panel_pair = [](const PanelCoincidence& pair) -> Json {
    Json part = {{"panel", pair.panel}, {"distance", pair.distance}, {"overlap", pair.overlap}};
    if (pair.face) part["face"] = pair.face->value;
    if (!pair.face) part["other_panel"] = pair.other_panel;
    return part;
  };
  const std::vector<FaceCoincidence> listed(
      doubts.faces.begin(),
      doubts.faces.begin() + static_cast<std::ptrdiff_t>(std::min(doubts.faces.size(), most_listed)));
  return {{"distance", doubts.distance},
          {"policy", snaps ? "snap" : "exact"},
          {"face_pairs", doubts.faces.size()},
          {"faces", list_json(listed, face_pair)},
          {"panels", list_json(doubts.panels, panel_pair)}};
}

Json lens_json(const LensImage& image) {
  return {{"model", to_string(image.lens.model)},     {"radial", image.lens.radial},
          {"tangential", image.lens.tangential},      {"prism", image.lens.prism},
          {"image", {image.width, image.height}},     {"frame_corners", image.frame.size()},
          {"frame_tolerance", image.frame_tolerance}, {"frame_area", frame_area(image)}};
}

Json camera_json(const Camera& camera) {
  const Vector3& eye = camera.eye.xyz;
  Json part = {
      {"name", camera.name},
      {"kind", camera.projection == Projection::perspective ? "perspective" : "orthographic"},
      {"rows", {{"right", as_json(camera.right)}, {"up", as_json(camera.up)}, {"forward", as_json(camera.forward)}}},
      {"origin", as_json(camera.origin)},
      {"eye", {eye.x(), eye.y(), eye.z(), camera.eye.w}},
      {"near", as_json(camera.near_distance)},
      {"far", as_json(camera.far_distance)},
      {"aspect", camera.aspect}};
  if (camera.matrix_sign) part["matrix_sign"] = *camera.matrix_sign;
  if (camera.lens_image) part["lens"] = lens_json(*camera.lens_image);
  return part;
}

Json sides_json(SidesPolicy asked, const SidesDecision& decision) {
  return {{"asked", to_string(asked)},
          {"used", decision.sides == Sides::front ? "front" : "both"},
          {"reason", decision.reason}};
}

Json precision_json(const Precision& precision) {
  if (precision.arithmetic == Arithmetic::unrounded) return {{"arithmetic", to_string(precision.arithmetic)}};
  return {{"arithmetic", to_string(precision.arithmetic)}, {"grid_bits", precision.grid_bits}};
}

Json face_counts_json(const Report::FaceCounts& faces) {
  return {{"visible", faces.visible},         {"reflecting", faces.reflecting},   {"hidden", faces.hidden},
          {"out_of_view", faces.out_of_view}, {"back_facing", faces.back_facing}, {"skipped", faces.skipped}};
}

Json counts_json(const Report::Counts& counts) {
  return {{"faces", face_counts_json(counts.faces)},     {"edges", counts.edges},
          {"sweep_points", counts.sweep_points},         {"crossings", counts.crossings},
          {"visible_segments", counts.visible_segments}, {"visible_polygons", counts.visible_polygons},
          {"below_resolution", counts.below_resolution}, {"holes", counts.holes},
          {"output_triangles", counts.output_triangles}, {"crossing_pairs", counts.crossing_pairs}};
}

Json interest_json(const Report::AreasOfInterest& areas) {
  return {{"faces", areas.faces},
          {"surface", areas.surface},
          {"in_view", areas.in_view},
          {"visible", areas.visible},
          {"image_visible", areas.image_visible}};
}

Json areas_json(const Report::Areas& areas, const Report::AreasOfInterest& interest) {
  Json part = {{"surface", areas.surface},
               {"in_view", areas.in_view},
               {"visible", areas.visible},
               {"image_visible", areas.image_visible},
               {"image_uncovered", areas.image_uncovered}};
  if (interest.were_chosen) part["of_interest"] = interest_json(interest);
  return part;
}

// Says what the mode was asked for, and how far it came.
Json mode_json(const Report::Reflection& reflection) {
  const ReflectionOptions& asked = reflection.asked;
  Json part = {{"mode", to_string(asked.mode)}};
  if (asked.mode == ReflectionMode::triangles) part["normals"] = to_string(asked.normals);
  if (asked.mode == ReflectionMode::smooth) {
    part["tolerance"] = asked.tolerance;
    part["reached"] = reflection.reached;
  }
  return part;
}

Json reflection_json(const Report::Reflection& reflection, bool interest_was_chosen) {
  const char* const noun = reflection.asked.mode == ReflectionMode::triangles ? "triangles" : "polygons";
  const auto panel_json = [&](const Report::ReflectedPanel& panel) -> Json {
    Json part = {{"name", panel.name},   {"emits", as_json(panel.emits)},
                 {"area", panel.area},   {"image_area", panel.image_area},
                 {noun, panel.polygons}, {"deviation", panel.deviation}};
    if (interest_was_chosen) part["area_of_interest"] = panel.area_of_interest;
    if (reflection.asked.mode == ReflectionMode::smooth) {
      part["uncertain_image_area"] = panel.uncertain_image_area;
      part["border_distance"] = panel.border_distance;
    }
    return part;
  };
  Json part = mode_json(reflection);
  part.update({{"panels", list_json(reflection.panels, panel_json)},
               {"pyramids", reflection.pyramids},
               {"obstacles", reflection.obstacles},
               {"blocked", reflection.blocked}});
  return part;
}

Json below_resolution_json(const Report::BelowResolution& below) {
  return {{"count", below.count}, {"faces", as_json(below.faces)}};
}

Json seconds_json(const Report::Seconds& seconds) {
  return {{"read", seconds.read},
          {"contacts", seconds.stages.contacts},
          {"cut", seconds.stages.cut},
          {"sides", seconds.stages.sides},
          {"project", seconds.stages.project},
          {"sweep", seconds.stages.sweep},
          {"reconstruct", seconds.stages.reconstruct},
          {"reflect", seconds.stages.reflect},
          {"label", seconds.stages.label},
          {"write", seconds.write},
          {"total", seconds.total()}};
}

Json predicates_json(const predicates::Counts& counts) {
  const double share = counts.calls == 0 ? 1 : static_cast<double>(counts.filtered) / static_cast<double>(counts.calls);
  return {{"calls", counts.calls}, {"filter_share", share}};
}

}  // namespace

Json report_json(const Report& report) {
  return {{"scene", surface_json(report.surface)},
          {"camera", camera_json(report.camera)},
          {"sides", sides_json(report.sides_asked, report.sides)},
          {"precision", precision_json(report.precision)},
          {"engine", report.engine == Engine::fast ? "fast" : "full"},
          {"counts", counts_json(report.counts)},
          {"areas", areas_json(report.areas, report.of_interest)},
          {"reflections", reflection_json(report.reflection, report.of_interest.were_chosen)},
          {"below_resolution", below_resolution_json(report.below_resolution)},
          {"warped_faces", warped_json(report.surface_doubts.warped)},
          {"coincidences", coincidences_json(report.surface_doubts, report.reflection.asked.snaps)},
          {"times_s", seconds_json(report.seconds)},
          {"peak_memory_bytes", report.peak_memory_bytes},
          {"predicates", predicates_json(report.predicates)},
          {"warnings", report.warnings}};
}

std::string report_text(const Report& report) { return json_text(report_json(report)); }

}  // namespace sightline::cli
