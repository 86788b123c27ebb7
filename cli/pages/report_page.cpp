#include "cli/pages/report_page.h"

#include <algorithm>

#include "cli/pages/page_template.h"
#include "cli/pages/view_block.h"
#include "cli/results/report_json.h"

namespace sightline::cli {

namespace {

// Around the input's vertices. The halves are added: the sum of two coordinates may be beyond the range of double.
Ball ball_around(const CutMesh& mesh) {
  if (mesh.vertices.empty()) return {};
  Point3 low = mesh.vertices.front();
  Point3 high = low;
  for (const Point3& p : mesh.vertices) {
    low = {std::min(low.x(), p.x()), std::min(low.y(), p.y()), std::min(low.z(), p.z())};
    high = {std::max(high.x(), p.x()), std::max(high.y(), p.y()), std::max(high.z(), p.z())};
  }
  const Vector3 half{high.x() / 2 - low.x() / 2, high.y() / 2 - low.y() / 2, high.z() / 2 - low.z() / 2};
  const double radius = std::max({half.x(), half.y(), half.z()});
  return {{low.x() + half.x(), low.y() + half.y(), low.z() + half.z()}, radius > 0 ? radius : 1};
}

std::size_t seen_triangles(const LabelledMesh& labelled) {
  return static_cast<std::size_t>(std::count_if(labelled.triangles.begin(), labelled.triangles.end(),
                                                [](const LabelledTriangle& triangle) { return triangle.seen; }));
}

Json areas_json(const CoveredAreas& areas) {
  return {{"visible", areas.visible}, {"any_panel", areas.any_panel}, {"panels", areas.panels}};
}

Json coverage_json(const Coverage& coverage) {
  return {{"area", coverage.area},
          {"cameras", list_json(coverage.cameras, areas_json)},
          {"together", areas_json(coverage.together)}};
}

Json panel_json(const Panel& panel) {
  const Json corners = list_json(panel.corners, [](const Point3& corner) { return as_json(corner); });
  return {{"name", panel.name}, {"corners", corners}, {"emits", as_json(panel.emits)}};
}

}  // namespace

ReportPage::ReportPage(std::size_t most_triangles) : room_(most_triangles), most_triangles_(most_triangles) {
  require_page(PageName::report);
}

void ReportPage::add_view(const View& view, const std::vector<Point2>& places, const std::vector<FaceMeasures>& faces) {
  const CutMesh& mesh = view.scene.mesh();
  const std::size_t all = view.labelled.triangles.size();
  const HeldTriangles held = all <= room_ ? HeldTriangles::all : HeldTriangles::seen;
  const std::size_t count = held == HeldTriangles::all ? all : seen_triangles(view.labelled);
  if (count > room_) {
    held_.push_back("nothing");
    blocks_.emplace_back();
    return;
  }
  room_ -= count;
  held_.push_back(held == HeldTriangles::all ? "all" : "seen");
  blocks_.push_back(packed(view_block(view, places, faces, ball_around(mesh), held)));
}

std::string ReportPage::text(const SceneDescription& scene, const CutMesh& mesh, const std::vector<Report>& reports,
                             const Coverage& coverage) const {
  const Ball ball = ball_around(mesh);
  const Json content = {{"reports", list_json(reports, report_json)},
                        {"held", held_},
                        {"most_triangles", most_triangles_},
                        {"centre", as_json(ball.centre)},
                        {"radius", ball.radius},
                        {"panels", list_json(scene.panels, panel_json)},
                        {"coverage", coverage_json(coverage)}};
  std::string data = packed(json_text(content));
  for (const std::string& block : blocks_) data += '\n' + block;
  return page_with_data(PageName::report, data);
}

}  // namespace sightline::cli
