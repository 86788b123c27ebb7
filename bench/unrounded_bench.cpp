// All that a view takes without rounding and without cutting, beside the same on the grid, where what passes through itself
// is cut first. Prints the tables of docs/unrounded.md.
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

#include "bench/measuring/least_seconds.h"
#include "bench/measuring/markdown_table.h"
#include "bench/scenes/crossing_meshes.h"
#include "bench/scenes/generated_scenes.h"
#include "formats/reading/obj_reader.h"
#include "geometry/cutting/common_lines.h"
#include "geometry/cutting/interpenetration.h"
#include "geometry/mesh/box_hierarchy.h"
#include "reconstruct/labelling/labelled_mesh.h"
#include "sweep/engine.h"
#include "sweep/unrounded/unrounded_sweep.h"

namespace sightline::bench {
namespace {

struct Scene {
  std::string name;
  Mesh mesh;
  Camera camera;
  Sides sides = Sides::both;
};

// From the mesh to the labelled surface, as the command does it.
struct ViewTimes {
  double view = 0;
  double full_sweep = 0;
  std::size_t triangles = 0;
  UnroundedCounts counts;
};

ViewTimes times_of(const std::shared_ptr<const CutMesh>& mesh, const Scene& scene, Arithmetic arithmetic) {
  ViewTimes times;
  ProjectedScene projected;
  times.view = least_seconds([&] {
    projected = project(mesh, scene.camera, scene.sides, {arithmetic});
    const VisibleSegments segments = find_visible_segments(projected);
    const VisiblePolygons polygons = reconstruct_polygons(projected, segments);
    times.triangles = label_mesh(projected, segments, polygons).triangles.size();
  });
  times.full_sweep = least_seconds([&] {
    const std::vector<DepthRange> depths = depth_ranges(projected);
    (void)(projected.is_unrounded() ? unrounded_sweep(projected, depths, nullptr, &times.counts)
                                    : plain_sweep(projected, depths, nullptr));
  });
  return times;
}

// The time that a triangle of a closed surface takes.
double seconds_of_clean_triangle() {
  const Scene clean{"", folded_sphere(100000), overview(), Sides::front};
  const auto mesh = std::make_shared<const CutMesh>(uncrossed(clean.mesh));
  return times_of(mesh, clean, Arithmetic::unrounded).view / static_cast<double>(mesh->facet_count());
}

TableRow row_of(const Scene& scene, double clean_triangle) {
  std::shared_ptr<const CutMesh> cut;
  const auto uncut = std::make_shared<const CutMesh>(uncrossed(scene.mesh));
  const cli::ProcessorTime watch;
  cut = std::make_shared<const CutMesh>(cut_along_common_lines(scene.mesh, find_contacts(scene.mesh)));
  const double cutting = watch.seconds();
  const ViewTimes grid = times_of(cut, scene, Arithmetic::exact);
  const ViewTimes unrounded = times_of(uncut, scene, Arithmetic::unrounded);
  const UnroundedCounts& counts = unrounded.counts;
  const auto asked = static_cast<double>(counts.sides + counts.turns);
  const auto exact = static_cast<double>(counts.exact_sides + counts.exact_turns + counts.exact_orders);
  const auto facets = static_cast<double>(scene.mesh.facet_count());
  return {scene.name,
          std::to_string(scene.mesh.facet_count()),
          std::to_string(cut->cuts.crossing.size()),
          number("%.2f", unrounded.full_sweep / grid.full_sweep),
          number("%.2f", unrounded.view / grid.view),
          number("%.3f", unrounded.view / (cutting + grid.view)),
          number("%.2f", unrounded.view / facets / clean_triangle),
          number("%.2f", static_cast<double>(unrounded.triangles) / static_cast<double>(grid.triangles)),
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

Scene seen_from_around(const std::string& name, Mesh mesh) {
  const Camera camera = camera_around(mesh);
  return {name, std::move(mesh), camera, Sides::both};
}

// One after the other, since they are large.
template <class Visit>
void for_each_generated(Visit visit) {
  visit({"closed surface", folded_sphere(100000), overview(), Sides::front});
  visit({"terrain", terrain(100000), grazing_view(), Sides::both});
  visit({"soup five deep", shrinking_soup(50000), view_into_box(), Sides::both});
  visit({"deep soup", deep_soup(5000), view_into_box(), Sides::both});
  visit({"sheets", sheets(20000, 8, FrontSheet::whole), view_into_box(), Sides::both});
  visit({"sheets behind leaves", sheets(20000, 8, FrontSheet::leaves), view_into_box(), Sides::both});
  visit(seen_from_around("(viii) touching cubes", block_of_cubes(96000)));
  visit(seen_from_around("(ix) crossing leaves, few", crossing_leaves(1000)));
  visit(seen_from_around("(ix) crossing leaves", crossing_leaves(4000)));
  visit(seen_from_around("(x) bolted plates, few", bolted_plates(10000)));
  visit(seen_from_around("(x) bolted plates", bolted_plates(100000)));
  visit(seen_from_around("(xi) thin triangles, few", thin_sphere(10000)));
  visit(seen_from_around("(xi) thin triangles", thin_sphere(100000)));
  visit(seen_from_around("furnished hall", furnished_hall(30000)));
}

int run(int argc, char** argv) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const double clean_triangle = seconds_of_clean_triangle();
  std::vector<TableRow> rows;
  const auto add = [&](const Scene& scene) { rows.push_back(row_of(scene, clean_triangle)); };
  for (int i = 1; i < argc; ++i) {
    const std::string path = argv[i];
    add(seen_from_around(path.substr(path.find_last_of('/') + 1), read_obj(argv[i]).mesh));
  }
  if (argc == 1) for_each_generated(add);
  std::fputs(markdown_table({"scene", "facets", "crossing pairs", "sweep of everything", "view", "with cutting",
                             "per triangle", "output", "exact answers, per mille"},
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
