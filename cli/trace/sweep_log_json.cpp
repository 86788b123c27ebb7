#include "cli/trace/sweep_log_json.h"

#include <cmath>

#include "geometry/numbers/arithmetic.h"

namespace sightline::cli {

namespace {

constexpr int format_version = 1;

// A segment that is none is null.
Json number_json(trace::SegmentNumber number) { return number == 0 ? Json(nullptr) : Json(number); }

Json faces_json(const trace::SweepLog& log) {
  return list_json(log.face_names, [](const std::string& name) -> Json { return {{"name", name}}; });
}

// Those in view, with their outlines after clipping.
Json facets_json(const trace::SweepLog& log) {
  Json facets = Json::array();
  for (std::size_t f = 0; f < log.scene.status.size(); ++f) {
    if (log.scene.status[f] != FacetStatus::in_view) continue;
    Json outline = Json::array();
    for (const ClippedCorner& corner : log.scene.polygon(FacetId(f))) outline.push_back(corner.point.value);
    facets.push_back({{"facet", f}, {"face", log.face_of[f].value}, {"outline", outline}});
  }
  return facets;
}

Json points_json(const trace::SweepLog& log) {
  Json points = Json::array();
  const double scale = std::ldexp(1.0, -log.scene.grid_bits);
  for (std::size_t p = 0; p < log.scene.points.size(); ++p) {
    const ImagePoint& point = log.scene.points[p];
    points.push_back({{"name", log.point_names[p]},
                      {"x", static_cast<double>(point.x) * scale},
                      {"y", static_cast<double>(point.y) * scale}});
  }
  return points;
}

Json edges_json(const trace::SweepLog& log) {
  Json edges = Json::array();
  for (std::size_t e = 0; e < log.scene.edge_count(); ++e) {
    Json facets = Json::array();
    for (const EdgeSide& side : log.scene.sides_of(EdgeId(e))) facets.push_back(side.facet.value);
    edges.push_back(
        {{"upper", log.scene.edges[e].top.value}, {"lower", log.scene.edges[e].bottom.value}, {"facets", facets}});
  }
  return edges;
}

Json segment_json(const trace::LoggedSegment& segment) {
  const std::string& start = segment.upwards ? segment.lower : segment.upper;
  const std::string& end = segment.upwards ? segment.upper : segment.lower;
  return {{"surface", segment.surface.value},
          {"other", as_json(segment.other)},
          {"edge", segment.edge.value},
          {"upwards", segment.upwards},
          {"start", start},
          {"end", end},
          {"opened", segment.opened + 1},
          {"closed", segment.closed ? Json(*segment.closed + 1) : Json(nullptr)}};
}

Json place_json(const SweepPlace& place) {
  Json crossings = Json::array();
  for (const auto& pair : place.crossings) crossings.push_back({pair[0].value, pair[1].value});
  return {{"vertex", as_json(place.vertex)}, {"x", place.x}, {"y", place.y}, {"crossings", crossings}};
}

Json bundle_json(const trace::LoggedBundle& bundle) {
  return {{"edges", as_json(bundle.edges)},
          {"nodes", as_json(bundle.nodes)},
          {"left_segment", number_json(bundle.left_segment)},
          {"right_segment", number_json(bundle.right_segment)}};
}

Json predicate_json(const trace::LoggedPredicate& predicate) {
  Json operands = Json::array();
  for (const trace::Operand& operand : predicate.operands)
    operands.push_back({{"name", operand.name}, {"at", operand.coordinates}});
  return {{"question", predicate.question},
          {"says", predicate.says},
          {"formula", predicate.formula},
          {"operands", operands},
          {"sign", predicate.sign},
          {"exact_sign", as_json(predicate.exact_sign)},
          {"decided_by", predicate.decided_by}};
}

Json emitted_json(const trace::EmittedVertex& vertex) {
  return {{"surface", vertex.surface.value}, {"name", vertex.name}};
}

Json active_json(const trace::SweepStep& step) {
  return {{"position", step.position}, {"removed", step.removed}, {"inserted", list_json(step.inserted, bundle_json)}};
}

Json step_json(const trace::SweepStep& step) {
  Json json{{"kind", to_string(step.kind)}, {"name", step.name}};
  json.update(place_json(step.place));
  json.update({{"says", step.says},
               {"ended", as_json(step.ended)},
               {"started", as_json(step.started)},
               {"passed", as_json(step.passed)},
               {"active", active_json(step)},
               {"closed", step.closed},
               {"opened", step.opened},
               {"vertices", list_json(step.vertices, emitted_json)},
               {"appeared", as_json(step.appeared)},
               {"vanished", as_json(step.vanished)},
               {"surfaced", as_json(step.surfaced)},
               {"covered", as_json(step.covered)},
               {"thread", number_json(step.thread.value_or(0))},
               {"rings", step.rings},
               {"queue", list_json(step.upcoming, place_json)},
               {"predicates", list_json(step.predicates, predicate_json)}});
  return json;
}

Json ring_json(const trace::LoggedRing& ring) {
  return {
      {"surface", ring.surface.value}, {"polygon", ring.polygon}, {"hole", ring.is_hole}, {"segments", ring.segments}};
}

Json sweep_json(const trace::SweepLog& log) {
  return {{"arithmetic", to_string(log.scene.arithmetic)},
          {"grid_bits", log.scene.grid_bits},
          {"depth_is_transitive", log.depth_is_transitive},
          {"broken", log.broken.empty() ? Json(nullptr) : Json(log.broken)},
          {"faces", faces_json(log)},
          {"facets", facets_json(log)},
          {"points", points_json(log)},
          {"edges", edges_json(log)},
          {"segments", list_json(log.segments, segment_json)},
          {"rings", list_json(log.rings, ring_json)},
          {"steps", list_json(log.steps, step_json)}};
}

}  // namespace

Json sweep_logs_json(const TracedScene& scene, std::span<const trace::SweepLog> sweeps) {
  Json json{
      {"format", "sightline sweep log"}, {"version", format_version}, {"title", scene.title}, {"what", scene.what},
      {"camera", scene.camera},          {"aspect", scene.aspect}};
  json["sweeps"] = list_json(sweeps, sweep_json);
  return json;
}

}  // namespace sightline::cli
