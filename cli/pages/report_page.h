// report.html: everything that the results say, to look at.
//
// In:  each camera's view, one after the other; at the end their reports and what they cover together.
// Out: a page (web/report) with its data: first a block of JSON, then for each camera one of arrays (view_block.h); the block
//      of a camera is empty where it was left out.
// JSON: {"reports": report.json of each camera, "held": per camera "all", "seen" or "nothing" of its triangles,
//      "most_triangles", "centre": of the surface, what positions count from, "radius", "panels": [{"name", "corners",
//      "emits"}], "coverage": {"area", "cameras": [{"visible", "any_panel", "panels"}], "together": likewise}}.
// Holds: the page has at most most_page_triangles triangles, whatever the number of cameras: a camera whose triangles do
//      not fit any more is there with those that it sees, or, where these do not fit either, in the tables only. Equal
//      between runs but for the reports' times and memory.
// Errors: PageError where the command was built without pages, at once.
#pragma once

#include <string>
#include <vector>

#include "cli/results/report.h"
#include "coverage/coverage.h"

namespace sightline::cli {

constexpr std::size_t most_page_triangles = 2'000'000;

class ReportPage {
 public:
  explicit ReportPage(std::size_t most_triangles = most_page_triangles);

  // places: window_points(view). faces: measure_faces(view).
  void add_view(const View& view, const std::vector<Point2>& places, const std::vector<FaceMeasures>& faces);

  // reports: of the views that were added, in their order.
  [[nodiscard]] std::string text(const SceneDescription& scene, const CutMesh& mesh, const std::vector<Report>& reports,
                                 const Coverage& coverage) const;

 private:
  std::size_t room_;  // for triangles
  std::size_t most_triangles_;
  std::vector<const char*> held_;
  std::vector<std::string> blocks_;  // packed
};

}  // namespace sightline::cli
