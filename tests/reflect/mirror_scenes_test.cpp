// Reflections are tested by validators and laws, in random scenes on a grid so small that everything touches.
#include <doctest/doctest.h>

#include <random>

#include "oracle/judging/judge.h"
#include "tests/tools/analyzed.h"

namespace sightline::tests::mirror_scenes_test {
using namespace lattice;

namespace {

class SmallGrid {
 public:
  explicit SmallGrid(std::uint64_t seed) : random_(seed) {}

  double number(int low, int high) { return low + below(high - low + 1); }
  int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
  Point3 place(int top) { return {number(-2, 2), number(-2, 2), number(-1, top)}; }
  Vector3 side() { return {number(-2, 2), number(-2, 2), number(-1, 1)}; }

 private:
  std::mt19937_64 random_;
};

CutMesh random_surface(SmallGrid& grid) {
  std::vector<Point3> vertices;
  PolygonList faces;
  for (int i = 2 + grid.below(7); i > 0; --i) {
    const Point3 corner = grid.place(2);
    const Vector3 u = grid.side();
    const Vector3 v = grid.side();
    std::vector<Point3> places{corner, corner + u, corner + u + v, corner + v};
    if (grid.below(2) == 0) places.erase(places.begin() + 2);
    std::vector<VertexId> corners;
    for (const Point3& p : places) {
      corners.emplace_back(vertices.size());
      vertices.push_back(p);
    }
    faces.push_back(corners);
  }
  return cut(build_mesh(std::move(vertices), std::move(faces)));
}

std::vector<Panel> random_panels(SmallGrid& grid) {
  std::vector<Panel> panels;
  for (int i = 1 + grid.below(3); i > 0;) {
    const Point3 corner = grid.place(3);
    const Vector3 u = grid.side();
    const Vector3 v = grid.side();
    if (norm(u.cross(v)) == 0) continue;
    const Emits emits = grid.below(2) == 0 ? Emits::front : Emits::both;
    panels.push_back({"panel", {corner, corner + u, corner + u + v, corner + v}, emits});
    --i;
  }
  return panels;
}

Camera random_camera(SmallGrid& grid) {
  const Point3 eye{grid.number(-3, 3), grid.number(-3, 3), grid.number(3, 6)};
  const ViewPoint view{eye, {grid.number(-1, 1), grid.number(-1, 1), 0}, {0.1, 1, 0.05}, 1, {}, {}};
  return grid.below(4) == 0 ? orthographic_camera("small", view, 6) : perspective_camera("small", view, 60);
}

bool any_above_resolution(const VisiblePolygons& polygons) {
  return std::ranges::any_of(polygons.polygons, [](const VisiblePolygon& p) { return !p.below_resolution; });
}

Rational image_area(const View& view, std::size_t panel) {
  const PanelReflection& reflection = view.reflections.panels[panel];
  Rational sum = 0;
  for (std::size_t p = 0; p < reflection.polygons.polygons.size(); ++p)
    sum += exact_area(view.scene, reflection.segments, reflection.polygons, p);
  return sum;
}

Complaints complaints_of_reflections(const View& view) {
  Complaints complaints = complaints_of_stages(view);
  for (std::size_t p = 0; p < view.reflections.panels.size(); ++p) {
    const PanelReflection& panel = view.reflections.panels[p];
    for (const std::string& line : validate(panel.polygons, view.scene, panel.segments))
      complaints.push_back("panel " + std::to_string(p) + ": " + line);
    const auto reflects = [p](const LabelledTriangle& t) { return (t.reflecting >> p & 1U) != 0; };
    const auto& triangles = view.labelled.triangles;
    if (std::ranges::any_of(triangles, reflects) != any_above_resolution(panel.polygons))
      complaints.push_back("panel " + std::to_string(p) +
                           ": polygons without triangles, or triangles without polygons");
    if (std::ranges::any_of(triangles, [&](const LabelledTriangle& t) { return reflects(t) && !t.seen; }))
      complaints.push_back("panel " + std::to_string(p) + ": reflects where it is not seen");
  }
  return complaints;
}

// Corners of faces are on the grid here, but for those that clipping and cutting made: so areas differ by less than what a
// few of these move by half a spacing.
void check_without_rounding(const MirrorWorld& world, const Camera& camera, const View& on_grid) {
  const View view = analyzed(world, camera, {Arithmetic::unrounded});
  CHECK(joined(complaints_of_reflections(view)) == "");
  for (std::size_t p = 0; p < world.panels.size(); ++p) {
    const double moved = std::ldexp(Rational(image_area(view, p) - image_area(on_grid, p)).convert_to<double>(), -80);
    CHECK(std::fabs(moved) < 1e-10);
  }
}

struct Counts {
  std::uint64_t reflecting = 0;
  std::uint64_t blocked = 0;
  std::uint64_t parallel = 0;
  std::uint64_t one_plane = 0;  // scenes with panels in one plane
};

void check_scene(std::uint64_t seed, Counts& counts) {
  SmallGrid grid(seed);
  const CutMesh mesh = random_surface(grid);
  std::vector<Panel> panels = random_panels(grid);
  const Camera camera = random_camera(grid);
  const View view = analyzed(mirror_world(mesh, panels), camera);
  CHECK(joined(complaints_of_reflections(view)) == "");
  std::ranges::reverse(panels);
  const MirrorWorld other_world = mirror_world(mesh, panels);
  const View other_order = analyzed(other_world, camera);
  // Of panels in one plane the first one is in front, with its dark side, too: then it is their sum that does not depend on the
  // order, if all shine.
  const bool shares_plane =
      std::ranges::any_of(other_world.panels_over, [](const auto& over) { return !over.empty(); });
  Rational sum = 0;
  Rational other_sum = 0;
  for (std::size_t p = 0; p < panels.size(); ++p) {
    counts.reflecting += any_above_resolution(view.reflections.panels[p].polygons) ? 1 : 0;
    const Rational area = image_area(view, p);
    const Rational other_area = image_area(other_order, panels.size() - 1 - p);
    if (!shares_plane) CHECK(area == other_area);
    sum += area;
    other_sum += other_area;
  }
  const bool all_shine = std::ranges::all_of(panels, [](const Panel& panel) { return panel.emits == Emits::both; });
  if (all_shine) CHECK(sum == other_sum);
  counts.one_plane += shares_plane ? 1 : 0;
  check_without_rounding(mirror_world(mesh, panels), camera, other_order);
  counts.blocked += view.reflections.statistics.blocked;
  counts.parallel += camera.projection == Projection::orthographic ? 1 : 0;
}

}  // namespace

TEST_CASE("random reflections on a small grid are valid at every stage") {
  constexpr std::uint64_t first_seed = 1;
  const std::uint64_t scenes = scene_count(3000);
  Counts counts;
  for (std::uint64_t seed = first_seed; seed < first_seed + scenes; ++seed) {
    CAPTURE(seed);
    CHECK_NOTHROW(check_scene(seed, counts));
  }
  MESSAGE(scenes << " scenes, " << counts.reflecting << " panels reflected, " << counts.blocked
                 << " pyramids with shadows, " << counts.one_plane << " scenes with panels in one plane");
  // The generator made the hard cases.
  CHECK(counts.reflecting * 3 >= scenes);
  CHECK(counts.blocked * 2 >= scenes);
  CHECK(counts.parallel * 5 >= scenes);
  CHECK((scenes < 1000 || counts.one_plane * 300 >= scenes));
}

}  // namespace sightline::tests::mirror_scenes_test
