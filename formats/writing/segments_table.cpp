#include "formats/writing/segments_table.h"

#include <algorithm>
#include <optional>

#include "formats/writing/window_points.h"

namespace sightline::inline formats {

namespace {

// Returns the mesh edge of the face that lies along the segment; invalid where there is none.
MeshEdgeId edge_of_face(const ProjectedScene& scene, const VisibleSegment& segment, FaceId face) {
  const CutMesh& mesh = scene.mesh();
  for (const EdgeSide& side : sides_along(scene, segment)) {
    if (mesh.facet_face[side.facet.index()] == face && side.mesh_edge.valid()) return side.mesh_edge;
  }
  return {};
}

FaceId face_of(const CutMesh& mesh, FacetId facet) { return facet.valid() ? mesh.facet_face[facet.index()] : FaceId{}; }

// Returns the edge of the segment's own face, else of the face on its right.
MeshEdgeId edge_under(const ProjectedScene& scene, const VisibleSegment& segment) {
  const CutMesh& mesh = scene.mesh();
  const MeshEdgeId own = edge_of_face(scene, segment, face_of(mesh, segment.facet));
  if (own.valid() || !segment.other.valid()) return own;
  return edge_of_face(scene, segment, face_of(mesh, segment.other));
}

constexpr const char* common_line = "common";
constexpr const char* border_line = "border";

// An edge is named by its ends. A piece of an edge of the input is named as that edge is; where a lens is in use, only its frame
// makes others.
void write_edge(const CutMesh& mesh, MeshEdgeId edge, TextBuffer& out) {
  if (!edge.valid()) {
    out << border_line;
    return;
  }
  const auto& ends = mesh.is_cut() ? mesh.cuts.input_edge[edge.index()] : mesh.edges[edge.index()];
  if (!ends[0].valid()) {
    out << (mesh.cuts.outside_frame.empty() ? common_line : border_line);
    return;
  }
  const auto [low, high] = std::minmax(ends[0], ends[1]);
  out << low.value << '-' << high.value;
}

}  // namespace

void write_segments_table(const View& view, const std::vector<Point2>& places, TextBuffer& out) {
  const CutMesh& mesh = view.scene.mesh();
  const PlaceTexts texts(places);
  const Camera& camera = view.scene.camera;
  std::optional<PlaceTexts> pixels;
  if (camera.lens_image) pixels.emplace(bent_pixels(camera, places));
  out << "face,start_x,start_y,end_x,end_y,edge,other_face";
  if (pixels) out << ",start_pixel_x,start_pixel_y,end_pixel_x,end_pixel_y";
  out << '\n';
  for (const VisibleSegment& segment : view.segments.segments) {
    out << face_of(mesh, segment.facet).value << ',' << texts.x(segment.start) << ',' << texts.y(segment.start) << ','
        << texts.x(segment.end) << ',' << texts.y(segment.end) << ',';
    if (segment.edge.index() < view.scene.edge_count()) {
      write_edge(mesh, edge_under(view.scene, segment), out);
    } else {
      out << common_line;
    }
    out << ',';
    if (segment.other.valid()) out << face_of(mesh, segment.other).value;
    if (pixels) {
      out << ',' << pixels->x(segment.start) << ',' << pixels->y(segment.start) << ',' << pixels->x(segment.end) << ','
          << pixels->y(segment.end);
    }
    out << '\n';
  }
}

}  // namespace sightline::inline formats
