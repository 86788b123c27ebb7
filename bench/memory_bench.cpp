// Peak memory of each stage of one view, beside the counts it may depend on: a line of CSV per input.
//
//     build/release/bench/sightline_memory MODEL.obj...      (without a model: generated scenes)
//
// The constants of cli/analyze/memory_estimate.cpp come from here. A stage's peak is VmHWM, reset before it (Linux).

#include <cstdio>
#include <functional>
#include <string>

#include "bench/scenes/generated_scenes.h"
#include "cli/results/face_measures.h"
#include "cli/system/process_memory.h"
#include "formats/reading/obj_reader.h"
#include "formats/writing/labelled_obj.h"
#include "formats/writing/labelled_ply.h"
#include "formats/writing/segments_table.h"
#include "formats/writing/view_svg.h"
#include "formats/writing/window_points.h"
#include "geometry/cutting/interpenetration.h"
#include "geometry/mesh/box_hierarchy.h"
#include "sightline/analyze.h"

namespace sightline::bench {
using namespace cli;
namespace {

// The peak while `work` runs, with all that was there before.
std::size_t peak_of(const std::function<void()>& work) {
  reset_peak();
  work();
  return peak_bytes();
}

// A camera from a corner of the room, at the middle of the bounding box.
Camera camera_for(const Mesh& mesh) {
  Box box{mesh.vertices.front(), mesh.vertices.front()};
  for (const Point3& p : mesh.vertices) box = hull(box, {p, p});
  const Vector3 middle = 0.5 * (box.low + box.high);
  const double size = norm(box.high - box.low);
  return perspective_camera("view", {middle + size * Vector3{0.6, 0.4, 0.8}, middle, {0, 1, 0}, 1, {}, {}}, 60);
}

std::size_t write_all(const Mesh& mesh, const View& view) {
  const std::vector<Point2> places = window_points(view);
  std::size_t length = 0;
  TextBuffer out([&](std::string_view piece) { length += piece.size(); });
  write_labelled_ply(view.labelled, {}, out);
  write_labelled_obj(view.labelled, {}, out);
  write_view_svg(mesh, view, places, {}, out);
  write_segments_table(mesh, view, places, out);
  out.flush();
  return length;
}

void measure(const std::string& name, const std::function<Mesh()>& make) {
  Mesh mesh;
  MeshContacts contacts;
  View view;
  const std::size_t build = peak_of([&] { mesh = make(); });
  const std::size_t touch = peak_of([&] { contacts = find_contacts(mesh); });
  const Camera camera = camera_for(mesh);
  const std::size_t project_peak = peak_of([&] { view.scene = project(mesh, camera, Sides::both); });
  const std::size_t sweep_peak = peak_of([&] { view.segments = find_visible_segments(mesh, view.scene); });
  const std::size_t polygons = peak_of([&] { view.polygons = reconstruct_polygons(mesh, view.scene, view.segments); });
  const std::size_t label =
      peak_of([&] { view.labelled = label_mesh(mesh, view.scene, view.segments, view.polygons); });
  const std::size_t write = peak_of([&] { (void)write_all(mesh, view); });
  std::printf("%s,%zu,%zu,%zu,%zu,%zu,%zu,%zu,%zu,%zu,%zu,%zu,%zu,%zu,%zu,%zu,%zu,%zu,%zu\n", name.c_str(),
              mesh.vertices.size(), mesh.faces.corners.size(), mesh.facet_count(), mesh.edges.size(),
              contacts.touching.size() + contacts.crossing.size(), view.scene.points.size(), view.scene.edge_count(),
              view.segments.statistics.crossings, view.segments.crossings.size(), view.segments.segments.size(),
              view.labelled.triangles.size(), build, touch, project_peak, sweep_peak, polygons, label, write);
}

}  // namespace
}  // namespace sightline::bench

int main(int argc, char** argv) {
  using namespace sightline;
  std::puts(
      "name,vertices,corners,facets,mesh edges,contacts,points,edges,crossings,kept crossings,segments,triangles,build,"
      "contacts peak,project,sweep,reconstruct,label,write");
  for (int i = 1; i < argc; ++i) bench::measure(argv[i], [&] { return read_obj(std::filesystem::path(argv[i])).mesh; });
  for (const std::size_t size : argc > 1 ? std::vector<std::size_t>{} : std::vector<std::size_t>{10000, 100000}) {
    bench::measure("sphere", [&] { return bench::folded_sphere(size); });
    bench::measure("terrain", [&] { return bench::terrain(size); });
  }
}
