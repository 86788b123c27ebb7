#include "bench/side_by_side/side_by_side_tables.h"

#include <fmt/format.h>

#include <algorithm>

#include "bench/measuring/markdown_table.h"

namespace sightline::bench {
namespace {

bool is_prepared(const FamilyResult& result) {
  return std::any_of(result.scenes.begin(), result.scenes.end(),
                     [](const SceneResult& scene) { return scene.preparation > 0; });
}

// The times are in seconds.
std::string times_table(const FamilyResult& result) {
  std::vector<TableRow> rows;
  for (const SceneResult& scene : result.scenes) {
    const ViewFigures& view = scene.view;
    const RivalFigures& rivals = scene.rivals;
    rows.push_back({scene.label, std::to_string(scene.triangles)});
    for (const Figure& figure : {view.project, view.sweep, view.polygons, view.label, view.sum, rivals.parse,
                                 rivals.sort, rivals.embree_hierarchy, rivals.embree_rays, rivals.gl2ps}) {
      rows.back().push_back(text_of(figure));
    }
    if (is_prepared(result)) rows.back().push_back(text_of(exactly(scene.preparation)));
  }
  TableRow heading{result.family.varying, "triangles", "project",          "sweep",       "polygons", "label", "sum",
                   "tinyobjloader",       "std::sort", "Embree hierarchy", "Embree rays", "gl2ps"};
  if (is_prepared(result)) heading.emplace_back("cut before");
  return markdown_table(heading, rows);
}

std::string ratios_table(const FamilyResult& result) {
  std::vector<TableRow> rows;
  for (const SceneResult& scene : result.scenes) {
    const Figure& sum = scene.view.sum;
    rows.push_back({scene.label});
    for (const Figure& figure :
         {ratio(sum, scene.rivals.parse), ratio(sum, scene.rivals.sort), ratio(sum, scene.rivals.embree),
          ratio(scene.rivals.gl2ps, sum), scene.view.bytes_per_triangle}) {
      rows.back().push_back(text_of(figure));
    }
    if (result.family.compares_arithmetic) rows.back().push_back(text_of(ratio(sum, scene.double_precision)));
  }
  TableRow heading{result.family.varying, "sum / tinyobjloader", "sum / std::sort",
                   "sum / Embree",        "gl2ps / sum",         "bytes per triangle"};
  if (result.family.compares_arithmetic) heading.emplace_back("exact / double");
  return markdown_table(heading, rows);
}

std::string cgal_table(const FamilyResult& result) {
  std::vector<TableRow> rows;
  for (const CgalResult& row : result.cgal) {
    rows.push_back({row.label, std::to_string(row.triangles), std::to_string(row.triangles_in_image), text_of(row.view),
                    text_of(row.envelope), text_of(ratio(row.envelope, row.view))});
  }
  return markdown_table({"scene", "triangles", "in the image", "sum", "CGAL", "CGAL / sum"}, rows);
}

}  // namespace

std::string family_tables(const FamilyResult& result) {
  std::string text = fmt::format("## ({}) {}\n\n{}\n{}", result.family.number, result.family.title, times_table(result),
                                 ratios_table(result));
  if (!result.cgal.empty()) text += "\n" + cgal_table(result);
  return text + "\n";
}

std::string reflection_table(std::size_t triangles, const ReflectionFigures& figures) {
  return "## Reflection of one panel\n\n" +
         markdown_table({"size", "view", "reflection", "reflection / view"},
                        {{std::to_string(triangles), text_of(figures.visibility), text_of(figures.reflection),
                          text_of(ratio(figures.reflection, figures.visibility))}}) +
         "\n";
}

std::string threads_table(std::size_t triangles, const ThreadFigures& figures) {
  return "## Two threads\n\n" +
         markdown_table({"size", "1 thread, s", "2 threads, s", "1 / 2"},
                        {{std::to_string(triangles), text_of(figures.one), text_of(figures.two),
                          text_of(ratio(figures.one, figures.two))}}) +
         "\n";
}

std::string writing_table(std::size_t triangles, const WritingFigures& figures) {
  return "## Writing all outputs\n\n" +
         markdown_table({"size", "view", "writing", "MB", "writing / view"},
                        {{std::to_string(triangles), text_of(figures.visibility), text_of(figures.writing),
                          text_of(figures.megabytes), text_of(ratio(figures.writing, figures.visibility))}}) +
         "\n";
}

}  // namespace sightline::bench
