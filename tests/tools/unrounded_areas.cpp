#include "tests/tools/unrounded_areas.h"

#include "sweep/segments/image_points.h"

namespace sightline::tests {

UnroundedView unrounded_view(const Mesh& mesh, const Camera& camera, Sides sides) {
  return unrounded_view(uncrossed(mesh), camera, sides);
}

UnroundedView unrounded_view(const CutMesh& mesh, const Camera& camera, Sides sides) {
  UnroundedView view;
  view.scene = project(mesh, camera, sides, {Arithmetic::unrounded});
  view.segments = unrounded_sweep(view.scene, depth_ranges(view.scene), nullptr, &view.counts);
  return view;
}

UnroundedAreas unrounded_areas(const Mesh& mesh, const Camera& camera, Sides sides) {
  return unrounded_areas(uncrossed(mesh), camera, sides);
}

UnroundedAreas unrounded_areas(const CutMesh& mesh, const Camera& camera, Sides sides) {
  const UnroundedView view = unrounded_view(mesh, camera, sides);
  const ImagePoints points(view.scene, view.segments);
  UnroundedAreas areas{decltype(UnroundedAreas::of_face)(mesh.face_count()), 0, view.counts};
  for (const VisibleSegment& s : view.segments.segments) {
    const ExactPlace a = points.exact(s.start);
    const ExactPlace b = points.exact(s.end);
    areas.of_face[mesh.facet_face[s.facet.index()].index()] +=
        {BigInteger(a.x * b.y - a.y * b.x), BigInteger(2 * a.w * b.w)};
    areas.along_swaps += s.edge.index() >= view.scene.edge_count() ? 1 : 0;
  }
  return areas;
}

}  // namespace sightline::tests
