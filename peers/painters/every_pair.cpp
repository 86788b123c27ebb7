#include "peers/painters/every_pair.h"

#include "peers/scene/convex_ring.h"
#include "peers/scene/in_front.h"

namespace sightline::peers {
namespace {

struct Part {
  ConvexRing ring;
  MinMax extent;
};

struct Object {
  const FlatPolygon* polygon = nullptr;
  Part projection;
  std::vector<Part> unobstructed;  // by the objects that it was compared with so far
};

struct Pairs {
  std::uint64_t compared = 0;
  std::uint64_t extents_overlap = 0;
  std::uint64_t projections_overlap = 0;
};

std::vector<Object> objects_of(const FlatScene& scene) {
  std::vector<Object> objects;
  for (const FlatPolygon& polygon : scene.polygons) {
    ConvexRing ring = convex_image(polygon);
    if (ring.empty()) continue;
    const MinMax extent = minmax_of(ring);
    const Part projection{std::move(ring), extent};
    objects.push_back({&polygon, projection, {projection}});
  }
  return objects;
}

// This goes backwards, so that what is put at the end is not looked at again.
void obstruct(Object& behind, const Part& in_front) {
  std::vector<Part>& parts = behind.unobstructed;
  for (std::size_t i = parts.size(); i-- > 0;) {
    if (!extents_overlap(parts[i].extent, in_front.extent)) continue;
    const Part part = std::move(parts[i]);
    parts[i] = std::move(parts.back());
    parts.pop_back();
    for (ConvexRing& ring : remains(part.ring, in_front.ring)) {
      const MinMax extent = minmax_of(ring);
      parts.push_back({std::move(ring), extent});
    }
  }
}

void compare(Object& a, Object& b, const CutMesh& mesh, Pairs& pairs) {
  ++pairs.compared;
  if (!extents_overlap(a.projection.extent, b.projection.extent)) return;
  ++pairs.extents_overlap;
  const ConvexRing common = overlap(a.projection.ring, b.projection.ring);
  if (common.empty()) return;
  ++pairs.projections_overlap;
  if (is_in_front(*a.polygon, *b.polygon, common, mesh)) {
    obstruct(b, a.projection);
  } else {
    obstruct(a, b.projection);
  }
}

Outcome clip_every_pair(const FlatScene& scene, int /*resolution*/) {
  std::vector<Object> world = objects_of(scene);
  Pairs pairs;
  for (std::size_t a = 0; a < world.size(); ++a) {
    for (std::size_t b = a + 1; b < world.size(); ++b) compare(world[a], world[b], *scene.mesh, pairs);
  }
  VisibleParts seen;
  for (Object& object : world) {
    for (Part& part : object.unobstructed) seen.push_back({object.polygon->face, std::move(part.ring)});
  }
  const std::uint64_t parts = seen.size();
  return {std::move(seen),
          {{"pairs compared", pairs.compared},
           {"pairs whose extents overlap", pairs.extents_overlap},
           {"pairs whose projections overlap", pairs.projections_overlap},
           {"unobstructed parts", parts}}};
}

}  // namespace

Peer every_pair() {
  return {
      "every-pair",
      "Generic object-precision algorithm: every polygon against every other",
      "slides 001 and 004",
      ComputedAt::object_precision,
      "It compares each pair of polygons once. A test of their extents throws out most pairs. Where the projections of "
      "two polygons overlap, the depths of their planes say which is in front, and its projection is cut out of what "
      "is "
      "left of the other one, which stays a set of convex parts. What is left when all pairs were compared is seen.",
      "It has no pixels, so its areas are right up to the rounding of the points where it cuts: about one part in "
      "10^15 "
      "for each cut. The price is n (n - 1) / 2 pairs, and parts that are cut smaller by every polygon before them, "
      "even by those that are hidden themselves. Two planes closer to each other than the rounding of their depths may "
      "come out in the wrong order.",
      clip_every_pair};
}

}  // namespace sightline::peers
