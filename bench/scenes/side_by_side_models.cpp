#include "bench/scenes/side_by_side_models.h"

#include <algorithm>
#include <utility>

#include "cli/system/resources.h"
#include "formats/reading/obj_reader.h"
#include "geometry/cutting/common_lines.h"
#include "geometry/cutting/interpenetration.h"
#include "geometry/mesh/box_hierarchy.h"
#include "geometry/projection/culling.h"
#include "sightline/analyzer.h"

namespace sightline::bench {
using namespace cli;
namespace {

namespace fs = std::filesystem;

// The camera sees all of it, from the front and a little above.
Camera camera_before(const Mesh& mesh) {
  Box box{mesh.vertices.front(), mesh.vertices.front()};
  for (const Point3& p : mesh.vertices) box = hull(box, {p, p});
  const Point3 middle = 0.5 * (box.low + box.high);
  const double size = norm(box.high - box.low);
  return perspective_camera("front", {middle + size * Vector3{0.2, 0.3, 1.5}, middle, {0, 1, 0}, 1, {}, {}}, 40);
}

BenchScene model_scene(const fs::path& file) {
  BenchScene scene;
  Mesh mesh = read_obj(file).mesh;
  scene.camera = camera_before(mesh);
  scene.file = file;
  const ProcessorTime watch;
  const Analyzer analyzer(std::move(mesh), {.precision = {}});
  scene.preparation = watch.seconds();
  scene.mesh = analyzer.shared_mesh();
  scene.sides = analyzer.sides(scene.camera).sides;
  return scene;
}

}  // namespace

std::vector<SceneMaker> model_makers() {
  const fs::path folder = fs::path(SIGHTLINE_SHARED_DIR) / "models";
  std::vector<fs::path> files;
  if (fs::exists(folder)) {
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (entry.path().extension() == ".obj") files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end(),
            [](const fs::path& a, const fs::path& b) { return fs::file_size(a) < fs::file_size(b); });
  std::vector<SceneMaker> makers;
  for (const fs::path& file : files) makers.push_back({file.stem().string(), [file] { return model_scene(file); }});
  return makers;
}

}  // namespace sightline::bench
