#include "reconstruct/labelling/labelled_mesh.h"

#include <algorithm>

#include "geometry/numbers/parallel.h"
#include "reconstruct/labelling/surface_labeller.h"

namespace sightline::inline reconstruct {
namespace {

template <class Visit>
void for_each_vertex_from(std::size_t first, std::vector<LabelledTriangle>& triangles, const Visit& visit) {
  for (LabelledTriangle& t : triangles) {
    for (VertexId& v : t.corners) {
      if (v.index() >= first) visit(v);
    }
  }
}

// The new vertices of the parts follow each other.
LabelledMesh put_together(std::vector<Point3> common, std::vector<LabelledPart>& parts) {
  const std::size_t first_new = common.size();
  LabelledMesh all{std::move(common), {}};
  std::size_t triangles = 0;
  for (const LabelledPart& part : parts) triangles += part.triangles.size();
  all.triangles.reserve(triangles);
  for (LabelledPart& part : parts) {
    const std::size_t moved = all.vertices.size() - first_new;
    if (moved > 0)
      for_each_vertex_from(first_new, part.triangles, [&](VertexId& v) { v = VertexId(v.index() + moved); });
    all.triangles.insert(all.triangles.end(), part.triangles.begin(), part.triangles.end());
    all.vertices.insert(all.vertices.end(), part.new_vertices.begin(), part.new_vertices.end());
    part = {};
  }
  return all;
}

// A split of a line between two facets of one planar face may turn out to be no border of anything.
void drop_unused_vertices(std::size_t input, LabelledMesh& labelled) {
  std::vector<std::uint8_t> used(labelled.vertices.size() - input, 0);
  for_each_vertex_from(input, labelled.triangles, [&](const VertexId& v) { used[v.index() - input] = 1; });
  if (std::ranges::count(used, 0) == 0) return;
  std::vector<VertexId> renamed(used.size());
  std::size_t kept = input;
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (used[i] == 0) continue;
    labelled.vertices[kept] = labelled.vertices[input + i];
    renamed[i] = VertexId(kept++);
  }
  labelled.vertices.resize(kept);
  for_each_vertex_from(input, labelled.triangles, [&](VertexId& v) { v = renamed[v.index() - input]; });
}

LabelledMesh labelled_mesh(LabelSources from) {
  std::vector<LabelledPart> parts(range_count(from.mesh.facet_count()));
  parallel_for_ranges(from.mesh.facet_count(), [&](std::size_t range, std::size_t begin, std::size_t end) {
    parts[range] = label_surfaces(from, begin, end);
  });
  LabelledMesh labelled = put_together(std::move(from.vertices), parts);
  drop_unused_vertices(from.mesh.input_vertex_count(), labelled);
  return labelled;
}

// Labelling builds on what the stages before it promise, which float and double do not always keep.
void require_valid(const ProjectedScene& scene, const VisibleSegments& segments, const VisiblePolygons& polygons) {
  for (const auto& messages : {validate(segments, scene), validate(polygons, scene, segments)}) {
    if (!messages.empty()) throw ArithmeticError(to_string(scene.arithmetic), messages.front());
  }
}

}  // namespace

const char* to_string(Label label) {
  switch (label) {
    case Label::back_facing:
      return "back_facing";
    case Label::out_of_view:
      return "out_of_view";
    case Label::hidden:
      return "hidden";
    case Label::visible:
      return "visible";
  }
  return "";
}

LabelledMesh label_mesh(const ProjectedScene& scene, const VisibleSegments& segments, const VisiblePolygons& polygons,
                        const PanelBorders& panels) {
  if (!is_exact(scene.arithmetic)) require_valid(scene, segments, polygons);
  return with_invariants_of(scene.arithmetic,
                            [&] { return labelled_mesh(LabelSources(scene, segments, polygons, panels)); });
}

}  // namespace sightline::inline reconstruct
