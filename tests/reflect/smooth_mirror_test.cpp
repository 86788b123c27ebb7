// Bent mirrors are held against flat ones, a parabola, and rays.
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "geometry/mesh/vertex_normals.h"
#include "oracle/judging/mirror_rays.h"
#include "tests/reflect/mirror_outcome.h"
#include "tests/reflect/reflecting_region.h"

namespace sightline::tests::smooth_mirror_test {
namespace {

constexpr ReflectionOptions smooth(double tolerance) {
  return {ReflectionMode::smooth, MirrorNormals::vertex, tolerance};
}

double visible_image_area(const View& view) {
  double sum = 0;
  for (const VisiblePolygon& polygon : view.polygons.polygons) sum += polygon.area;
  return sum;
}

// The field has cells x cells squares of two triangles over [-half, half]^2.
struct HeightField {
  Mesh mesh;
  std::vector<Vector3> normals;  // parallel to mesh.faces.corners
};

template <class Height, class Normal>
HeightField height_field(int cells, double half, Height height, Normal normal) {
  std::vector<Point3> vertices;
  const auto coordinate = [&](int i) { return half * (2.0 * i / cells - 1); };
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i)
      vertices.push_back({coordinate(i), coordinate(j), height(coordinate(i), coordinate(j))});
  }
  HeightField field;
  PolygonList faces;
  const auto add = [&](std::array<int, 3> corners) {
    std::vector<VertexId> face;
    for (const int corner : corners) {
      face.emplace_back(static_cast<std::size_t>(corner));
      const Point3& p = vertices[static_cast<std::size_t>(corner)];
      field.normals.push_back(normal(p.x(), p.y()));
    }
    faces.push_back(face);
  };
  const int row = cells + 1;
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      const int low = j * row + i;
      add({low, low + 1, low + row + 1});
      add({low, low + row + 1, low + row});
    }
  }
  field.mesh = build_mesh(std::move(vertices), std::move(faces));
  return field;
}

// The camera of a height field has parallel rays straight down on [-half, half]^2.
Camera straight_down(double half) {
  Camera camera = looking_down({0, 0, 4});
  camera.projection = Projection::orthographic;
  camera.right = {1 / half, 0, 0};
  camera.up = {0, 1 / half, 0};
  camera.eye = {{0, 0, 1}, 0};
  return camera;
}

struct BentScene {
  Mesh mesh;
  std::vector<Vector3> normals;
  std::vector<Panel> panels;
  Camera camera;
};

// A bumpy mirror has normals that wander, under four triangles and two panels.
BentScene random_bent_scene(std::mt19937_64& random) {
  const auto between = [&](double low, double high) {
    return std::round(256 * (low + (high - low) * std::ldexp(static_cast<double>(random() >> 11U), -53))) / 256;
  };
  HeightField field = height_field(
      3, 2, [&](double /*x*/, double /*y*/) { return between(-0.2, 0.2); },
      [&](double /*x*/, double /*y*/) {
        return Vector3{between(-0.3, 0.3), between(-0.3, 0.3), 1};
      });
  std::vector<Point3> vertices = field.mesh.vertices;
  PolygonList faces = field.mesh.faces;
  for (int i = 0; i < 4; ++i) {
    std::vector<VertexId> corners;
    const Point3 centre{between(-1, 1), between(-1, 1), between(1, 2)};
    for (int k = 0; k < 3; ++k) {
      corners.emplace_back(vertices.size());
      vertices.push_back(centre + Vector3{between(-0.5, 0.5), between(-0.5, 0.5), between(-0.5, 0.5)});
      field.normals.push_back({0, 0, 1});
    }
    faces.push_back(corners);
  }
  Corners one = rectangle(between(-2, -1), between(1, 2), between(-2, 0), between(2, 4), 3);
  std::ranges::reverse(one);  // its front looks down
  const Corners two = rectangle(between(-3, 0), between(0, 3), between(-2, 1), between(2, 4), 3.5);
  const ViewPoint view{{between(-1, 1), between(-5, -4), between(3, 4)}, {0, 0, 0}, {0, 0, 1}, 1, {}, {}};
  return {build_mesh(std::move(vertices), std::move(faces)),
          std::move(field.normals),
          {{"one", one, Emits::front}, {"two", two, Emits::both}},
          perspective_camera("random", view, 45)};
}

struct Tally {
  std::uint64_t seen = 0;
  std::uint64_t wrong = 0;
  std::uint64_t wrong_away_from_border = 0;
  std::uint64_t blocked = 0;
};

void compare(const BentScene& scene, const View& view, std::uint64_t rays, std::mt19937_64& random, Tally& tally) {
  const auto coordinate = [&] { return std::ldexp(static_cast<double>(random() >> 11U), -52) - 1; };
  const lattice::MirrorRays oracle(scene.mesh, scene.panels, scene.camera, scene.normals);
  const std::array regions{ReflectingRegion(view, 0), ReflectingRegion(view, 1)};
  for (std::uint64_t ray = 0; ray < rays; ++ray) {
    const Point2 place{coordinate(), coordinate()};
    const int panel = oracle.panel_at(place.x, place.y);
    tally.seen += panel >= 0 ? 1 : 0;
    for (int p = 0; p < 2; ++p) {
      const ReflectingRegion& region = regions[static_cast<std::size_t>(p)];
      const auto winding = region.winding(place);
      if (!winding || (*winding > 0) == (panel == p)) continue;
      ++tally.wrong;
      // As the report says, and what a border is off by where it is rounded.
      const double near = view.reflections.panels[static_cast<std::size_t>(p)].border_distance + 1e-9;
      tally.wrong_away_from_border += region.winding(place, near) ? 1 : 0;
    }
  }
}

}  // namespace

TEST_CASE("a bent mirror that is flat reflects what a flat one does") {
  const Corners halved{{0.625, -0.375, 2}, {2.125, -0.375, 2}, {2.125, 0.375, 2}, {0.625, 0.375, 2}};
  const Corners wall{{0.25, -4, -3}, {0.25, 4, -3}, {0.25, 4, 1}, {0.25, -4, 1}};
  const Corners upright{{2, -1, -4}, {2, 1, -4}, {2, 1, 4}, {2, -1, 4}};
  const Corners angle{{1, -1, 4}, {3, -1, 4}, {3, 0, 4}, {2, 0, 4}, {2, 1, 4}, {1, 1, 4}};
  const Corners strip = rectangle(0.625, 1.375, -6, 6, 2);
  const std::vector<std::vector<Corners>> surfaces{
      {floor_mirror}, {floor_mirror, halved}, {floor_mirror, wall}, {floor_mirror, strip}};
  for (const std::vector<Corners>& surface : surfaces) {
    CAPTURE(surface.size());
    const CutMesh mesh = lattice::cut(mesh_of(surface));
    const std::vector<Panel> panels{
        {"overhead", overhead, Emits::both}, {"upright", upright, Emits::front}, {"angle", angle, Emits::both}};
    const MirrorOutcome exact = reflected(mesh, panels, looking_down(mirror_eye));
    const MirrorOutcome bent = reflected(mesh, panels, looking_down(mirror_eye), smooth(1e-3));
    // Borders have moved by rounding to the grid, and are not longer than four times the window's.
    const double bound = std::ldexp(4 * 8.0, -exact.view.scene.grid_bits);
    for (std::size_t p = 0; p < panels.size(); ++p) {
      CAPTURE(p);
      CHECK(std::fabs(image_area(bent.view, p) - image_area(exact.view, p)) <= bound);
    }
    CHECK(image_area(exact.view, 0) > 0);
  }
}

TEST_CASE("a parabolic mirror shows a small panel in its focus everywhere, as its normals say and its faces do not") {
  // z = (x^2 + y^2) / 16: the focus is at height 4. Light from straight above meets it; the panel is dark above.
  const HeightField field = height_field(
      8, 2, [](double x, double y) { return (x * x + y * y) / 16; },
      [](double x, double y) {
        return Vector3{-x / 8, -y / 8, 1};
      });
  const std::vector<Panel> panels{{"focus", rectangle(-0.125, 0.125, -0.125, 0.125, 4), Emits::both}};
  const Camera camera = straight_down(2);
  const MirrorOutcome bent = reflected(field.mesh, panels, camera, smooth(1e-3), field.normals);
  CHECK(image_area(bent.view, 0) == doctest::Approx(4).epsilon(1e-3));
  const MirrorOutcome flat = reflected(field.mesh, panels, camera);
  CHECK(image_area(flat.view, 0) < 2);
  CHECK(image_area(flat.view, 0) > 0.5);
}

TEST_CASE("normals that the file does not give are means, by area, of the faces around a vertex") {
  const HeightField field = height_field(
      16, 2, [](double x, double y) { return (x * x + y * y) / 16; },
      [](double /*x*/, double /*y*/) -> Vector3 { return Vector3::Zero(); });
  const std::vector<Panel> panels{{"focus", rectangle(-0.25, 0.25, -0.25, 0.25, 4), Emits::both}};
  const MirrorOutcome bent = reflected(field.mesh, panels, straight_down(2), smooth(1e-3));
  // It is all but the border, where the mean looks to one side only.
  CHECK(image_area(bent.view, 0) > 4 * 0.75);
}

TEST_CASE("a ray that does not rise from its face meets nothing") {
  // Normals lean so far to the side that rays from above go down beyond the mirror, where a panel is.
  const HeightField field = height_field(
      1, 2, [](double /*x*/, double /*y*/) { return 0.0; },
      [](double /*x*/, double /*y*/) {
        return Vector3{1, 0, 0.5};
      });
  const Corners below{{1, -8, -9}, {1, 8, -9}, {30, 8, -9}, {30, -8, -9}};
  const MirrorOutcome bent =
      reflected(field.mesh, {{"below", below, Emits::both}}, straight_down(2), smooth(1e-2), field.normals);
  CHECK(image_area(bent.view, 0) == 0);
}

TEST_CASE("dividing further changes less") {
  const HeightField field = height_field(
      2, 2, [](double x, double y) { return std::cos(x) * std::cos(y) / 4; },
      [](double x, double y) {
        return Vector3{std::sin(x) * std::cos(y) / 4, std::cos(x) * std::sin(y) / 4, 1};
      });
  const std::vector<Panel> panels{{"panel", rectangle(-1, 1, -2, 1, 3), Emits::both}};
  double last = 2;
  for (const double tolerance : {1e-1, 1e-2, 1e-3}) {
    CAPTURE(tolerance);
    const MirrorOutcome bent = reflected(field.mesh, panels, straight_down(2), smooth(tolerance), field.normals);
    const double reached = bent.view.reflections.panels[0].uncertain_area / image_area(bent.view, 0);
    CHECK(reached <= tolerance);
    CHECK(reached <= last);
    last = reached;
    CHECK(image_area(bent.view, 0) > 0);
    CHECK(image_area(bent.view, 0) < visible_image_area(bent.view));
  }
  CHECK(last < 1e-3);
}

TEST_CASE("a million rays meet the panels where the bent mirror says so, but for some near the region's border") {
  constexpr std::uint64_t first_seed = 1;
  const std::uint64_t scenes = lattice::scene_count(40);
  constexpr std::uint64_t rays = 25000;
  constexpr double tolerance = 1e-2;
  Tally tally;
  for (std::uint64_t seed = first_seed; seed < first_seed + scenes; ++seed) {
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    const BentScene scene = random_bent_scene(random);
    const MirrorOutcome bent =
        reflected(lattice::cut(scene.mesh), scene.panels, scene.camera, smooth(tolerance), scene.normals);
    tally.blocked += bent.view.reflections.statistics.blocked > 0 ? 1 : 0;
    compare(scene, bent.view, rays, random, tally);
  }
  const std::uint64_t all = scenes * rays;
  MESSAGE(all << " rays, " << tally.seen << " meet a panel, " << tally.wrong << " elsewhere than said; "
              << tally.blocked << " scenes with shadows");
  CHECK(static_cast<double>(tally.wrong) <= 2 * tolerance * static_cast<double>(tally.seen));
  CHECK(tally.wrong_away_from_border == 0);
  // The generator made the hard cases.
  CHECK(20 * tally.seen >= all);
  CHECK(2 * tally.blocked >= scenes);
}

}  // namespace sightline::tests::smooth_mirror_test
