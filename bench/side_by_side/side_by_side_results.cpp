#include "bench/side_by_side/side_by_side_results.h"

#include <fmt/format.h>

#include <cstdio>
#include <optional>
#include <utility>

namespace sightline::bench {
namespace {

void say(const SceneFamily& family, const std::string& label, const std::string& what) {
  fmt::print(stderr, "{} {}: {}\n", family.name, label, what);
}

// Measures sightline and the rivals in turns; double arithmetic only where the family compares it.
SceneResult measure_scene(const SceneFamily& family, const SceneMaker& maker, const SideBySideOptions& options) {
  say(family, maker.label, "sightline and rivals");
  const BenchScene scene = maker.make();
  std::vector<Work> works{view_work(scene)};
  if (family.compares_arithmetic) works.push_back(view_work(scene, Arithmetic::double_precision));
  const std::size_t views = works.size();
  std::optional<RivalWorks> rivals;
  if (options.rivals) {
    for (Work& work : rivals.emplace(scene).works()) works.push_back(std::move(work));
  }
  const std::vector<Outcome> outcomes = run_in_turns(works, options.limits);
  SceneResult result{maker.label, scene.mesh->facet_count(), scene.preparation, {}, {}, {}};
  result.view = view_figures(outcomes.front(), options.limits);
  if (views > 1) result.double_precision = view_figures(outcomes[1], options.limits).sum;
  if (rivals) result.rivals = RivalWorks::figures(std::span(outcomes).subspan(views), options.limits);
  return result;
}

CgalResult measure_cgal(const std::string& label, const BenchScene& scene, const RunLimits& limits) {
  const auto triangles = projected_triangles(project(scene.mesh, scene.camera, scene.sides));
  const std::vector<Outcome> outcomes = run_in_turns({view_work(scene), cgal_work(triangles)}, limits);
  return {label, scene.mesh->facet_count(), triangles.size(), view_figures(outcomes[0], limits).sum,
          figure_of(outcomes[1], 0, limits)};
}

bool has_ended(const CgalResult& result) { return result.envelope.kind == Figure::Kind::exactly; }

// CGAL's time grows with the triangles at least in proportion.
bool is_hopeless(const std::vector<CgalResult>& results, std::size_t triangles, double limit_seconds) {
  if (results.empty()) return false;
  const CgalResult& last = results.back();
  const double growth = static_cast<double>(triangles) / static_cast<double>(last.triangles);
  return has_ended(last) ? last.envelope.value * growth > limit_seconds : growth >= 1;
}

std::vector<CgalResult> measure_for_cgal(const SceneFamily& family, const RunLimits& limits) {
  std::vector<CgalResult> results;
  for (const SceneMaker& maker : family.for_cgal) {
    const BenchScene scene = maker.make();
    if (is_hopeless(results, scene.mesh->facet_count(), limits.seconds)) continue;
    say(family, maker.label, "CGAL");
    results.push_back(measure_cgal(maker.label, scene, limits));
  }
  return results;
}

}  // namespace

FamilyResult measure_family(const SceneFamily& family, const SideBySideOptions& options) {
  FamilyResult result{family, {}, {}};
  for (const SceneMaker& maker : family.scenes) result.scenes.push_back(measure_scene(family, maker, options));
  if (options.rivals) result.cgal = measure_for_cgal(family, options.limits);
  return result;
}

const CgalResult* largest_that_cgal_ends(const FamilyResult& result) {
  const CgalResult* largest = nullptr;
  for (const CgalResult& row : result.cgal) {
    if (has_ended(row) && (largest == nullptr || largest->triangles < row.triangles)) largest = &row;
  }
  return largest;
}

}  // namespace sightline::bench
