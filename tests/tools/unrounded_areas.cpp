#include "tests/tools/unrounded_areas.h"

namespace sightline::tests {

UnroundedAreas unrounded_areas(const Mesh& mesh, const Camera& camera, Sides sides) {
  const UnroundedScene scene = project_unrounded(std::make_shared<const CutMesh>(uncrossed(mesh)), camera, sides);
  const UnroundedSegments found = unrounded_sweep(scene);
  UnroundedAreas areas{decltype(UnroundedAreas::of_face)(mesh.face_count()), 0, found.decider->counts()};
  for (const VisibleSegment& s : found.segments.segments) {
    const ExactPlace a = found.exact(s.start);
    const ExactPlace b = found.exact(s.end);
    areas.of_face[mesh.facet_face[s.facet.index()].index()] +=
        {BigInteger(a.x * b.y - a.y * b.x), BigInteger(2 * a.w * b.w)};
    areas.along_swaps += found.decider->is_swap_edge(s.edge) ? 1 : 0;
  }
  return areas;
}

}  // namespace sightline::tests
