#include "cli/results/face_measures.h"

#include <algorithm>
#include <cmath>

#include "geometry/mesh/area.h"

namespace sightline::cli {

namespace {

double in_view_area(const ProjectedScene& scene, FacetId facet) {
  return fan_area(scene.polygon(facet), [&](const ClippedCorner& corner) { return position_of(scene, corner); });
}

// In window units squared. Places that are not rounded are known up to their radius.
double unrounded_image_area(const ProjectedScene& scene, FacetId facet) {
  const auto corners = scene.polygon(facet);
  const auto place = [&](std::size_t i) { return scene.unrounded.places[corners[i].point.index()]; };
  double twice = 0;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const auto& [ax, ay, a_radius] = place(0);
    const auto& [bx, by, b_radius] = place(i - 1);
    const auto& [cx, cy, c_radius] = place(i);
    twice += (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
  }
  return std::fabs(twice) / 2;
}

// Twice the area in grid units squared, exactly.
Int128 twice_image_area(const ProjectedScene& scene, FacetId facet) {
  const auto corners = scene.polygon(facet);
  Int128 twice = 0;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    twice +=
        twice_area(scene.point(corners[0].point), scene.point(corners[i - 1].point), scene.point(corners[i].point));
  }
  return twice < 0 ? -twice : twice;
}

double in_window_units(Int128 twice_area, int grid_bits) {
  return std::ldexp(static_cast<double>(twice_area), -2 * grid_bits - 1);
}

FaceFacing face_facing(FacetFacing facing) {
  if (facing == FacetFacing::front) return FaceFacing::front;
  return facing == FacetFacing::back ? FaceFacing::back : FaceFacing::edge_on;
}

FaceFacing face_facing(const ProjectedScene& scene, FaceId face) {
  const CutMesh& mesh = scene.mesh();
  const std::size_t first = mesh.first_facet(face);
  const std::size_t end = mesh.end_facet(face);
  if (first == end) return FaceFacing::skipped;
  const bool alike = std::all_of(scene.facing.begin() + static_cast<std::ptrdiff_t>(first),
                                 scene.facing.begin() + static_cast<std::ptrdiff_t>(end),
                                 [&](FacetFacing facing) { return facing == scene.facing[first]; });
  return alike ? face_facing(scene.facing[first]) : FaceFacing::mixed;
}

FaceMeasures measure_facets(const ProjectedScene& scene, FaceId face) {
  const CutMesh& mesh = scene.mesh();
  FaceMeasures measures;
  measures.facing = face_facing(scene, face);
  Int128 twice_image = 0;
  for (std::size_t i = mesh.first_facet(face); i < mesh.end_facet(face); ++i) {
    const FacetId facet(i);
    measures.area += facet_area(mesh, facet);
    measures.in_view_area += in_view_area(scene, facet);
    if (scene.is_unrounded()) measures.image_area += unrounded_image_area(scene, facet);
    if (!scene.is_unrounded()) twice_image += twice_image_area(scene, facet);
  }
  if (!scene.is_unrounded()) measures.image_area = in_window_units(twice_image, scene.grid_bits);
  return measures;
}

void add_triangles(const LabelledMesh& labelled, std::vector<FaceMeasures>& faces) {
  for (const LabelledTriangle& triangle : labelled.triangles) {
    FaceMeasures& face = faces[triangle.face.index()];
    face.label = std::max(face.label, triangle.label);
    const auto& [a, b, c] = triangle.corners;
    if (!triangle.seen) continue;
    const double area =
        triangle_area(labelled.vertices[a.index()], labelled.vertices[b.index()], labelled.vertices[c.index()]);
    face.visible_area += area;
    if (triangle.reflecting != 0) face.any_reflecting_area += area;
    for (std::size_t p = 0; p < face.reflecting_area.size(); ++p) {
      if ((triangle.reflecting >> p & 1U) != 0) face.reflecting_area[p] += area;
    }
  }
}

void add_polygons(const VisiblePolygons& polygons, std::vector<FaceMeasures>& faces) {
  for (const VisiblePolygon& polygon : polygons.polygons) {
    if (!polygon.below_resolution) faces[polygon.face.index()].visible_image_area += polygon.area;
  }
}

// What is seen is a part of what is in view, and that of the face. Sums of areas in double may break this in their last bits.
void keep_order(FaceMeasures& face) {
  face.in_view_area = std::min(face.in_view_area, face.area);
  face.visible_area = std::min(face.visible_area, face.in_view_area);
  face.any_reflecting_area = std::min(face.any_reflecting_area, face.visible_area);
  for (double& area : face.reflecting_area) area = std::min(area, face.visible_area);
  face.visible_image_area = std::min(face.visible_image_area, face.image_area);
}

}  // namespace

const char* to_string(FaceFacing facing) {
  switch (facing) {
    case FaceFacing::front:
      return "front";
    case FaceFacing::back:
      return "back";
    case FaceFacing::edge_on:
      return "edge-on";
    case FaceFacing::mixed:
      return "mixed";
    case FaceFacing::skipped:
      return "skipped";
  }
  return "";
}

std::vector<FaceMeasures> measure_faces(const View& view) {
  const CutMesh& mesh = view.scene.mesh();
  std::vector<FaceMeasures> faces;
  faces.reserve(mesh.face_count());
  for (std::size_t f = 0; f < mesh.face_count(); ++f) faces.push_back(measure_facets(view.scene, FaceId(f)));
  for (FaceMeasures& face : faces) face.reflecting_area.resize(view.reflections.panels.size());
  add_triangles(view.labelled, faces);
  add_polygons(view.polygons, faces);
  if (view.scene.is_unrounded()) std::ranges::for_each(faces, keep_order);
  return faces;
}

void write_faces_table(const std::vector<FaceMeasures>& faces, const std::vector<std::string>& panels,
                       TextBuffer& out) {
  out << "face,facing,area,in_view_area,visible_area,image_area,visible_image_area";
  for (const std::string& panel : panels) out << ",reflecting_area:" << panel;
  out << '\n';
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const FaceMeasures& face = faces[f];
    out << std::uint64_t{f} << ',' << to_string(face.facing) << ',' << face.area << ',' << face.in_view_area << ','
        << face.visible_area << ',' << face.image_area << ',' << face.visible_image_area;
    for (const double area : face.reflecting_area) out << ',' << area;
    out << '\n';
  }
}

}  // namespace sightline::cli
