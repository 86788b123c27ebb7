// Exact reflections are held against a million rays per scene.
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "oracle/judging/judge.h"
#include "oracle/judging/mirror_rays.h"
#include "tests/reflect/reflecting_region.h"
#include "tests/tools/analyzed.h"

namespace sightline::tests::mirror_rays_test {
using namespace lattice;

namespace {

struct MirrorScene {
  Mesh mesh;
  std::vector<Panel> panels;
  Camera camera;
};

// Ten triangles and a floor have two panels among and above them; corners are multiples of 1/16, so that they touch at
// times.
MirrorScene random_mirror_scene(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto between = [&](double low, double high) {
    return std::round(16 * (low + (high - low) * std::ldexp(static_cast<double>(random() >> 11U), -53))) / 16;
  };
  const auto near = [&](const Point3& centre, double reach) -> Vector3 {
    return centre + Vector3{between(-reach, reach), between(-reach, reach), between(-reach, reach)};
  };
  std::vector<Point3> vertices{{-3, -3, 0}, {3, -3, 0}, {3, 3, 0}, {-3, 3, 0}};
  PolygonList faces;
  faces.push_back(std::array{VertexId(0), VertexId(1), VertexId(2), VertexId(3)});
  for (int i = 0; i < 10; ++i) {
    const Point3 centre{between(-2, 2), between(-2, 2), between(0, 2)};
    std::array<VertexId, 3> corners;
    for (VertexId& corner : corners) {
      corner = VertexId(vertices.size());
      vertices.push_back(near(centre, 1));
    }
    faces.push_back(corners);
  }
  std::vector<Panel> panels;
  for (const Emits emits : {Emits::both, Emits::front}) {
    const Point3 corner{between(-2, 1), between(-2, 1), between(1, 3)};
    const Vector3 u{between(1, 2), between(-1, 1), between(-1, 1)};
    const Vector3 v{between(-1, 1), between(1, 2), between(-1, 1)};
    panels.push_back({"panel", {corner, corner + u, corner + u + v, corner + v}, emits});
  }
  const ViewPoint view{{between(-2, 2), between(-5, -4), between(2, 4)}, {0, 0, 0.5}, {0, 0, 1}, 1, {}, {}};
  return {build_mesh(std::move(vertices), std::move(faces)), panels, perspective_camera("random", view, 50)};
}

double area(const View& view, std::size_t panel) {
  double sum = 0;
  for (const VisiblePolygon& polygon : view.reflections.panels[panel].polygons.polygons) sum += polygon.area;
  return sum;
}

struct Tally {
  std::uint64_t rays = 0;
  std::array<std::uint64_t, 2> seen{};
  std::uint64_t near_border = 0;
  std::uint64_t wrong = 0;
};

Tally compare(const MirrorScene& scene, const View& view, std::uint64_t rays, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto coordinate = [&] { return std::ldexp(static_cast<double>(random() >> 11U), -52) - 1; };
  const MirrorRays oracle(scene.mesh, scene.panels, scene.camera);
  const std::array regions{ReflectingRegion(view, 0), ReflectingRegion(view, 1)};
  Tally tally;
  for (; tally.rays < rays; ++tally.rays) {
    const Point2 p{coordinate(), coordinate()};
    const int panel = oracle.panel_at(p.x, p.y);
    if (panel >= 0) ++tally.seen[static_cast<std::size_t>(panel)];
    for (int i = 0; i < 2; ++i) {
      const auto winding = regions[static_cast<std::size_t>(i)].winding(p);
      if (!winding) {
        ++tally.near_border;
      } else if ((*winding > 0) != (panel == i)) {
        ++tally.wrong;
      }
    }
  }
  return tally;
}

// Returns where the ray from the eye, mirrored at a triangle's middle, meets a panel's plane.
Point3 place_on_panel(const Point3& eye, const Point3& middle, const Vector3& normal, const Panel& panel) {
  const Vector3 direction = middle - eye;
  const Vector3 mirrored = direction - (2 * direction.dot(normal) / normal.dot(normal)) * normal;
  const Vector3 of_panel = (panel.corners[1] - panel.corners[0]).cross(panel.corners[2] - panel.corners[0]);
  return middle + ((panel.corners[0] - middle).dot(of_panel) / mirrored.dot(of_panel)) * mirrored;
}

// Returns a small square around a place, across the direction.
Panel small_panel(const Point3& place, const Vector3& direction) {
  constexpr double half = 1.0 / 1024;
  const Vector3 beside =
      direction.cross(std::fabs(direction.x()) < std::fabs(direction.z()) ? Vector3{1, 0, 0} : Vector3{0, 0, 1});
  const Vector3 u = (half / norm(beside)) * beside;
  const Vector3 up = beside.cross(direction);
  const Vector3 v = (half / norm(up)) * up;
  // Rounding to multiples of 2^-20 keeps its corners in one plane: three of them and their parallelogram.
  const auto rounded = [](const Vector3& w) -> Vector3 {
    const auto to_grid = [](double x) { return std::round(x * 0x1p20) * 0x1p-20; };
    return Vector3{to_grid(w.x()), to_grid(w.y()), to_grid(w.z())};
  };
  const Point3 corner = rounded(place - u - v);
  const Vector3 along_u = rounded(2 * u);
  const Vector3 along_v = rounded(2 * v);
  return {"eye", {corner, corner + along_u, corner + along_u + along_v, corner + along_v}, Emits::both};
}

// Returns whether a camera on the panel, looking at the middle of the triangle, sees there the place where the first
// eye was.
bool sees_back(const AnyMesh& mesh, const MirrorScene& scene, const LabelledMesh& labelled, const LabelledTriangle& t,
               std::size_t panel) {
  const auto corner = [&](std::size_t i) { return labelled.vertices[t.corners[i].index()]; };
  const Point3 middle = (1.0 / 3) * (corner(0) + corner(1) + corner(2));
  const Vector3 normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
  const Point3 place = place_on_panel(scene.camera.origin, middle, normal, scene.panels[panel]);
  const ViewPoint view{place, middle, {0.3, 0.2, 1}, 1, {}, {}};
  const Panel eye = small_panel(scene.camera.origin, middle - scene.camera.origin);
  const View back = analyzed(mirror_world(mesh, {eye}), perspective_camera("back", view, 20));
  return ReflectingRegion(back, 0).winding({0, 0}).value_or(0) > 0;
}

}  // namespace

TEST_CASE(
    "light goes the same way back: a camera on the panel sees the first camera's place where that saw the panel") {
  const std::uint64_t scenes = scene_count(20);
  int paths = 0;
  for (std::uint64_t seed = 101; seed < 101 + scenes; ++seed) {
    CAPTURE(seed);
    const MirrorScene scene = random_mirror_scene(seed);
    const CutMesh mesh = cut(scene.mesh);
    const View view = analyzed(mirror_world(mesh, scene.panels), scene.camera);
    for (const LabelledTriangle& t : view.labelled.triangles) {
      for (std::size_t p = 0; p < 2; ++p) {
        const auto corner = [&](std::size_t i) { return view.labelled.vertices[t.corners[i].index()]; };
        const bool large = norm((corner(1) - corner(0)).cross(corner(2) - corner(0))) > 1e-3;
        if ((t.reflecting >> p & 1U) == 0 || !large) continue;
        ++paths;
        CHECK(sees_back(mesh, scene, view.labelled, t, p));
      }
    }
  }
  MESSAGE(paths << " paths");
  CHECK(paths >= 5 * static_cast<int>(scenes));
}

TEST_CASE("a million rays per scene meet the panels where the exact reflection says so") {
  constexpr std::uint64_t first_seed = 1;
  const std::uint64_t scenes = scene_count(20);
  const std::uint64_t rays = 50 * scene_count(20000);
  std::uint64_t reflecting = 0;
  std::uint64_t blocked = 0;
  std::uint64_t passing_through = 0;
  for (std::uint64_t seed = first_seed; seed < first_seed + scenes; ++seed) {
    CAPTURE(seed);
    const MirrorScene scene = random_mirror_scene(seed);
    const CutMesh mesh = cut(scene.mesh);
    const MirrorWorld world = mirror_world(mesh, scene.panels);
    const View view = analyzed(world, scene.camera);
    CHECK(joined(complaints_of_stages(view)) == "");
    const Tally tally = compare(scene, view, rays, seed);
    CHECK(tally.wrong == 0);
    CHECK(tally.near_border * 10000 <= tally.rays);
    for (std::size_t p = 0; p < 2; ++p) {
      const double share = area(view, p) / 4;
      const double deviation = std::sqrt(share * (1 - share) / static_cast<double>(tally.rays));
      CHECK(std::fabs(static_cast<double>(tally.seen[p]) / static_cast<double>(tally.rays) - share) <=
            4 * deviation + 1e-12);
      reflecting += share > 0.001 ? 1 : 0;
    }
    blocked += view.reflections.statistics.blocked;
    passing_through += mesh.is_cut() ? 1 : 0;
  }
  MESSAGE(scenes << " scenes, " << reflecting << " panels seen in mirrors, " << blocked << " pyramids with shadows, "
                 << passing_through << " scenes with faces that pass through each other");
  // The generator made the hard cases.
  CHECK(reflecting >= scenes);
  CHECK(blocked >= scenes);
  CHECK(2 * passing_through >= scenes);
}

}  // namespace sightline::tests::mirror_rays_test
