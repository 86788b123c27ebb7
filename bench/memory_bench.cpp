// This prints the peak memory of each stage of one view, beside the counts it may depend on: a line of CSV per input.
//
//     build/release/bench/sightline_memory MODEL.obj...      (without a model: generated scenes)
//
// The constants of cli/analyze/memory_estimate.cpp come from here. A stage's peak is VmHWM, reset before it (Linux).

#include <cstdio>
#include <functional>
#include <string>

#include "bench/scenes/generated_scenes.h"
#include "cli/results/face_measures.h"
#include "cli/system/resources.h"
#include "formats/reading/obj_reader.h"
#include "formats/writing/labelled_obj.h"
#include "formats/writing/labelled_ply.h"
#include "formats/writing/segments_table.h"
#include "formats/writing/view_svg.h"
#include "formats/writing/window_points.h"
#include "geometry/cutting/interpenetration.h"
#include "geometry/mesh/box_hierarchy.h"
#include "sightline/analyzer.h"

namespace sightline::bench {
using namespace cli;
namespace {

// Returns the peak while `work` runs, with all that was there before.
std::size_t peak_of(const std::function<void()>& work) {
  reset_peak();
  work();
  return peak_bytes();
}

// The peak of each stage, with all that was there before.
class StagePeaks : public AnalysisHook {
 public:
  void begins(Stage /*stage*/) override { reset_peak(); }
  void ended(Stage stage, double /*seconds*/) override { peaks_[static_cast<std::size_t>(stage)] = peak_bytes(); }
  [[nodiscard]] std::size_t of(Stage stage) const { return peaks_[static_cast<std::size_t>(stage)]; }

 private:
  std::array<std::size_t, 8> peaks_{};
};

// The camera looks from a corner of the room at the middle of the bounding box.
Camera camera_for(const Mesh& mesh) {
  Box box{mesh.vertices.front(), mesh.vertices.front()};
  for (const Point3& p : mesh.vertices) box = hull(box, {p, p});
  const Vector3 middle = 0.5 * (box.low + box.high);
  const double size = norm(box.high - box.low);
  return perspective_camera("view", {middle + size * Vector3{0.6, 0.4, 0.8}, middle, {0, 1, 0}, 1, {}, {}}, 60);
}

std::size_t write_all(const View& view) {
  const std::vector<Point2> places = window_points(view);
  std::size_t length = 0;
  TextBuffer out([&](std::string_view piece) { length += piece.size(); });
  write_labelled_ply(view.labelled, {}, out);
  write_labelled_obj(view.labelled, {}, out);
  write_view_svg(view, places, {}, out);
  write_segments_table(view, places, out);
  out.flush();
  return length;
}

void measure(const std::string& name, const std::function<Mesh()>& make) {
  Mesh mesh;
  MeshContacts contacts;
  const std::size_t build = peak_of([&] { mesh = make(); });
  const std::size_t touch = peak_of([&] { contacts = find_contacts(mesh); });
  const Camera camera = camera_for(mesh);
  StagePeaks peaks;
  const auto surface = std::make_shared<const CutMesh>(uncrossed(std::move(mesh)));
  const View view = Analyzer(surface, {.sides = SidesPolicy::both, .hook = &peaks}).view(camera);
  const std::size_t write = peak_of([&] { (void)write_all(view); });
  std::printf("%s,%zu,%zu,%zu,%zu,%zu,%zu,%zu,%zu,%zu,%zu,%zu,%zu,%zu,%zu,%zu,%zu,%zu,%zu\n", name.c_str(),
              surface->vertices.size(), surface->faces.corners.size(), surface->facet_count(), surface->edges.size(),
              contacts.touching.size() + contacts.crossing.size(), view.scene.points.size(), view.scene.edge_count(),
              view.segments.statistics.crossings, view.segments.crossings.size(), view.segments.segments.size(),
              view.labelled.triangles.size(), build, touch, peaks.of(Stage::project), peaks.of(Stage::sweep),
              peaks.of(Stage::reconstruct), peaks.of(Stage::label), write);
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
