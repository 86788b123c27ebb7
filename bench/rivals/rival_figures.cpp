#include "bench/rivals/rival_figures.h"

#include <utility>

#include "bench/rivals/rivals.h"

namespace sightline::bench {
namespace {

std::vector<double> numbers_of(const std::optional<double>& seconds) {
  return seconds ? std::vector{*seconds} : std::vector<double>{};
}

std::vector<double> numbers_of(const std::optional<EmbreeSeconds>& seconds) {
  if (!seconds) return {};
  return {seconds->hierarchy, seconds->rays, seconds->hierarchy + seconds->rays};
}

}  // namespace

RivalWorks::RivalWorks(const BenchScene& scene) : scene_(&scene), file_(scene.file) {
  if (file_.empty()) file_ = written_.emplace(*scene.mesh).path();
  ProjectedScene projected = project(scene.mesh, scene.camera, scene.sides);
  triangles_ = projected_triangles(projected);
  points_ = std::move(projected.points);
}

std::vector<Work> RivalWorks::works() const {
  return {
      [this] { return numbers_of(seconds_to_parse(file_)); },
      [this] { return std::vector{seconds_to_sort(points_)}; },
      [this] { return numbers_of(seconds_of_embree(*scene_->mesh, scene_->camera)); },
      [this] { return numbers_of(seconds_of_gl2ps(triangles_)); },
  };
}

RivalFigures RivalWorks::figures(std::span<const Outcome> outcomes, const RunLimits& limits) {
  const auto figure = [&](std::size_t work, std::size_t index) { return figure_of(outcomes[work], index, limits); };
  return {figure(0, 0), figure(1, 0), figure(2, 0), figure(2, 1), figure(2, 2), figure(3, 0)};
}

Work cgal_work(const std::vector<ProjectedTriangle>& triangles) {
  return [&triangles] { return numbers_of(seconds_of_cgal(triangles)); };
}

}  // namespace sightline::bench
