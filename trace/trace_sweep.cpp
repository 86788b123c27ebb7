#include "trace/trace_sweep.h"

#include <algorithm>

#include "geometry/mesh/facet_plane.h"
#include "reconstruct/polygons/visible_polygons.h"

namespace sightline::trace {

namespace {

void add_ring(const Mesh& mesh, const VisiblePolygons& polygons, std::size_t polygon, std::size_t ring, SweepLog& log) {
  const VisiblePolygon& of = polygons.polygons[polygon];
  LoggedRing logged{surface_of(mesh, of.facet), polygon, ring != of.first_ring, {}};
  std::size_t closes = 0;
  for (const SegmentId s : polygons.ring(ring)) {
    logged.segments.push_back(static_cast<SegmentNumber>(s.index() + 1));
    closes = std::max(closes, log.segments[s.index()].closed.value());
  }
  log.steps[closes].rings.push_back(log.rings.size());
  log.steps[closes].says += logged.is_hole ? " With that the ring of a hole closes." : " With that a ring closes.";
  log.rings.push_back(std::move(logged));
}

void add_rings(const Mesh& mesh, const VisibleSegments& segments, SweepLog& log) {
  const VisiblePolygons polygons = reconstruct_polygons(mesh, log.scene, segments);
  for (std::size_t p = 0; p < polygons.polygons.size(); ++p) {
    const VisiblePolygon& polygon = polygons.polygons[p];
    for (std::size_t r = 0; r < polygon.ring_count; ++r) add_ring(mesh, polygons, p, polygon.first_ring + r, log);
  }
}

}  // namespace

SweepLog trace_sweep(const Mesh& mesh, ProjectedScene scene, const SceneNames& names, std::size_t most_points) {
  SweepLog log;
  log.scene = std::move(scene);
  log.point_names = names_of_points(mesh, log.scene, names);
  log.face_names = names_of_faces(mesh, names);
  log.face_of = mesh.facet_face;
  if (log.scene.points.size() > most_points) throw TooManySteps("the sweep has too many points to be traced");
  SweepRecorder recorder(mesh, names, most_points, log);
  try {
    add_rings(mesh, plain_sweep(mesh, log.scene, &recorder), log);
  } catch (const ArithmeticError& error) {
    log.broken = error.broken();
  }
  return log;
}

}  // namespace sightline::trace
