#include "coverage/seen_part.h"

#include "geometry/projection/frame_cut.h"

namespace sightline::inline coverage {
namespace {

SeenSurface summed_up(std::span<const LabelledTriangle> triangles) {
  SeenSurface result{triangles[0].surface, 0, triangles[0].reflecting, 0, true};
  for (const LabelledTriangle& t : triangles) {
    result.reflecting_everywhere &= t.reflecting;
    result.reflecting_somewhere |= t.reflecting;
    result.seen_everywhere = result.seen_everywhere && t.seen;
  }
  return result;
}

bool is_alike(const SeenSurface& surface) {
  return surface.seen_everywhere && surface.reflecting_everywhere == surface.reflecting_somewhere;
}

SpaceTriangle placed(const LabelledMesh& labelled, const LabelledTriangle& t) {
  const auto& [a, b, c] = t.corners;
  return {labelled.vertices[a.index()], labelled.vertices[b.index()], labelled.vertices[c.index()]};
}

// `triangles` are all of one surface.
void add(SeenPart& part, const LabelledMesh& labelled, std::span<const LabelledTriangle> triangles) {
  SeenSurface surface = summed_up(triangles);
  surface.first_triangle = static_cast<std::uint32_t>(part.triangles.size());
  if (!is_alike(surface)) {
    for (const LabelledTriangle& t : triangles) {
      if (t.seen) part.triangles.push_back({placed(labelled, t), t.reflecting});
    }
    if (part.triangles.size() == surface.first_triangle) return;
  }
  part.surfaces.push_back(surface);
}

}  // namespace

SeenPart seen_part(const LabelledMesh& labelled) {
  SeenPart part;
  const std::span<const LabelledTriangle> all(labelled.triangles);
  for (std::size_t first = 0, end = 0; first < all.size(); first = end) {
    while (end < all.size() && all[end].surface == all[first].surface) ++end;
    add(part, labelled, all.subspan(first, end - first));
  }
  return part;
}

SeenPart seen_part(const LabelledMesh& labelled, const CutMesh& mesh) {
  SeenPart part = seen_part(labelled);
  for (SeenSurface& surface : part.surfaces) surface.surface = surface_before_frame(mesh, surface.surface);
  return part;
}

}  // namespace sightline::inline coverage
