#include "formats/writing/segments_table.h"

#include <algorithm>
#include <array>
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

// The line that a segment is on: an edge of the mesh is named by its ends, others have none.
struct SegmentLine {
  const char* kind = "";
  std::array<VertexId, 2> ends;
};

constexpr SegmentLine common_line{"common", {}};
constexpr SegmentLine border_line{"border", {}};

// A piece of an edge of the input is named as that edge is; where a lens is in use, only its frame makes others.
SegmentLine line_of(const CutMesh& mesh, MeshEdgeId edge) {
  if (!edge.valid()) return border_line;
  const auto& ends = mesh.is_cut() ? mesh.cuts.input_edge[edge.index()] : mesh.edges[edge.index()];
  if (!ends[0].valid()) return mesh.cuts.outside_frame.empty() ? common_line : border_line;
  return {"mesh", {std::min(ends[0], ends[1]), std::max(ends[0], ends[1])}};
}

SegmentLine line_of(const ProjectedScene& scene, const VisibleSegment& segment) {
  if (segment.edge.index() >= scene.edge_count()) return common_line;
  return line_of(scene.mesh(), edge_under(scene, segment));
}

}  // namespace

void write_segments_table(const View& view, const std::vector<Point2>& places, TextBuffer& out) {
  const CutMesh& mesh = view.scene.mesh();
  const PlaceTexts texts(places);
  const Camera& camera = view.scene.camera;
  std::optional<PlaceTexts> pixels;
  if (camera.lens_image) pixels.emplace(bent_pixels(camera, places));
  out << "face,start_x,start_y,end_x,end_y,edge,other_face,edge_start,edge_end";
  if (pixels) out << ",start_pixel_x,start_pixel_y,end_pixel_x,end_pixel_y";
  out << '\n';
  for (const VisibleSegment& segment : view.segments.segments) {
    out << face_of(mesh, segment.facet).value << ',' << texts.x(segment.start) << ',' << texts.y(segment.start) << ','
        << texts.x(segment.end) << ',' << texts.y(segment.end) << ',';
    const SegmentLine line = line_of(view.scene, segment);
    out << line.kind << ',';
    if (segment.other.valid()) out << face_of(mesh, segment.other).value;
    for (const VertexId end : line.ends) {
      out << ',';
      if (end.valid()) out << end.value;
    }
    if (pixels) {
      out << ',' << pixels->x(segment.start) << ',' << pixels->y(segment.start) << ',' << pixels->x(segment.end) << ','
          << pixels->y(segment.end);
    }
    out << '\n';
  }
}

}  // namespace sightline::inline formats
