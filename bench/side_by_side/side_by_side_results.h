// Measuring a family of scenes.
//
// In:  a family, options.
// Out: a row of figures per scene, and for CGAL rows without the scenes that are too large for it to end within the
//      limit.
// Complexity: of what is measured. Errors: those of making the scenes, std::runtime_error where a file for a rival
//      cannot be written.
#pragma once

#include <string>
#include <vector>

#include "bench/rivals/rival_figures.h"
#include "bench/scenes/side_by_side_options.h"
#include "bench/scenes/side_by_side_scenes.h"
#include "bench/side_by_side/view_figures.h"

namespace sightline::bench {

struct SceneResult {
  std::string label;
  std::size_t triangles = 0;
  double preparation = 0;
  ViewFigures view;
  RivalFigures rivals;
  Figure double_precision;  // the sum of the stages in double arithmetic; only where the family compares them
};

struct CgalResult {
  std::string label;
  std::size_t triangles = 0;
  std::size_t triangles_in_image = 0;
  Figure view;
  Figure envelope;
};

struct FamilyResult {
  SceneFamily family;
  std::vector<SceneResult> scenes;
  std::vector<CgalResult> cgal;
};

[[nodiscard]] FamilyResult measure_family(const SceneFamily& family, const SideBySideOptions& options);

// Returns, of the rows for CGAL in which it ended, the one with the most triangles; null where there is none.
[[nodiscard]] const CgalResult* largest_that_cgal_ends(const FamilyResult& result);

}  // namespace sightline::bench
