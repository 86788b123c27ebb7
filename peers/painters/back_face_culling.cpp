#include "peers/painters/back_face_culling.h"

namespace sightline::peers {
namespace {

std::vector<Point2> ring_of(const FlatPolygon& polygon) {
  std::vector<Point2> ring;
  for (const Corner& c : polygon.corners) ring.push_back({c.x, c.y});
  return ring;
}

Outcome show_front_faces(const FlatScene& scene, int /*resolution*/) {
  VisibleParts seen;
  for (const FlatPolygon& face : scene.polygons) {
    const bool is_back_face = !face.is_front;
    if (is_back_face) continue;
    seen.push_back({face.face, ring_of(face)});
  }
  const std::uint64_t front_faces = seen.size();
  return {std::move(seen), {{"polygons tested", scene.polygons.size()}, {"front faces", front_faces}}};
}

}  // namespace

Peer back_face_culling() {
  return {
      "back-face-culling",
      "Back-face culling alone",
      "slides 001, 003 and 004; Koucky 3.5",
      ComputedAt::object_precision,
      "It looks at one polygon at a time. If the polygon's normal points away from the eye, it is a back face and is "
      "left out; if not, all of it counts as seen. No polygon is compared with another one, so the cost is one dot "
      "product per polygon.",
      "It does not know that one polygon can hide another. It is right for a single closed convex body, where a front "
      "face has nothing before it. With a second body, or a body with a dent, what is hidden behind a front face is "
      "counted as seen, and the seen areas add up to more than the picture has. An open sheet seen from behind is not "
      "shown at all.",
      show_front_faces};
}

}  // namespace sightline::peers
