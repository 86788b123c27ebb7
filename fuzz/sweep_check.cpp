#include <cmath>

#include "fuzz/checks.h"
#include "fuzz/chosen_scene.h"
#include "oracle/judging/engine_comparison.h"
#include "oracle/judging/judge.h"
#include "oracle/truth/truth.h"
#include "sightline/analyzer.h"

namespace sightline::fuzz {
namespace {

// Returns whether every image, clipped, has its corners on the integer oracle's grid.
bool is_on_the_grid(const Mesh& mesh, const lattice::RandomScene& scene) {
  try {
    return lattice::oracle_faces(mesh, scene.camera, scene.sides).size() <= mesh.facet_count();
  } catch (const std::logic_error&) {
    return false;
  }
}

lattice::Complaints differences_from_truth(const Mesh& whole, const lattice::RandomScene& scene, const View& view) {
  const oracle::Truth truth = oracle::true_visibility(whole, scene.camera, scene.sides);
  std::vector<double> areas(whole.face_count());
  for (const VisiblePolygon& polygon : view.polygons.polygons) areas[polygon.face.index()] += polygon.area;
  lattice::Complaints complaints;
  for (std::size_t f = 0; f < areas.size(); ++f) {
    const double expected = truth.visible_area[f].convert_to<double>();
    if (std::fabs(areas[f] - expected) <= lattice::rounding_bound(view.scene)) continue;
    complaints.push_back("visible area of face " + std::to_string(f) + " is " + std::to_string(areas[f]) +
                         ", the oracle says " + std::to_string(expected));
  }
  return complaints;
}

// On the grid, cut where it passes through itself; or without rounding.
void check_in(Arithmetic arithmetic, const lattice::RandomScene& scene, lattice::Moved how) {
  const Mesh whole = lattice::moved(scene, how);
  const View view = Analyzer(whole, {.sides = policy_of(scene.sides), .precision = {arithmetic}}).view(scene.camera);
  lattice::Complaints complaints = lattice::complaints_of_stages(view);
  const bool exact = how == lattice::Moved::not_at_all && !view.scene.is_unrounded() && !view.mesh().is_cut() &&
                     is_on_the_grid(whole, scene);
  const auto more = exact ? lattice::judge(scene).complaints : differences_from_truth(whole, scene, view);
  complaints.insert(complaints.end(), more.begin(), more.end());
  lattice::EngineTally tally;
  const std::string engines = lattice::engine_differences(view.scene, {{4, 2}}, tally);
  if (!engines.empty()) complaints.push_back("the engines differ: " + engines);
  if (!complaints.empty())
    throw Finding("moved " + std::to_string(static_cast<int>(how)) + ": " + lattice::joined(complaints) +
                  lattice::to_text(scene));
}

}  // namespace

void check_sweep(std::string_view bytes) {
  const lattice::RandomScene scene = chosen_scene(bytes);
  check_in(Arithmetic::exact, scene, lattice::Moved::not_at_all);
  check_in(Arithmetic::unrounded, scene, move_of(bytes));
}

}  // namespace sightline::fuzz
