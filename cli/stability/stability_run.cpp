#include "cli/stability/stability_run.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cli/system/resources.h"
#include "oracle/truth/truth.h"
#include "sightline/analyzer.h"
#include "sweep/segments/image_points.h"

namespace sightline::cli {

namespace {

constexpr int timed_repeats = 5;

Visibility timed_view(const FamilyScene& scene, Arithmetic arithmetic, double& seconds) {
  const Analyzer analyzer(
      uncrossed(scene.mesh),
      {.sides = SidesPolicy::both, .precision = {arithmetic, scene.grid_bits}, .engine = Engine::full});
  Visibility view;
  seconds = std::numeric_limits<double>::infinity();
  for (int i = 0; i < timed_repeats; ++i) {
    const Stopwatch watch;
    view = analyzer.visible(scene.camera);
    seconds = std::min(seconds, watch.seconds());
  }
  return view;
}

std::string first_of(const char* stage, const std::vector<std::string>& messages) {
  return messages.empty() ? "" : stage + (": " + messages.front());
}

// Each stage is looked at only where those before it are valid.
std::string broken_invariant(const Visibility& view) {
  std::string broken = first_of("scene", validate(view.scene));
  if (broken.empty()) broken = first_of("segments", validate(view.segments, view.scene));
  if (broken.empty()) broken = first_of("polygons", validate(view.polygons, view.scene, view.segments));
  if (!broken.empty()) return broken;
  return first_of("labelled", validate(label_mesh(view.scene, view.segments, view.polygons), view.scene));
}

std::vector<oracle::Claim> claims_of(const Visibility& view) {
  const ImagePoints points(view.scene, view.segments);
  std::vector<oracle::Claim> claims;
  for (const VisiblePolygon& polygon : view.polygons.polygons) {
    oracle::Claim claim{polygon.face, {}};
    for (std::size_t r = 0; r < polygon.ring_count; ++r) {
      claim.rings.emplace_back();
      for (const SegmentId s : view.polygons.ring(polygon.first_ring + r)) {
        const ExactPlace p = points.exact(view.segments.segments[s.index()].start);
        claim.rings.back().push_back({oracle::Rational(p.x, p.w), oracle::Rational(p.y, p.w)});
      }
    }
    claims.push_back(std::move(claim));
  }
  return claims;
}

double part_of_window(const oracle::Rational& area) { return oracle::Rational(area / 4).convert_to<double>(); }

void compare_with_truth(const FamilyScene& scene, const Visibility& view, StabilityRun& run) {
  const oracle::Comparison comparison = oracle::compare(scene.mesh, scene.camera, Sides::both, claims_of(view));
  std::vector<oracle::Rational> areas(scene.mesh.face_count());
  for (std::size_t p = 0; p < view.polygons.polygons.size(); ++p) {
    areas[view.polygons.polygons[p].face.index()] += exact_area(view.scene, view.segments, view.polygons, p);
  }
  const oracle::Rational unit(BigInteger(1), BigInteger(1) << static_cast<unsigned>(2 * view.scene.grid_bits));
  oracle::Rational error = 0;
  for (std::size_t f = 0; f < areas.size(); ++f) {
    error += abs(oracle::Rational(areas[f] * unit - comparison.truth.visible_area[f]));
  }
  run.area_error = part_of_window(error);
  run.mislabelled_area = part_of_window(comparison.mislabelled_area);
}

double grid_bound(const ProjectedScene& scene) {
  const double shift = std::ldexp(std::sqrt(0.5), -scene.grid_bits);
  double swept = 0;
  for (std::size_t f = 0; f < scene.status.size(); ++f) {
    const auto polygon = scene.polygon(FacetId(f));
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const ImagePoint& a = scene.point(polygon[i].point);
      const ImagePoint& b = scene.point(polygon[i + 1 == polygon.size() ? 0 : i + 1].point);
      const double length = std::hypot(static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y));
      swept += (std::ldexp(length, -scene.grid_bits) + 4 * shift) * shift;
    }
  }
  return swept / 4;
}

}  // namespace

StabilityRun run_stability(const ExtremeFamily& family, double value, Arithmetic arithmetic) {
  const FamilyScene scene = family.make(value);
  StabilityRun run;
  run.value = value;
  run.arithmetic = arithmetic;
  run.grid_bits = scene.grid_bits;
  run.faces = scene.mesh.face_count();
  run.grid_bound =
      grid_bound(project(uncrossed(scene.mesh), scene.camera, Sides::both, {Arithmetic::exact, scene.grid_bits}));
  try {
    const Visibility view = timed_view(scene, arithmetic, run.seconds);
    run.finished = true;
    compare_with_truth(scene, view, run);
    run.broken = broken_invariant(view);
  } catch (const ArithmeticError& error) {
    run.broken = error.broken();
  } catch (const InternalError& error) {
    run.broken = std::string("internal error: ") + error.what();
  }
  return run;
}

}  // namespace sightline::cli
