#include "tests/extremes/checks.h"

#include <algorithm>
#include <sstream>

#include "oracle/judging/labelled_laws.h"
#include "oracle/judging/ray_caster.h"
#include "oracle/judging/scene_changes.h"
#include "oracle/truth/truth.h"
#include "tests/tools/unrounded_areas.h"

namespace sightline::extremes {
namespace {

using boost::multiprecision::cpp_int;

constexpr std::size_t ray_count = 300;

void append(Complaints& all, const Complaints& more) { all.insert(all.end(), more.begin(), more.end()); }

bool in_window(const ImagePoint& p, std::int64_t half) {
  return p.x > -half && p.x < half && p.y > -half && p.y < half;
}

// The rays are three grid units from about `count` of the scene's points, diagonally.
std::vector<ImagePoint> rays_beside_corners(const ProjectedScene& scene, std::size_t count) {
  const std::size_t stride = 1 + 4 * scene.points.size() / count;
  std::vector<ImagePoint> rays;
  for (std::size_t i = 0; i < scene.points.size(); i += stride) {
    const ImagePoint& p = scene.points[i];
    rays.insert(rays.end(), {{p.x - 3, p.y - 3}, {p.x + 3, p.y - 3}, {p.x - 3, p.y + 3}, {p.x + 3, p.y + 3}});
  }
  return rays;
}

std::vector<ImagePoint> chosen_rays(const ProjectedScene& scene) {
  std::vector<ImagePoint> rays = lattice::fixed_rays(scene.grid_bits, ray_count);
  const std::vector<ImagePoint> beside = rays_beside_corners(scene, ray_count);
  rays.insert(rays.end(), beside.begin(), beside.end());
  const std::int64_t half = std::int64_t{1} << static_cast<unsigned>(scene.grid_bits);
  std::erase_if(rays, [half](const ImagePoint& p) { return !in_window(p, half); });
  std::sort(rays.begin(), rays.end(), [](const ImagePoint& a, const ImagePoint& b) { return a.y < b.y; });
  return rays;
}

// Keeps the hits of the rays that have no border within a grid unit: the eight grid points around see the same facets.
void mark_near_edges(std::vector<lattice::RayHits>& hits, const ProjectedScene& scene,
                     const std::vector<ImagePoint>& rays) {
  for (int dx = -1; dx <= 1; ++dx) {
    for (int dy = -1; dy <= 1; ++dy) {
      std::vector<ImagePoint> moved = rays;
      for (ImagePoint& p : moved) p = {p.x + dx, p.y + dy};
      const auto there = lattice::cast(scene, moved);
      for (std::size_t r = 0; r < rays.size(); ++r) {
        hits[r].on_edge |= there[r].on_edge || there[r].facets != hits[r].facets;
      }
    }
  }
}

std::string text(const std::vector<FaceId>& faces) {
  std::string result;
  for (const FaceId f : faces) result += " " + std::to_string(f.value);
  return result.empty() ? " none" : result;
}

std::string number(const Rational& value) {
  std::ostringstream out;
  out << value.convert_to<double>();
  return out.str();
}

}  // namespace

Complaints complaints_of_stages_and_laws(const View& view) {
  const CutMesh& mesh = view.scene.mesh();
  Complaints complaints = lattice::complaints_of_stages(view);
  append(complaints, lattice::input_vertices_kept(mesh, view.labelled));
  append(complaints, lattice::areas_kept(mesh, view.labelled));
  if (lattice::is_closed(mesh) && !lattice::is_closed(view.labelled)) complaints.push_back("the surface is open now");
  return complaints;
}

RayTally compare_rays(const View& view) {
  const CutMesh& mesh = view.scene.mesh();
  const std::vector<ImagePoint> rays = chosen_rays(view.scene);
  auto hits = lattice::cast(view.scene, rays);
  mark_near_edges(hits, view.scene, rays);
  const auto polygons = lattice::polygons_around(view, rays);
  RayTally tally;
  for (std::size_t r = 0; r < rays.size(); ++r) {
    if (hits[r].on_edge) continue;
    auto& facets = hits[r].facets;
    if (facets.size() > 1) lattice::sort_by_depth(facets, view.mesh(), view.scene, rays[r]);
    std::vector<FaceId> expected;
    if (!facets.empty()) expected.push_back(mesh.facet_face[facets.front().index()]);
    std::vector<FaceId> shown;
    for (const std::size_t p : polygons[r]) shown.push_back(view.polygons.polygons[p].face);
    ++tally.decided;
    tally.seen += expected.size();
    if (shown == expected) continue;
    tally.complaints.push_back("the ray at (" + std::to_string(rays[r].x) + ", " + std::to_string(rays[r].y) +
                               ") sees face" + text(expected) + ", the polygons show" + text(shown));
  }
  return tally;
}

std::vector<Rational> areas_when_shuffled(const Mesh& mesh, const Sight& before, std::uint64_t seed) {
  lattice::Dice dice(seed);
  const lattice::Shuffled shuffled = lattice::with_faces_shuffled(mesh, dice);
  const SidesPolicy policy = before.sides == Sides::front ? SidesPolicy::front : SidesPolicy::both;
  const std::vector<Rational> after = sight(shuffled.mesh, before.camera, policy).areas;
  std::vector<Rational> put_back(after.size());
  for (std::size_t i = 0; i < after.size(); ++i) put_back[shuffled.order[i]] = after[i];
  return put_back;
}

Rational rounding_bound(const ProjectedScene& scene) {
  cpp_int bound = 0;
  for (std::size_t f = 0; f < scene.status.size(); ++f) {
    const auto polygon = scene.polygon(FacetId(f));
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const ImagePoint& p = scene.point(polygon[i].point);
      const ImagePoint& q = scene.point(polygon[i + 1 == polygon.size() ? 0 : i + 1].point);
      bound += (q.x > p.x ? q.x - p.x : p.x - q.x) + (q.y > p.y ? q.y - p.y : p.y - q.y) + 3;
    }
  }
  return {bound, cpp_int(1) << static_cast<unsigned>(2 * scene.grid_bits)};
}

Complaints differences_from_truth(const Mesh& mesh, const Sight& sight) {
  const oracle::Truth truth = oracle::true_visibility(mesh, sight.camera, sight.sides);
  const bool exact = is_exact(mesh, sight);
  const Rational bound = exact ? Rational(0) : rounding_bound(sight.view.scene);
  Complaints complaints;
  if (tests::unrounded_areas(mesh, sight.camera, sight.sides).of_face != truth.visible_area)
    complaints.emplace_back("without rounding the visible areas are not the truth's");
  for (std::size_t f = 0; f < sight.areas.size(); ++f) {
    const Rational difference = abs(Rational(sight.areas[f] - truth.visible_area[f]));
    if (difference <= bound) continue;
    complaints.push_back("face " + std::to_string(f) + " shows " + number(sight.areas[f]) + ", in truth " +
                         number(truth.visible_area[f]) + ", apart by " + number(difference) + ", more than " +
                         number(bound));
  }
  return complaints;
}

}  // namespace sightline::extremes
