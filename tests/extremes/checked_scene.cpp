#include "tests/extremes/checked_scene.h"

#include <doctest/doctest.h>

namespace sightline::extremes {
namespace {

// Returns the first few, in one text.
std::string some(Complaints complaints) {
  if (complaints.size() > 5) complaints.resize(5);
  return lattice::joined(complaints);
}

// Areas stay equal, as rationals. But faces that overlap in the rounded image only have no depth order, and there the
// lower index is in front: where the image is rounded a difference within that is no error.
void check_order(const Mesh& mesh, const Sight& sight, const Allowances& allowances) {
  constexpr std::uint64_t seed = 3;
  const std::vector<Rational> after = areas_when_shuffled(mesh, sight, seed);
  CHECK(total(after) == total(sight.areas));
  if (allowances.coplanar) return;
  if (is_exact(mesh, sight)) {
    CHECK(after == sight.areas);
    return;
  }
  const Rational bound = 2 * rounding_bound(sight.view.scene);
  for (std::size_t f = 0; f < after.size(); ++f) CHECK(abs(Rational(after[f] - sight.areas[f])) <= bound);
  if (after != sight.areas) MESSAGE(sight.camera.name << ": ties in the rounded image");
}

void check_sight(const Mesh& mesh, const Sight& sight, const Allowances& allowances) {
  INFO("camera ", sight.camera.name);
  Complaints complaints = complaints_of_stages_and_laws(sight.view);
  if (allowances.coarse_doubles)
    std::erase_if(complaints, [](const std::string& line) { return line.starts_with("labelled: "); });
  CHECK(some(complaints) == "");
  const RayTally rays = compare_rays(sight.view);
  CHECK(some(rays.complaints) == "");
  CHECK(rays.decided >= 200);
  CHECK(total(sight.areas) <= 4);
  check_order(mesh, sight, allowances);
  if (!allowances.large) CHECK(some(differences_from_truth(mesh, sight)) == "");
  MESSAGE(sight.camera.name << ": " << rays.decided << " rays, " << rays.seen << " see a face; image "
                            << (is_exact(mesh, sight) ? "exact" : "rounded"));
}

}  // namespace

CheckedScene checked(const std::string& name, const Allowances& allowances) {
  ExtremeScene scene = read_extreme(name);
  CheckedScene result{std::move(scene.mesh), {}};
  for (const Camera& camera : scene.cameras) {
    result.sights.push_back(sight(result.mesh, camera, scene.sides));
    check_sight(result.mesh, result.sights.back(), allowances);
  }
  return result;
}

}  // namespace sightline::extremes
