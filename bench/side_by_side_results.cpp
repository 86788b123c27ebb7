#include "bench/side_by_side_results.h"

#include <fmt/format.h>

#include <cstdio>

namespace sightline::bench {
namespace {

void say(const SceneFamily& family, const std::string& label, const std::string& what) {
  fmt::print(stderr, "{} {}: {}\n", family.name, label, what);
}

SceneResult measure_scene(const SceneFamily& family, const SceneMaker& maker, const SideBySideOptions& options) {
  say(family, maker.label, "sightline");
  const BenchScene scene = maker.make();
  SceneResult result{maker.label, scene.mesh.facet_count(), scene.preparation, {}, {}, {}};
  result.view = measure_view(scene, options.limits);
  if (family.compares_arithmetic) {
    result.double_precision = measure_view(scene, options.limits, Arithmetic::double_precision).sum;
  }
  if (options.rivals) {
    say(family, maker.label, "rivals");
    result.rivals = measure_rivals(scene, options.limits);
  }
  return result;
}

bool has_ended(const CgalResult& result) { return result.cgal.envelope.kind == Figure::Kind::exactly; }

// CGAL's time grows with the triangles at least in proportion.
bool is_hopeless(const std::vector<CgalResult>& results, std::size_t triangles, double limit_seconds) {
  if (results.empty()) return false;
  const CgalResult& last = results.back();
  const double growth = static_cast<double>(triangles) / static_cast<double>(last.triangles);
  return has_ended(last) ? last.cgal.envelope.value * growth > limit_seconds : growth >= 1;
}

std::vector<CgalResult> measure_for_cgal(const SceneFamily& family, const RunLimits& limits) {
  std::vector<CgalResult> results;
  for (const SceneMaker& maker : family.for_cgal) {
    const BenchScene scene = maker.make();
    const std::size_t triangles = scene.mesh.facet_count();
    if (is_hopeless(results, triangles, limits.seconds)) continue;
    say(family, maker.label, "CGAL");
    results.push_back({maker.label, triangles, measure_view(scene, limits).sum, measure_cgal(scene, limits)});
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
