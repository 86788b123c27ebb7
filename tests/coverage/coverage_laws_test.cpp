// Coverage is tested on random scenes by its laws and by random points of the surface.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <span>

#include "coverage/coverage.h"
#include "geometry/mesh/area.h"
#include "geometry/mesh/box_hierarchy.h"
#include "geometry/mesh/facet_plane.h"
#include "oracle/judging/judge.h"
#include "oracle/scenes/crossing_scenes.h"
#include "tests/tools/analyzed.h"

namespace sightline::tests::coverage_laws_test {
using namespace lattice;

namespace {

constexpr std::size_t camera_count = 3;
constexpr std::size_t panel_count = 2;

// The scene passes through itself, with cameras and panels around it.
struct SeenScene {
  CutMesh mesh;
  std::vector<LabelledMesh> labelled;  // per camera
  std::vector<SeenPart> seen;
};

class Random {
 public:
  explicit Random(std::uint64_t seed) : random_(seed) {}
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  // Returns a place in a cube.
  Vector3 in_cube(double half_width) {
    const double x = between(-half_width, half_width);
    const double y = between(-half_width, half_width);
    return {x, y, between(-half_width, half_width)};
  }

 private:
  std::mt19937_64 random_;
};

Panel panel_at(const Point3& centre, double size, Random& random) {
  const Vector3 u = size * random.in_cube(1);
  const Vector3 v = size * random.in_cube(1);
  return {"panel", {centre, centre + u, centre + v}, Emits::both};
}

// The cameras are near each other, so that they see much of the same.
SeenScene seen_scene(std::uint64_t seed) {
  SeenScene scene;
  scene.mesh = cut(mesh_of(crossing_scene(seed)));
  Box box{scene.mesh.vertices[0], scene.mesh.vertices[0]};
  for (const Point3& p : scene.mesh.vertices) box = hull(box, {p, p});
  const Point3 middle = 0.5 * (box.low + box.high);
  const double size = norm(box.high - box.low);
  Random random(seed);
  std::vector<Panel> panels;
  while (panels.size() < panel_count) panels.push_back(panel_at(middle + size * random.in_cube(1), size, random));
  const MirrorWorld world = mirror_world(scene.mesh, panels);
  const Vector3 direction = random.in_cube(1);
  for (std::size_t c = 0; c < camera_count; ++c) {
    const Point3 eye = middle + size * (direction + random.in_cube(0.3));
    const ViewPoint view{eye, middle + size * random.in_cube(0.2), {0.1, 1, 0.2}, 1, {}, {}};
    scene.labelled.push_back(analyzed(world, perspective_camera("c", view, 35)).labelled);
    scene.seen.push_back(seen_part(scene.labelled.back()));
  }
  return scene;
}

// Returns the triangles of all cameras on one surface that are seen, or that reflect one of the panels.
std::vector<SpaceTriangle> triangles_on(const SeenScene& scene, FacetId surface, bool reflecting) {
  std::vector<SpaceTriangle> triangles;
  for (const LabelledMesh& labelled : scene.labelled) {
    for (const LabelledTriangle& t : labelled.triangles) {
      if (t.surface != surface || !(reflecting ? t.reflecting != 0 : t.seen)) continue;
      const auto& [a, b, c] = t.corners;
      triangles.push_back({labelled.vertices[a.index()], labelled.vertices[b.index()], labelled.vertices[c.index()]});
    }
  }
  return triangles;
}

double surface_area(const CutMesh& mesh, FacetId surface) {
  double area = 0;
  for (std::size_t f = surface.index(); f < end_of_surface(mesh, surface).index(); ++f)
    area += facet_area(mesh, FacetId(f));
  return area;
}

// These are both areas of every face, by a sweep for each surface whoever sees it.
struct Swept {
  double area = 0;
  double error = 0;
};
std::vector<Swept> swept_areas(const SeenScene& scene, bool reflecting) {
  const CutMesh& mesh = scene.mesh;
  std::vector<Swept> faces(mesh.face_count());
  for (FacetId s(0); s.index() < mesh.facet_count(); s = end_of_surface(mesh, s)) {
    const auto triangles = triangles_on(scene, s, reflecting);
    if (triangles.empty()) continue;
    const UnionShare found = union_share(mesh, s, triangles);
    const double area = surface_area(mesh, s);
    Swept& face = faces[mesh.facet_face[s.index()].index()];
    face.area += found.share * area;
    face.error += found.error * area;
  }
  return faces;
}

void check_order(const std::vector<double>& ascending) { CHECK(std::ranges::is_sorted(ascending)); }

void check_laws(const Coverage& coverage) {
  double sum = 0;
  for (const CoveredAreas& camera : coverage.cameras) {
    sum += camera.visible;
    check_order({camera.any_panel, camera.visible, coverage.together.visible, coverage.area});
    check_order({camera.any_panel, coverage.together.any_panel, coverage.together.visible});
    for (std::size_t p = 0; p < panel_count; ++p) {
      check_order({camera.panels[p], camera.any_panel});
      check_order({camera.panels[p], coverage.together.panels[p], coverage.together.any_panel});
    }
  }
  CHECK(coverage.together.visible <= sum * (1 + 1e-12));
  CHECK(coverage.together.any_panel <= (coverage.together.panels[0] + coverage.together.panels[1]) * (1 + 1e-12));
  for (const FaceCoverage& face : coverage.faces) check_order({0, face.reflecting, face.visible, face.area});
}

bool is_close(double a, double b, double scale) { return std::fabs(a - b) <= 1e-9 * scale; }

void check_same(const Coverage& a, const Coverage& b) {
  CHECK(is_close(a.together.visible, b.together.visible, a.area));
  CHECK(is_close(a.together.any_panel, b.together.any_panel, a.area));
  for (std::size_t f = 0; f < a.faces.size(); ++f) {
    CHECK(is_close(a.faces[f].visible, b.faces[f].visible, a.area));
    CHECK(is_close(a.faces[f].reflecting, b.faces[f].reflecting, a.area));
  }
}

void check_against_sweeps(const Coverage& coverage, const SeenScene& scene) {
  for (const bool reflecting : {false, true}) {
    const std::vector<Swept> swept = swept_areas(scene, reflecting);
    for (std::size_t f = 0; f < swept.size(); ++f) {
      const FaceCoverage& face = coverage.faces[f];
      const double area = reflecting ? face.reflecting : face.visible;
      CHECK(std::fabs(area - swept[f].area) <= swept[f].error + 1e-13 * face.area);
    }
  }
}

// Returns whether p, in the triangle's plane but for rounding, is in it; the triangle may have either orientation.
bool is_in(const SpaceTriangle& t, const Point3& p) {
  const Vector3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  for (std::size_t i = 0; i < 3; ++i) {
    if (normal.dot((t[(i + 1) % 3] - t[i]).cross(p - t[i])) < 0) return false;
  }
  return true;
}

Point3 random_point(const CutMesh& mesh, FacetId facet, Random& random) {
  const auto corners = mesh.corners(facet);
  REQUIRE(corners.size() == 3);
  double u = random.between(0, 1);
  double v = random.between(0, 1);
  if (u + v > 1) {
    u = 1 - u;
    v = 1 - v;
  }
  const Point3& a = mesh.position(corners[0]);
  return a + (u * (mesh.position(corners[1]) - a) + v * (mesh.position(corners[2]) - a));
}

struct Hits {
  double points = 0;
  double found = 0;
  double expected = 0;
  double variance = 0;
};

// Precondition: surfaces have one triangle.
void shoot(const SeenScene& scene, Random& random, Hits& hits) {
  const CutMesh& mesh = scene.mesh;
  for (FacetId s(0); s.index() < mesh.facet_count(); s = end_of_surface(mesh, s)) {
    if (end_of_surface(mesh, s).index() != s.index() + 1 || mesh.corners(s).size() != 3) continue;
    const auto triangles = triangles_on(scene, s, false);
    if (triangles.empty()) continue;
    const double share = union_share(mesh, s, triangles).share;
    constexpr int points = 1000;
    double found = 0;
    for (int i = 0; i < points; ++i) {
      const Point3 p = random_point(mesh, s, random);
      found += std::ranges::any_of(triangles, [&](const SpaceTriangle& t) { return is_in(t, p); }) ? 1 : 0;
    }
    const double variance = points * std::max(0.0, share * (1 - share));
    CHECK(std::fabs(found - points * share) <= 6 * std::sqrt(variance) + 6);
    hits.points += points;
    hits.found += found;
    hits.expected += points * share;
    hits.variance += variance;
  }
}

}  // namespace

TEST_CASE(
    "on random scenes: a union is between its largest part and the sum, whoever comes first; and what sweeps say") {
  const std::uint64_t first_seed = std::random_device{}();
  MESSAGE("first seed " << first_seed);
  Random random(first_seed);
  Hits hits;
  std::size_t smaller_than_sum = 0;
  std::size_t reflecting = 0;
  const std::uint64_t scenes = scene_count(150);
  for (std::uint64_t seed = first_seed; seed < first_seed + scenes; ++seed) {
    INFO("seed " << seed);
    const SeenScene scene = seen_scene(seed);
    const Coverage coverage = cover(scene.mesh, scene.seen, panel_count);
    check_laws(coverage);
    check_against_sweeps(coverage, scene);
    const std::vector<SeenPart> reversed(scene.seen.rbegin(), scene.seen.rend());
    check_same(coverage, cover(scene.mesh, reversed, panel_count));
    const Coverage alone = cover(scene.mesh, std::span(scene.seen).first(1), panel_count);
    CHECK(alone.together.visible == alone.cameras[0].visible);
    CHECK(alone.together.panels == alone.cameras[0].panels);
    check_same(alone, cover(scene.mesh, std::vector{scene.seen[0], scene.seen[0]}, panel_count));
    shoot(scene, random, hits);
    double sum = 0;
    for (const CoveredAreas& camera : coverage.cameras) sum += camera.visible;
    smaller_than_sum += coverage.together.visible < 0.99 * sum ? 1U : 0U;
    reflecting += coverage.together.any_panel > 0 ? 1U : 0U;
  }
  const double deviations = (hits.found - hits.expected) / std::sqrt(hits.variance);
  MESSAGE(hits.points << " points, " << hits.found << " of them seen, " << deviations
                      << " standard deviations off; cameras overlap in " << smaller_than_sum << " scenes, "
                      << reflecting << " reflect");
  CHECK(std::fabs(deviations) < 5);
  CHECK(hits.variance > 100);
  CHECK(smaller_than_sum * 2 > scenes);
  CHECK(reflecting * 4 > scenes);
}

}  // namespace sightline::tests::coverage_laws_test
