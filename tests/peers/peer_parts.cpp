#include "tests/peers/peer_parts.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "peers/scene/convex_ring.h"
#include "tests/tools/analyzed.h"

namespace sightline::tests {

using peers::Count;
using peers::VisiblePart;
using peers::VisibleParts;

PartsCase parts_case(const peers::Peer& peer, const AnyMesh& mesh, const Camera& camera, Sides sides) {
  const View view = analyzed(mesh, camera, sides);
  const peers::Outcome outcome = peer.run(peers::flat_scene(view.scene), 0);
  PartsCase result{std::get<VisibleParts>(outcome.seen), FaceAreas(mesh->face_count()), FaceAreas(mesh->face_count()),
                   outcome.counts};
  for (const VisiblePart& part : result.parts) result.seen[part.face.index()] += peers::signed_area(part.ring);
  for (const VisiblePolygon& polygon : view.polygons.polygons) result.exact[polygon.face.index()] += polygon.area;
  return result;
}

double largest_error(const PartsCase& parts) {
  double largest = 0;
  for (std::size_t f = 0; f < parts.seen.size(); ++f) {
    largest = std::max(largest, std::abs(parts.seen[f] - parts.exact[f]));
  }
  return largest;
}

double overlap_within_faces(const VisibleParts& parts) {
  double total = 0;
  for (std::size_t a = 0; a < parts.size(); ++a) {
    for (std::size_t b = a + 1; b < parts.size(); ++b) {
      if (parts[a].face != parts[b].face) continue;
      total += peers::signed_area(peers::overlap(parts[a].ring, parts[b].ring));
    }
  }
  return total;
}

std::uint64_t number_of(const PartsCase& parts, const std::string& what) {
  const auto found =
      std::find_if(parts.counts.begin(), parts.counts.end(), [&](const Count& c) { return c.what == what; });
  REQUIRE(found != parts.counts.end());
  return found->number;
}

Camera straight_down() {
  ViewPoint view;
  view.eye = {0, 0, 8};
  return orthographic_camera("straight down", view, 2);
}

}  // namespace sightline::tests
