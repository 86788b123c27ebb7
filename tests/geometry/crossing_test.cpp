// sightline is held against the rational oracle on random scenes whose faces pass through each other.
#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "geometry/projection/clipping.h"
#include "oracle/judging/judge.h"
#include "oracle/scenes/crossing_kinds.h"
#include "oracle/scenes/crossing_scenes.h"
#include "oracle/truth/truth.h"
#include "tests/tools/analyzed.h"

namespace sightline::tests::crossing_test {
using namespace oracle;
using namespace lattice;

namespace {

// Where points are off the grid, this is what rounding can change, and whatever that is, no more than 2^-38 of the
// window, whose area is 4.
Rational allowed_difference(const ProjectedScene& scene) {
  return Rational(std::min(rounding_bound(scene), 4 * 0x1p-38));
}

// The area is in window units squared.
Rational in_window_units(const Rational& grid_area, int grid_bits) {
  return grid_area / Rational(BigInteger(1) << static_cast<unsigned>(2 * grid_bits));
}

// Returns whether every point that cutting made falls on the grid exactly, where the camera sees it. One that clipping
// made of a facet that was cut may not.
bool cuts_are_on_grid(const View& view) {
  const CutMesh& mesh = view.scene.mesh();
  for (std::size_t f = 0; mesh.is_cut() && f < mesh.facet_count(); ++f) {
    const UncutFacetId w = mesh.cuts.uncut_facet_of[f];
    const bool was_cut = mesh.end_piece(w).index() - mesh.first_piece(w).index() > 1;
    const auto polygon = view.scene.polygon(FacetId(f));
    if (was_cut && std::ranges::any_of(polygon, [](const ClippedCorner& c) { return !c.vertex.valid(); })) return false;
  }
  for (const ClippedCorner& corner : view.scene.polygon_corners) {
    if (!corner.vertex.valid() || corner.vertex.index() < mesh.input_vertex_count()) continue;
    const ExactCorner exact = exact_corner(mesh, corner.vertex, view.scene.camera);
    for (const BigInteger& coordinate : {exact.x, exact.y}) {
      if ((coordinate << static_cast<unsigned>(view.scene.grid_bits)) % exact.w != 0) return false;
    }
  }
  return true;
}

std::string text(const Rational& value) {
  std::ostringstream out;
  out << value.convert_to<double>();
  return out.str();
}

// The bound is 0 where every point is on the grid.
void compare_areas(Complaints& complaints, const Truth& truth, const std::vector<Rational>& areas,
                   const Rational& bound) {
  Rational uncovered = 4;
  const auto compare = [&](const std::string& what, const Rational& ours, const Rational& theirs) {
    if (abs(Rational(ours - theirs)) <= bound) return;
    complaints.push_back(what + " differs by " + text(ours - theirs) + ", more than " + text(bound));
  };
  for (std::size_t f = 0; f < areas.size(); ++f) {
    compare("visible area of face " + std::to_string(f), areas[f], truth.visible_area[f]);
    uncovered -= areas[f];
  }
  compare("uncovered area", uncovered, truth.uncovered);
}

using Place = std::array<double, 3>;
using PlacePair = std::array<Place, 2>;

Place place(const LabelledMesh& labelled, VertexId v) {
  const Point3& p = labelled.vertices[v.index()];
  return {p.x(), p.y(), p.z()};
}

// Returns the sides of a face's seen triangles that no other seen triangle of the face has, on a line by their ends.
std::set<PlacePair> seen_border(const LabelledMesh& labelled, FaceId face) {
  std::set<PlacePair> border;
  for (const LabelledTriangle& t : labelled.triangles) {
    if (t.face != face || !t.seen) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      PlacePair side{place(labelled, t.corners[i]), place(labelled, t.corners[(i + 1) % 3])};
      if (side[1] < side[0]) std::swap(side[0], side[1]);
      if (!border.insert(side).second) border.erase(side);
    }
  }
  return border;
}

// Returns how many pairs of visible segments of two faces run along one common line, to and fro.
std::size_t common_segments(const View& view) {
  const CutMesh& mesh = view.scene.mesh();
  std::set<std::array<std::uint32_t, 3>> known;
  std::size_t pairs = 0;
  for (const VisibleSegment& s : view.segments.segments) {
    const auto sides = view.scene.sides_of(s.edge);
    const bool common = mesh.is_cut() && std::ranges::all_of(sides, [&](const EdgeSide& side) {
                          return side.mesh_edge.valid() && !mesh.cuts.input_edge[side.mesh_edge.index()][0].valid();
                        });
    if (!common) continue;
    pairs += known.count({s.edge.value, s.end.value, s.start.value});
    known.insert({s.edge.value, s.start.value, s.end.value});
  }
  return pairs;
}

// Where two faces are seen on either side of their common line, they meet there in the same points of space, bit for
// bit. Returns how many such pieces of lines there are.
std::size_t check_meetings(Complaints& complaints, const View& view) {
  const CutMesh& mesh = view.scene.mesh();
  std::vector<std::set<PlacePair>> borders;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) borders.push_back(seen_border(view.labelled, FaceId(f)));
  std::size_t meetings = 0;
  for (std::size_t f = 0; f < borders.size(); ++f) {
    for (std::size_t g = 0; g < f; ++g) {
      for (const PlacePair& side : borders[f]) meetings += borders[g].count(side);
    }
  }
  // What is below resolution is not called seen.
  const bool all_seen = std::ranges::none_of(view.polygons.polygons, &VisiblePolygon::below_resolution);
  if (all_seen && meetings < common_segments(view))
    complaints.emplace_back("two faces that meet along their common line do not meet in the same points");
  return meetings;
}

struct Judgement {
  Complaints complaints;
  bool exact = false;
  std::size_t crossing = 0;
  std::size_t meetings = 0;
  CrossingKinds kinds;
};

Judgement judge_crossing(const RandomScene& scene) {
  Judgement judgement;
  try {
    const Mesh whole = mesh_of(scene);
    const CutMesh mesh = cut(whole);
    const View view = analyzed(mesh, scene.camera, scene.sides);
    judgement.complaints = complaints_of_stages(view);
    judgement.crossing = mesh.cuts.crossing.size();
    judgement.kinds = crossing_kinds(mesh);
    judgement.exact = cuts_are_on_grid(view);
    std::vector<Rational> areas = visible_areas(view);
    for (Rational& area : areas) area = in_window_units(area, view.scene.grid_bits);
    compare_areas(judgement.complaints, true_visibility(whole, scene.camera, scene.sides), areas,
                  judgement.exact ? Rational(0) : allowed_difference(view.scene));
    judgement.meetings = check_meetings(judgement.complaints, view);
  } catch (const std::exception& error) {
    judgement.complaints.push_back(std::string("exception: ") + error.what());
  }
  return judgement;
}

}  // namespace

TEST_CASE("on random scenes that pass through themselves the visible areas are the oracle's") {
  constexpr std::uint64_t first_seed = 1;
  const std::uint64_t scenes = scene_count(5000);
  std::uint64_t seed = first_seed;
  std::uint64_t crossing = 0;
  std::uint64_t several = 0;
  std::uint64_t exact = 0;
  std::uint64_t meetings = 0;
  std::uint64_t perspective = 0;
  std::uint64_t front = 0;
  std::uint64_t clipped = 0;
  std::uint64_t coplanar = 0;
  std::uint64_t three_in_a_point = 0;
  std::uint64_t three_on_a_line = 0;
  std::uint64_t end_on_both_edges = 0;
  std::uint64_t concave = 0;
  int failures = 0;
  for (; crossing < scenes && failures < 3; ++seed) {
    const RandomScene scene = crossing_scene(seed);
    const Judgement judgement = judge_crossing(scene);
    crossing += judgement.crossing > 0 ? 1U : 0U;
    several += judgement.crossing > 2 ? 1U : 0U;
    exact += judgement.crossing > 0 && judgement.exact ? 1U : 0U;
    meetings += judgement.meetings;
    perspective += scene.camera.projection == Projection::perspective ? 1U : 0U;
    front += scene.sides == Sides::front ? 1U : 0U;
    clipped += scene.notes.clipped ? 1U : 0U;
    coplanar += scene.notes.coplanar_overlap ? 1U : 0U;
    three_in_a_point += judgement.kinds.three_in_a_point ? 1U : 0U;
    three_on_a_line += judgement.kinds.three_on_a_line ? 1U : 0U;
    end_on_both_edges += judgement.kinds.end_on_both_edges ? 1U : 0U;
    concave += judgement.kinds.concave ? 1U : 0U;
    if (judgement.complaints.empty()) continue;
    ++failures;
    const RandomScene small =
        reduced(scene, [](const RandomScene& s) { return !judge_crossing(s).complaints.empty(); });
    FAIL_CHECK(joined(judge_crossing(small).complaints), to_text(small));
  }
  REQUIRE(failures == 0);
  MESSAGE((seed - first_seed) << " scenes, " << crossing << " with faces that pass through each other, " << several
                              << " with more than two such pairs; in " << exact
                              << " of them every point is on the grid; " << meetings
                              << " lines on which two faces meet; three facets through one point in "
                              << three_in_a_point << ", on one line in " << three_on_a_line
                              << ", lines that end on edges of both in " << end_on_both_edges << ", concave faces in "
                              << concave);
  // The generator made the hard cases.
  CHECK(several * 4 >= scenes);
  CHECK(exact * 20 >= scenes);
  CHECK(meetings >= scenes / 2);
  CHECK(perspective * 4 >= scenes);
  CHECK((scenes - perspective) * 4 >= scenes);
  CHECK(front * 10 >= scenes);
  CHECK(clipped * 20 >= scenes);
  CHECK(coplanar * 20 >= scenes);
  CHECK(three_in_a_point * 2 >= scenes);
  CHECK(three_on_a_line * 5 >= scenes);
  CHECK(end_on_both_edges * 2 >= scenes);
  CHECK(concave * 10 >= scenes);
}

}  // namespace sightline::tests::crossing_test
