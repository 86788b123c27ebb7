#include "bench/rival_figures.h"

#include "bench/obj_file.h"
#include "bench/rivals.h"

namespace sightline::bench {
namespace {

std::vector<double> numbers_of(const std::optional<double>& seconds) {
  return seconds ? std::vector{*seconds} : std::vector<double>{};
}

std::vector<double> numbers_of(const std::optional<EmbreeSeconds>& seconds) {
  if (!seconds) return {};
  return {seconds->hierarchy, seconds->rays, seconds->hierarchy + seconds->rays};
}

Figure measure_one(const Work& work, const RunLimits& limits) {
  return figure_of(run_repeatedly(work, limits), 0, limits);
}

Figure measure_parse(const BenchScene& scene, const RunLimits& limits) {
  const auto parse = [&](const std::filesystem::path& file) {
    return measure_one([&] { return numbers_of(seconds_to_parse(file)); }, limits);
  };
  return scene.file.empty() ? parse(TemporaryObj(scene.mesh).path()) : parse(scene.file);
}

void measure_embree(const BenchScene& scene, const RunLimits& limits, RivalFigures& figures) {
  const Outcome outcome =
      run_repeatedly([&] { return numbers_of(seconds_of_embree(scene.mesh, scene.camera)); }, limits);
  figures.embree_hierarchy = figure_of(outcome, 0, limits);
  figures.embree_rays = figure_of(outcome, 1, limits);
  figures.embree = figure_of(outcome, 2, limits);
}

}  // namespace

RivalFigures measure_rivals(const BenchScene& scene, const RunLimits& limits) {
  RivalFigures figures;
  figures.parse = measure_parse(scene, limits);
  measure_embree(scene, limits, figures);
  const ProjectedScene projected = project(scene.mesh, scene.camera, scene.sides);
  figures.sort = measure_one([&] { return std::vector{seconds_to_sort(projected.points)}; }, limits);
  const std::vector<ProjectedTriangle> triangles = projected_triangles(projected);
  figures.gl2ps = measure_one([&] { return numbers_of(seconds_of_gl2ps(triangles)); }, limits);
  return figures;
}

CgalFigures measure_cgal(const BenchScene& scene, const RunLimits& limits) {
  const std::vector<ProjectedTriangle> triangles = projected_triangles(project(scene.mesh, scene.camera, scene.sides));
  return {triangles.size(), measure_one([&] { return numbers_of(seconds_of_cgal(triangles)); }, limits)};
}

}  // namespace sightline::bench
