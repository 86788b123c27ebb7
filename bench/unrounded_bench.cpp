// The sweep without rounding and without cutting, beside the sweep on the grid of what was cut. Prints the tables of
// docs/unrounded.md.
//
//     build/release/bench/sightline_unrounded [MODEL.obj...]      (without a model: generated scenes)
//
// Processor time of one thread, the least of several runs; ratios within one run of the program.

#include <tbb/global_control.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <limits>
#include <string>

#include "bench/measuring/markdown_table.h"
#include "bench/scenes/generated_scenes.h"
#include "cli/system/resources.h"
#include "formats/reading/obj_reader.h"
#include "geometry/cutting/common_lines.h"
#include "geometry/cutting/interpenetration.h"
#include "geometry/mesh/box_hierarchy.h"
#include "sweep/plain/sweep.h"
#include "sweep/unrounded/unrounded_sweep.h"

namespace sightline::bench {
namespace {

constexpr int runs = 3;

struct Scene {
  std::string name;
  Mesh mesh;
  Camera camera;
  Sides sides = Sides::both;
};

template <class Work>
double least_seconds(Work work) {
  double least = std::numeric_limits<double>::infinity();
  for (int run = 0; run < runs; ++run) {
    const cli::ProcessorTime watch;
    work();
    least = std::min(least, watch.seconds());
  }
  return least;
}

std::string number(const char* format, double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

TableRow row_of(const Scene& scene) {
  std::shared_ptr<const CutMesh> cut;
  std::shared_ptr<const CutMesh> uncut = std::make_shared<const CutMesh>(uncrossed(scene.mesh));
  const double cutting = least_seconds(
      [&] { cut = std::make_shared<const CutMesh>(cut_along_common_lines(scene.mesh, find_contacts(scene.mesh))); });
  ProjectedScene projected;
  VisibleSegments swept;
  const double project_grid = least_seconds([&] { projected = project(cut, scene.camera, scene.sides); });
  const double sweep_grid = least_seconds([&] { swept = plain_sweep(projected); });
  ProjectedScene unrounded;
  UnroundedCounts counts;
  const double project_new =
      least_seconds([&] { unrounded = project(uncut, scene.camera, scene.sides, {Arithmetic::unrounded}); });
  const double sweep_new =
      least_seconds([&] { swept = unrounded_sweep(unrounded, depth_ranges(unrounded), nullptr, &counts); });
  const auto asked = static_cast<double>(counts.sides + counts.turns);
  const auto exact = static_cast<double>(counts.exact_sides + counts.exact_turns + counts.exact_orders);
  return {scene.name,
          std::to_string(scene.mesh.facet_count()),
          std::to_string(cut->cuts.crossing.size()),
          std::to_string(cut->facet_count()),
          number("%.2f", sweep_new / sweep_grid),
          number("%.2f", (project_new + sweep_new) / (project_grid + sweep_grid)),
          number("%.2f", cutting / (project_grid + sweep_grid)),
          number("%.3f", (project_new + sweep_new) / (cutting + project_grid + sweep_grid)),
          number("%.3f", 1000 * exact / asked)};
}

// The camera sees all of it, from a side and above.
Camera camera_around(const Mesh& mesh) {
  Box box{mesh.vertices.front(), mesh.vertices.front()};
  for (const Point3& p : mesh.vertices) box = hull(box, {p, p});
  const Point3 middle = 0.5 * (box.low + box.high);
  const double radius = norm(box.high - box.low) / 2;
  return perspective_camera("around", {middle + radius * Vector3{1.7, 1.3, 2.1}, middle, {0, 1, 0}, 1, {}, {}}, 40);
}

// Cubes that touch, each with corners of its own.
Mesh block_of_cubes(int across) {
  std::vector<Point3> vertices;
  PolygonList faces;
  constexpr std::array<std::array<std::size_t, 4>, 6> sides{
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  for (int cube = 0; cube < across * across * across; ++cube) {
    const std::size_t first = vertices.size();
    const Point3 corner(cube % across, cube / across % across, cube / (across * across));
    for (int i = 0; i < 8; ++i) vertices.emplace_back(corner + Vector3(i & 1, i >> 1 & 1, i >> 2));
    for (const auto& side : sides) {
      std::vector<VertexId> corners;
      for (const std::size_t i : side) corners.emplace_back(first + i);
      faces.push_back(corners);
    }
  }
  return build_mesh(std::move(vertices), std::move(faces));
}

std::vector<Scene> generated_scenes() {
  const Mesh cubes = block_of_cubes(20);
  return {{"closed surface", folded_sphere(100000), overview(), Sides::front},
          {"terrain", terrain(100000), grazing_view(), Sides::both},
          {"soup five deep", shrinking_soup(50000), view_into_box(), Sides::both},
          {"deep soup", deep_soup(5000), view_into_box(), Sides::both},
          {"sheets", sheets(20000, 8, FrontSheet::whole), view_into_box(), Sides::both},
          {"sheets behind leaves", sheets(20000, 8, FrontSheet::leaves), view_into_box(), Sides::both},
          {"block of 8000 cubes", cubes, camera_around(cubes), Sides::both}};
}

int run(int argc, char** argv) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  std::vector<TableRow> rows;
  for (int i = 1; i < argc; ++i) {
    Mesh mesh = read_obj(argv[i]).mesh;
    const Camera camera = camera_around(mesh);
    const std::string path = argv[i];
    rows.push_back(row_of({path.substr(path.find_last_of('/') + 1), std::move(mesh), camera, Sides::both}));
  }
  if (argc == 1) {
    for (const Scene& scene : generated_scenes()) rows.push_back(row_of(scene));
  }
  std::fputs(markdown_table({"scene", "facets", "crossing pairs", "pieces", "sweep", "view",
                             "cutting / view on the grid", "all / all with cutting", "exact answers, per mille"},
                            rows)
                 .c_str(),
             stdout);
  return 0;
}

}  // namespace
}  // namespace sightline::bench

int main(int argc, char** argv) {
  try {
    return sightline::bench::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
