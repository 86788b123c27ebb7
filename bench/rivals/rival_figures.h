// These figures say what the same scene costs the rivals.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "bench/measuring/figure.h"
#include "bench/scenes/obj_file.h"
#include "bench/scenes/projected_triangles.h"
#include "bench/scenes/side_by_side_scenes.h"

namespace sightline::bench {

struct RivalFigures {
  Figure parse;
  Figure sort;
  Figure embree_hierarchy;
  Figure embree_rays;
  Figure embree;  // both
  Figure gl2ps;
};

class RivalWorks {
 public:
  explicit RivalWorks(const BenchScene& scene);

  // They refer to this and to the scene.
  [[nodiscard]] std::vector<Work> works() const;

  // The outcomes are in the order of the works.
  [[nodiscard]] static RivalFigures figures(std::span<const Outcome> outcomes, const RunLimits& limits);

 private:
  const BenchScene* scene_;
  std::optional<TemporaryObj> written_;  // where the scene comes from no file
  std::filesystem::path file_;
  std::vector<ImagePoint> points_;
  std::vector<ProjectedTriangle> triangles_;
};

// The work refers to the triangles.
[[nodiscard]] Work cgal_work(const std::vector<ProjectedTriangle>& triangles);

}  // namespace sightline::bench
