// The checkers of the stages are silent on right values, and for each message there is a value with one thing broken.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "geometry/mesh/facet_plane.h"
#include "geometry/projection/camera.h"
#include "reconstruct/labelling/labelled_mesh.h"
#include "reconstruct/polygons/ring_measure.h"
#include "reconstruct/polygons/surface_layout.h"
#include "reconstruct/polygons/visible_polygons.h"
#include "sweep/plain/sweep.h"
#include "tests/tools/analyzed.h"

namespace sightline::tests::validate_test {
namespace {

using Messages = std::vector<std::string>;
using Corners = std::vector<std::size_t>;

Mesh mesh_of(std::vector<Point3> vertices, const std::vector<Corners>& faces) {
  PolygonList list;
  for (const Corners& face : faces) {
    std::vector<VertexId> ids;
    for (const std::size_t v : face) ids.emplace_back(v);
    list.push_back(ids);
  }
  return build_mesh(std::move(vertices), std::move(list));
}

// The stages have everything up to the polygons, looked at along -z; the window is the square from (0, 0) to (16, 16).
struct Stages {
  Mesh mesh;
  ProjectedScene scene;
  VisibleSegments segments;
  VisiblePolygons polygons;
};

Stages stages_of(Mesh mesh) {
  const ViewPoint above{{8, 8, 10}, {8, 8, 0}, {0, 1, 0}, 1, {}, {}};
  const Camera page = orthographic_camera("page", above, 16);
  Stages stages{std::move(mesh), {}, {}, {}};
  stages.scene = project(stages.mesh, page, Sides::both);
  stages.segments = plain_sweep(stages.scene);
  stages.polygons = reconstruct_polygons(stages.scene, stages.segments);
  return stages;
}

// In Fang 1993, 5.3, face 0 is the pentagon ABCDE, face 1 the triangle OPQ behind it.
Stages fang() {
  return stages_of(mesh_of({{2, 9, 1}, {4, 2, 1}, {8, 5, 1}, {7, 8, 1}, {4, 11, 1}, {6, 12, 0}, {2, 4, 0}, {14, 0, 0}},
                           {{0, 1, 2, 3, 4}, {5, 6, 7}}));
}

// Face 0, a wall, is cut in two by face 1, a bar before it; face 2 makes a hole in the right part.
Stages wall() {
  return stages_of(mesh_of({{1, 1, 0},
                            {15, 1, 0},
                            {15, 15, 0},
                            {1, 15, 0},
                            {6, .5, 1},
                            {8, .5, 1},
                            {8, 15.5, 1},
                            {6, 15.5, 1},
                            {10, 6, 1},
                            {12, 6, 1},
                            {12, 10, 1},
                            {10, 10, 1}},
                           {{0, 1, 2, 3}, {4, 5, 6, 7}, {8, 9, 10, 11}}));
}
constexpr std::size_t wall_left = 0;
constexpr std::size_t wall_right = 1;
constexpr std::size_t patch_polygon = 3;

void check_reported(const Messages& messages, const std::string& part) {
  INFO("expected: " << part << ", got " << messages.size() << ": " << (messages.empty() ? "" : messages.front()));
  CHECK(std::ranges::any_of(messages, [&](const std::string& m) { return m.find(part) != std::string::npos; }));
}

template <class Value>
struct Breakage {
  std::string part;  // of a message
  std::function<void(Value&)> break_it;
};

// Returns the first segment that has the facet to its left and holds the condition.
template <class Condition>
VisibleSegment& find_segment(Stages& stages, FacetId facet, Condition condition) {
  const auto found = std::ranges::find_if(stages.segments.segments,
                                          [&](const VisibleSegment& s) { return s.facet == facet && condition(s); });
  REQUIRE(found != stages.segments.segments.end());
  return *found;
}

TEST_CASE("the checkers are silent on right values") {
  for (const Stages& stages : {fang(), wall()}) {
    CHECK(validate(stages.mesh) == Messages{});
    CHECK(validate(stages.scene) == Messages{});
    CHECK(validate(stages.segments, stages.scene) == Messages{});
    CHECK(validate(stages.polygons, stages.scene, stages.segments) == Messages{});
  }
  CHECK(fang().segments.segments.size() == 14);
  const Stages walls = wall();
  REQUIRE(walls.polygons.polygons.size() == 4);
  CHECK(walls.polygons.polygons[wall_right].ring_count == 2);
  CHECK(walls.segments.threads.size() == 1);
}

const std::vector<Breakage<ProjectedScene>> broken_scenes{
    {"grid_bits", [](ProjectedScene& s) { s.grid_bits = default_grid_bits + 1; }},
    {"facing: not one entry", [](ProjectedScene& s) { s.facing.pop_back(); }},
    {"facing: no such value", [](ProjectedScene& s) { s.facing[0] = static_cast<FacetFacing>(9); }},
    {"status: no such value", [](ProjectedScene& s) { s.status[0] = static_cast<FacetStatus>(9); }},
    {"polygon_begin: not the ranges", [](ProjectedScene& s) { ++s.polygon_begin.back(); }},
    {"edges: not the ranges", [](ProjectedScene& s) { s.edges.clear(); }},
    {"edges: an end is no point", [](ProjectedScene& s) { s.edges[0].bottom = PointId(99); }},
    {"sides: no such facet", [](ProjectedScene& s) { s.sides[0].facet = FacetId(99); }},
    {"polygon_corners: no such point", [](ProjectedScene& s) { s.polygon_corners[0].point = PointId(99); }},
    {"polygon_corners: neither a vertex nor made", [](ProjectedScene& s) { s.polygon_corners[0].vertex = {}; }},
    {"made by clipping, or both", [](ProjectedScene& s) { s.polygon_corners[0].made = MadeCornerId(0); }},
    {"point 0 is outside the window", [](ProjectedScene& s) { s.points[0].y = (std::int64_t{1} << 40) + 1; }},
    {"point 1 does not follow", [](ProjectedScene& s) { s.points[1] = s.points[0]; }},
    {"edge 0 has its top not before", [](ProjectedScene& s) { std::swap(s.edges[0].top, s.edges[0].bottom); }},
    {"edge 1 is repeated",
     [](ProjectedScene& s) {
       s.edges[1].top = s.edges[0].top;
       s.edges[1].bottom = s.edges[0].bottom;
     }},
    {"edge 0 belongs to no facet", [](ProjectedScene& s) { s.edges[1].first_side = 0; }},
    {"edge 0 changes nothing for facet", [](ProjectedScene& s) { s.sides[0].winding = 0; }},
    {"of facet 0, which is not in view", [](ProjectedScene& s) { s.status[0] = FacetStatus::out_of_view; }},
    {"facet 0 is not in view and has a polygon", [](ProjectedScene& s) { s.status[0] = FacetStatus::out_of_view; }},
    {"facet 0 is in view and has no polygon", [](ProjectedScene& s) { s.polygon_begin[1] = 0; }},
    {"facet 0 has a status that does not fit", [](ProjectedScene& s) { s.facing[0] = FacetFacing::edge_on; }},
    {"facet 0 has a status that does not fit", [](ProjectedScene& s) { s.status[0] = FacetStatus::culled; }},
    {"has a boundary that is not closed at point", [](ProjectedScene& s) { s.sides[0].winding *= -1; }},
    {"has other sides than its polygon", [](ProjectedScene& s) { s.sides[0].mesh_edge = MeshEdgeId(99); }},
};

TEST_CASE("validate reports what is broken in a projected scene") {
  for (const auto& [part, break_it] : broken_scenes) {
    ProjectedScene scene = fang().scene;
    break_it(scene);
    check_reported(validate(scene), part);
  }
}

constexpr FacetId pentagon(0);
constexpr FacetId triangle(1);
const auto any_segment = [](const VisibleSegment&) { return true; };

const std::vector<Breakage<Stages>> broken_segments{
    {"crossing 0 names", [](Stages& s) { s.segments.crossings[0].a = EdgeId(99); }},
    {"segment 0 names", [](Stages& s) { s.segments.segments[0].edge = EdgeId(99); }},
    {"thread 0 names",
     [](Stages& s) {
       s.segments.threads.push_back({PointId(0), pentagon, SegmentId(99)});
     }},
    {"split 0 names", [](Stages& s) { s.segments.splits[0].point = PointId(99); }},
    {"which do not cross inside both", [](Stages& s) { s.segments.crossings[0].b = s.segments.crossings[0].a; }},
    {"crossing 0 is not where it should be", [](Stages& s) { s.segments.crossings[0].after = PointId(0); }},
    {"crossing 1 does not follow", [](Stages& s) { std::swap(s.segments.crossings[0], s.segments.crossings[1]); }},
    {"segment 0 starts where it ends", [](Stages& s) { s.segments.segments[0].end = s.segments.segments[0].start; }},
    {"is not on edge", [](Stages& s) { s.segments.segments[0].edge = s.segments.segments.back().edge; }},
    {"has facet 0 on both sides", [](Stages& s) { find_segment(s, pentagon, any_segment).other = pentagon; }},
    {"facet 0 is not to its left",
     [](Stages& s) {
       VisibleSegment& broken = find_segment(s, pentagon, any_segment);
       std::swap(broken.start, broken.end);
     }},
    {"facet 1 is not to its right",
     [](Stages& s) { find_segment(s, pentagon, [](const auto& t) { return !t.other.valid(); }).other = triangle; }},
    {"no split of edge", [](Stages& s) { s.segments.splits.clear(); }},
    {"segment 1 should come before segment 0",
     [](Stages& s) { std::swap(s.segments.segments[0], s.segments.segments[1]); }},
    {"segment 9 should come before segment 8",
     [](Stages& s) { std::swap(s.segments.segments[8], s.segments.segments[9]); }},
    {"as many segments do not start as end at point", [](Stages& s) { s.segments.segments.pop_back(); }},
    {"overlap", [](Stages& s) { s.segments.segments.push_back(s.segments.segments.front()); }},
    {"split 1 is repeated", [](Stages& s) { s.segments.splits[1] = s.segments.splits[0]; }},
    {"is not inside edge",
     [](Stages& s) { s.segments.splits[0].point = s.scene.edge(s.segments.splits[0].edge).bottom; }},
    {"has no such side of facet 0", [](Stages& s) { s.segments.splits[0].facet = pentagon; }},
};

TEST_CASE("validate reports what is broken in visible segments") {
  for (const auto& [part, break_it] : broken_segments) {
    Stages stages = fang();
    break_it(stages);
    check_reported(validate(stages.segments, stages.scene), part);
  }
}

TEST_CASE("validate reports a thread that leads nowhere") {
  Stages stages = wall();
  const Thread thread = stages.segments.threads.front();
  stages.segments.threads.push_back(thread);
  check_reported(validate(stages.segments, stages.scene), "thread 1 does not follow");
  const auto lead_to = [&](SegmentId s) {
    stages.segments.threads = {{thread.top, thread.facet, s}};
    return validate(stages.segments, stages.scene);
  };
  int refused = 0;
  for (std::size_t s = 0; s < stages.segments.segments.size(); ++s) {
    // Only the bar's two sides and the wall's left side are left of the patch with a face to their right.
    const Messages messages = lead_to(SegmentId(s));
    if (messages.empty()) continue;
    ++refused;
    check_reported(messages,
                   "thread 0 leads to segment " + std::to_string(s) + ", which does not bound a face left of it");
  }
  CHECK(static_cast<std::size_t>(refused) == stages.segments.segments.size() - 3);
}

// Returns the same rings in another order, dealt out to the polygons by their ring_count.
VisiblePolygons arranged(const VisiblePolygons& polygons, const std::vector<std::size_t>& rings,
                         std::vector<VisiblePolygon> dealt) {
  VisiblePolygons result;
  for (const std::size_t r : rings) {
    const auto ring = polygons.ring(r);
    result.ring_segments.insert(result.ring_segments.end(), ring.begin(), ring.end());
    result.ring_begin.push_back(static_cast<std::uint32_t>(result.ring_segments.size()));
  }
  std::uint32_t first_ring = 0;
  for (VisiblePolygon& polygon : dealt) {
    polygon.first_ring = first_ring;
    first_ring += polygon.ring_count;
  }
  result.polygons = std::move(dealt);
  return result;
}

// In wall(), ring 0 is the left part's, 1 and 2 are the right part's and its hole, 3 the bar's, 4 the patch's.
void exchange_hole(Stages& s) { s.polygons = arranged(s.polygons, {0, 2, 1, 3, 4}, s.polygons.polygons); }

void give_hole_to_left_part(Stages& s) {
  auto dealt = s.polygons.polygons;
  dealt[wall_left].ring_count = 2;
  dealt[wall_right].ring_count = 1;
  s.polygons = arranged(s.polygons, {0, 2, 1, 3, 4}, dealt);
}

void exchange_parts(Stages& s) {
  auto dealt = s.polygons.polygons;
  std::swap(dealt[wall_left], dealt[wall_right]);
  s.polygons = arranged(s.polygons, {1, 2, 0, 3, 4}, dealt);
}

void exchange_faces(Stages& s) {
  auto dealt = s.polygons.polygons;
  std::swap(dealt[2], dealt[3]);
  s.polygons = arranged(s.polygons, {0, 1, 2, 4, 3}, dealt);
}

// The error is between the bound of one evaluation in double and that of two.
void misstate_area(Stages& s) {
  RingMeasure measured;
  const ImagePoints points(s.scene, s.segments);
  for (const std::size_t r : {std::size_t{1}, std::size_t{2}})
    measured += measure(points, s.segments, s.polygons.ring(r));
  s.polygons.polygons[wall_right].area += 0.75 * measured.twice_area.radius;
}

// The patch becomes a part of the wall: its ring runs along the hole's.
void join_patch_and_wall(Stages& s) {
  s.mesh.facet_face[2] = FaceId(0);
  s.scene.surface = std::make_shared<const CutMesh>(uncrossed(s.mesh));
  s.polygons.polygons[patch_polygon].face = FaceId(0);
}

const std::vector<Breakage<Stages>> broken_polygons{
    {"ring_begin: not the ranges", [](Stages& s) { s.polygons.ring_begin.back() -= 1; }},
    {"ring_segments: no such segment", [](Stages& s) { s.polygons.ring_segments[0] = SegmentId(99); }},
    {"polygons: no such facet", [](Stages& s) { s.polygons.polygons[0].facet = FacetId(99); }},
    {"polygons: not the ranges of the rings", [](Stages& s) { s.polygons.polygons[1].first_ring += 1; }},
    {"is in 0 rings", [](Stages& s) { s.polygons.ring_segments[0] = s.polygons.ring_segments[1]; }},
    {"is in 2 rings", [](Stages& s) { s.polygons.ring_segments[0] = s.polygons.ring_segments[1]; }},
    {"ring 0 visits point", [](Stages& s) { s.polygons.ring_segments[0] = s.polygons.ring_segments[1]; }},
    {"ring 0 is interrupted after segment",
     [](Stages& s) { std::swap(s.polygons.ring_segments[1], s.polygons.ring_segments[2]); }},
    {"ring 0 does not start at its first point",
     [](Stages& s) {
       const auto begin = s.polygons.ring_segments.begin();
       std::rotate(begin, begin + 1, begin + s.polygons.ring_begin[1]);
     }},
    {"polygon 0 is not of the face of its facet", [](Stages& s) { s.polygons.polygons[0].face = FaceId(1); }},
    {"of another surface", [](Stages& s) { std::swap(s.polygons.polygons[2].facet, s.polygons.polygons[3].facet); }},
    {"thread 0 leads to segment", [](Stages& s) { s.segments.threads[0].facet = FacetId(1); }},
    {"polygon 1 should come before", exchange_parts},
    {"polygon 3 should come before", exchange_faces},
    {"ring 1 of polygon 1 is not counter-clockwise", exchange_hole},
    {"ring 2 of polygon 1 is a hole and not clockwise", exchange_hole},
    {"ring 1 is a hole outside the outer ring of polygon 0", give_hole_to_left_part},
    {"polygon 1 has another exact area than", misstate_area},
    {"meet outside their end points", join_patch_and_wall},
    {"polygon 1 has another area than", [](Stages& s) { s.polygons.polygons[1].area *= 1 + 0x1p-30; }},
    {"polygon 1 has another perimeter than", [](Stages& s) { s.polygons.polygons[1].perimeter *= 1 + 0x1p-30; }},
    {"polygon 1 is not below resolution", [](Stages& s) { s.polygons.polygons[1].below_resolution = true; }},
    {"polygon 1 is below resolution", [](Stages& s) { s.polygons.polygons[1].area = 0; }},
};

TEST_CASE("validate reports what is broken in visible polygons") {
  for (const auto& [part, break_it] : broken_polygons) {
    Stages stages = wall();
    break_it(stages);
    check_reported(validate(stages.polygons, stages.scene, stages.segments), part);
  }
}

// Three points are on a line, and a ring goes from the first to the last and back by the middle one.
TEST_CASE("validate finds a ring without area by exact arithmetic, and where it folds back") {
  Stages stages = fang();
  stages.scene.points = {{0, 6}, {1, 4}, {3, 0}};
  stages.scene.edges = {{PointId(0), PointId(1)}, {PointId(0), PointId(2)}, {PointId(1), PointId(2)}, {}};
  stages.segments = {};
  stages.segments.segments = {{PointId(0), PointId(2), pentagon, {}, EdgeId(1)},
                              {PointId(2), PointId(1), pentagon, {}, EdgeId(2)},
                              {PointId(1), PointId(0), pentagon, {}, EdgeId(0)}};
  stages.polygons = {};
  stages.polygons.polygons = {{.face = FaceId(0), .facet = pentagon, .ring_count = 1}};
  stages.polygons.ring_begin = {0, 3};
  stages.polygons.ring_segments = {SegmentId(0), SegmentId(1), SegmentId(2)};
  const Messages messages = validate(stages.polygons, stages.scene, stages.segments);
  check_reported(messages, "ring 0 of polygon 0 is not counter-clockwise");
  check_reported(messages, "ring 0 folds back from segment 0 to segment 1");
  check_reported(messages, "ring 0 folds back from segment 2 to segment 0");
  CHECK(std::ranges::none_of(messages,
                             [](const std::string& m) { return m.find("from segment 1") != std::string::npos; }));
}

TEST_CASE("what covers something twice is found by its winding numbers") {
  const Stages stages = wall();
  const EdgeSides sides(stages.scene, stages.segments);
  const auto messages_for = [&](const std::vector<std::size_t>& rings) {
    std::vector<SegmentId> ids;
    for (const std::size_t r : rings)
      ids.insert(ids.end(), stages.polygons.ring(r).begin(), stages.polygons.ring(r).end());
    Messages messages;
    check_surface_layout(sides, stages.segments, ids, messages);
    return messages;
  };
  // The right part of the wall has its hole; the bar and the patch are side by side.
  CHECK(messages_for({1, 2}) == Messages{});
  CHECK(messages_for({3, 4}) == Messages{});
  // Without the hole the patch lies on the wall; the hole alone is all but visible.
  const SegmentId of_patch = stages.polygons.ring(4).front();
  CHECK(messages_for({1, 4}).size() == 4);
  check_reported(messages_for({1, 4}), "segment " + std::to_string(of_patch.value) +
                                           ": what is visible has the winding number 2 to its left");
  const SegmentId of_hole = stages.polygons.ring(2).front();
  CHECK(messages_for({2}).size() == 4);
  check_reported(messages_for({2}),
                 "segment " + std::to_string(of_hole.value) + ": what is visible has the winding number 0 to its left");
}

// A mesh is refined by hand: points on mesh edges are given by the positions of the edge's ends.
struct Split {
  VertexId a;
  VertexId b;
  Point3 position = Point3::Zero();
};

// The triangles of a facet with further points on its border are a fan around the first of these.
void add_facet(LabelledMesh& labelled, const CutMesh& mesh, FacetId facet, const std::vector<Split>& splits) {
  const auto corners = mesh.corners(facet);
  std::vector<VertexId> border;
  std::size_t centre = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const VertexId a = mesh.weld[corners[i].index()];
    const VertexId b = mesh.weld[corners[(i + 1) % corners.size()].index()];
    border.push_back(corners[i]);
    for (std::size_t s = 0; s < splits.size(); ++s) {
      if (!(splits[s].a == a && splits[s].b == b) && !(splits[s].a == b && splits[s].b == a)) continue;
      centre = border.size();
      border.push_back(VertexId(mesh.vertices.size() + s));
    }
  }
  std::rotate(border.begin(), border.begin() + static_cast<std::ptrdiff_t>(centre), border.end());
  for (std::size_t i = 1; i + 1 < border.size(); ++i) {
    labelled.triangles.push_back({{border[0], border[i], border[i + 1]},
                                  mesh.facet_face[facet.index()],
                                  surface_of(mesh, facet),
                                  Label::visible,
                                  true});
  }
}

LabelledMesh refined(const CutMesh& mesh, const std::vector<Split>& splits) {
  LabelledMesh labelled;
  labelled.vertices = mesh.vertices;
  for (const Split& split : splits) labelled.vertices.push_back(split.position);
  for (std::size_t f = 0; f < mesh.facet_count(); ++f) add_facet(labelled, mesh, FacetId(f), splits);
  return labelled;
}

// There is a tetrahedron, and a face that is none.
CutMesh tetrahedron() {
  return uncrossed(
      mesh_of({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 1, 1}}));
}
const std::vector<Split> tetrahedron_splits{{VertexId(0), VertexId(1), {1, 0, 0}},
                                            {VertexId(1), VertexId(2), {2, 2, 0}}};

// The mesh is seen from a side that shows no triangle edge-on.
Messages validated(const LabelledMesh& labelled, const AnyMesh& mesh) {
  const Camera camera = orthographic_camera("any", {{3, 5, 9}, {0, 0, 0}, {0, 1, 0}, 1, {}, {}}, 30);
  return validate(labelled, project(mesh, camera, Sides::both));
}

TEST_CASE("the checker of labelled meshes is silent on right values") {
  const CutMesh closed = tetrahedron();
  CHECK(validated(refined(closed, {}), closed) == Messages{});
  CHECK(validated(refined(closed, tetrahedron_splits), closed) == Messages{});
  // Three faces are on one edge, in no common orientation; the ends of the third are vertices of its own.
  const AnyMesh fan = mesh_of({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {0, -4, 1}, {0, 0, 0}, {4, 0, 0}},
                              {{0, 1, 2}, {0, 1, 3}, {5, 6, 4}});
  CHECK(validated(refined(fan, {{VertexId(0), VertexId(1), {1, 0, 0}}}), fan) == Messages{});
  // A face of two facets that is not planar is split on the edge between them.
  const AnyMesh warped = mesh_of({{0, 0, 0}, {4, 0, 0}, {4, 4, 2}, {0, 4, 0}}, {{0, 1, 2, 3}});
  REQUIRE(warped->facet_count() == 2);
  const auto inner =
      std::ranges::find_if(warped->edges, [&](const auto& ends) { return ends[1].value - ends[0].value == 2; });
  REQUIRE(inner != warped->edges.end());
  const Point3 middle = 0.5 * (warped->position((*inner)[0]) + warped->position((*inner)[1]));
  CHECK(validated(refined(warped, {{(*inner)[0], (*inner)[1], middle}}), warped) == Messages{});
  // The squares of the coordinates are beyond the range of double.
  for (const double scale : {0x1p-1000, 0x1p+1000}) {
    std::vector<Split> splits = tetrahedron_splits;
    for (Split& split : splits) split.position = scale * split.position;
    std::vector<Point3> vertices = closed.vertices;
    for (Point3& p : vertices) p = scale * p;
    const AnyMesh scaled = build_mesh(vertices, closed.faces);
    CHECK(validated(refined(scaled, splits), scaled) == Messages{});
  }
}

TEST_CASE("borders that touch themselves conform") {
  // Two triangles of one face share a corner: two ways lead on from there.
  const AnyMesh bow = mesh_of({{0, 0, 0}, {4, 0, 0}, {2, 2, 0}, {4, 4, 0}, {0, 4, 0}}, {{0, 1, 2, 3, 4, 2}});
  REQUIRE(bow->facet_count() == 2);
  CHECK(validated(refined(bow, {{VertexId(2), VertexId(3), {3, 3, 0}}, {VertexId(1), VertexId(2), {3, 1, 0}}}), bow) ==
        Messages{});
  // A frame goes around a hole, with a slit from 0 to 6 that has one more corner, 8, on the way back.
  const AnyMesh frame =
      mesh_of({{0, 0, 0}, {6, 0, 0}, {6, 6, 0}, {0, 6, 0}, {4, 2, 0}, {4, 4, 0}, {2, 2, 0}, {2, 4, 0}, {1, 1, 0}},
              {{0, 1, 2, 3, 0, 6, 7, 5, 4, 6, 8}});
  REQUIRE(frame->facet_count() > 1);
  CHECK(std::ranges::count(frame->edges, std::array{VertexId(0), VertexId(6)}) == 0);
  CHECK(std::ranges::count(frame->edges, std::array{VertexId(0), VertexId(8)}) == 1);
  CHECK(validated(refined(frame, {}), frame) == Messages{});
  CHECK(validated(refined(frame, {{VertexId(0), VertexId(8), {0.5, 0.5, 0}}}), frame) == Messages{});
}

TEST_CASE("a border as short as doubles go conforms") {
  // From 3 to 2 it is the shortest way there is beside ways of a length of 1, of which two lead on from 3.
  const double shortest = std::numeric_limits<double>::denorm_min();
  const AnyMesh face = mesh_of({{-3, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 0, shortest}, {0, -1, 0}}, {{3, 0, 4, 3, 2, 1}});
  REQUIRE(std::ranges::count(face->edges, std::array{VertexId(2), VertexId(3)}) == 1);
  CHECK(validated(refined(face, {}), face) == Messages{});
}

const std::vector<Breakage<LabelledMesh>> broken_labelled{
    {"vertices: fewer than the input's", [](LabelledMesh& m) { m.vertices.resize(3); }},
    {"vertex 0 is not where the input has it", [](LabelledMesh& m) { m.vertices[0].x() = -0.0; }},
    {"vertex 4 is not finite", [](LabelledMesh& m) { m.vertices[4].y() = std::numeric_limits<double>::infinity(); }},
    {"triangle 0 has a corner that is no vertex", [](LabelledMesh& m) { m.triangles[0].corners[1] = VertexId(99); }},
    {"triangle 0 has a corner twice", [](LabelledMesh& m) { m.triangles[0].corners[1] = m.triangles[0].corners[2]; }},
    {"triangle 0 has no such label", [](LabelledMesh& m) { m.triangles[0].label = static_cast<Label>(4); }},
    {"triangle 0 is seen or not, against its label", [](LabelledMesh& m) { m.triangles[0].seen = false; }},
    {"triangle 1 is seen or not, against its label", [](LabelledMesh& m) { m.triangles[1].label = Label::hidden; }},
    {"is not listed with its face", [](LabelledMesh& m) { std::swap(m.triangles.front(), m.triangles.back()); }},
    {"triangle 0 is of no face", [](LabelledMesh& m) { m.triangles[0].face = FaceId(99); }},
    {"is of face 4, which is skipped", [](LabelledMesh& m) { m.triangles.back().face = FaceId(4); }},
    {"triangle 0 is on no surface of its face", [](LabelledMesh& m) { m.triangles[0].surface = FacetId{}; }},
    {"triangle 0 is on no surface of its face", [](LabelledMesh& m) { m.triangles[0].surface = FacetId(2); }},
    {"face 0 has triangles of another area", [](LabelledMesh& m) { m.triangles.erase(m.triangles.begin()); }},
    {"face 0 has triangles of another area", [](LabelledMesh& m) { m.vertices[5].z() = -0.001; }},
    {"triangle 0 is turned over against face 0",
     [](LabelledMesh& m) { std::swap(m.triangles[0].corners[0], m.triangles[0].corners[1]); }},
    {"does not conform with its neighbours between vertices",
     [](LabelledMesh& m) { std::swap(m.triangles[0].corners[0], m.triangles[0].corners[1]); }},
};

TEST_CASE("validate reports what is broken in a labelled mesh") {
  const CutMesh mesh = tetrahedron();
  for (const auto& [part, break_it] : broken_labelled) {
    LabelledMesh labelled = refined(mesh, tetrahedron_splits);
    break_it(labelled);
    check_reported(validated(labelled, mesh), part);
  }
}

TEST_CASE("validate reports a surface that is not the one of the plane, and one out of its place") {
  const AnyMesh warped = mesh_of({{0, 0, 0}, {4, 0, 0}, {4, 4, 2}, {0, 4, 0}}, {{0, 1, 2, 3}});
  LabelledMesh swapped = refined(warped, {});
  std::swap(swapped.triangles[0], swapped.triangles[1]);
  CHECK(validated(swapped, warped) == Messages{"triangle 1 is not listed with its surface"});
  const AnyMesh bow = mesh_of({{0, 0, 0}, {4, 0, 0}, {2, 2, 0}, {4, 4, 0}, {0, 4, 0}}, {{0, 1, 2, 3, 4, 2}});
  LabelledMesh by_facet = refined(bow, {});
  by_facet.triangles[1].surface = FacetId(1);
  CHECK(validated(by_facet, bow) == Messages{"triangle 1 is on no surface of its face"});
}

TEST_CASE("validate reports an edge that is split for one of its faces only") {
  const CutMesh mesh = tetrahedron();
  for (std::size_t whole = 0; whole < mesh.facet_count(); ++whole) {
    LabelledMesh labelled;
    labelled.vertices = refined(mesh, tetrahedron_splits).vertices;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
      add_facet(labelled, mesh, FacetId(f), f == whole ? std::vector<Split>{} : tetrahedron_splits);
    const Messages messages = validated(labelled, mesh);
    INFO("whole: " << whole);
    const bool has_split_edge = whole != 3;
    CHECK(messages.empty() != has_split_edge);
    for (const std::string& m : messages) CHECK(m.find("does not conform with its neighbours") != std::string::npos);
  }
}

TEST_CASE("validate reports a border that is missing") {
  const AnyMesh mesh = mesh_of({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 1, 2}});
  LabelledMesh labelled = refined(mesh, {});
  labelled.triangles.clear();
  const Messages messages = validated(labelled, mesh);
  check_reported(messages, "face 0 has triangles of another area");
  check_reported(messages, "face 0 has no border along mesh edge 0");
}

}  // namespace

}  // namespace sightline::tests::validate_test
