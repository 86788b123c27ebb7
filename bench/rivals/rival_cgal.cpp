#include "bench/rivals/rivals.h"

#ifdef SIGHTLINE_BENCH_CGAL

#include <CGAL/Env_triangle_traits_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/envelope_3.h>

#include "cli/system/resources.h"

namespace sightline::bench {
using namespace cli;
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Traits = CGAL::Env_triangle_traits_3<Kernel>;

Kernel::Point_3 point_at(const Point3& place) { return {place.x(), place.y(), place.z()}; }

}  // namespace

std::optional<double> seconds_of_cgal(const std::vector<ProjectedTriangle>& triangles) {
  const ProcessorTime watch;
  std::vector<Traits::Surface_3> surfaces;
  surfaces.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles) surfaces.emplace_back(point_at(a), point_at(b), point_at(c));
  CGAL::Envelope_diagram_2<Traits> diagram;
  CGAL::lower_envelope_3(surfaces.begin(), surfaces.end(), diagram);
  return watch.seconds();
}

}  // namespace sightline::bench

#else

namespace sightline::bench {

std::optional<double> seconds_of_cgal(const std::vector<ProjectedTriangle>& /*triangles*/) { return std::nullopt; }

}  // namespace sightline::bench

#endif
