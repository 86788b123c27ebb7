// Watches the sweep: prints every sweep point, from the top of the window to its bottom, and what is done there.
//   sweep_watcher MESH.obj     (a parallel view along the z axis of what lies between (0, 0) and (16, 16))
#include <sightline/sightline.h>

#include <cstdlib>
#include <iostream>
#include <stdexcept>

using namespace sightline;

namespace {

class Watcher : public AnalysisHook, public SweepObserver {
 public:
  SweepObserver* sweep_observer() override { return this; }

  void on_point(const SweepPoint& point) override {
    std::cout << '(' << point.x << ", " << point.y << ')';
    if (point.vertex.valid()) std::cout << " a vertex";
    if (point.crossings > 0) std::cout << ' ' << point.crossings << " crossing edges";
    std::cout << '\n';
  }
};

// The engine that sweeps everything goes through the points in their order; the fast one takes parts of the scene.
void watch(const Mesh& mesh) {
  const Camera camera = orthographic_camera("page", {.eye = {8, 8, 10}, .target = {8, 8, 0}}, /*height=*/16);
  Watcher watcher;
  const Analyzer analyzer(mesh, {.sides = SidesPolicy::both, .engine = Engine::full, .hook = &watcher});
  const View view = analyzer.view(camera);
  std::cout << view.segments.segments.size() << " visible segments from " << view.segments.statistics.sweep_points
            << " sweep points\n";
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) throw std::invalid_argument("usage: sweep_watcher MESH.obj");
  watch(read_obj(std::filesystem::path(argv[1])).mesh);
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
