// How much of a surface do several cameras see, each for itself and together? Cameras stand in a circle around it.
//   camera_coverage MESH.obj COUNT
#include <sightline/sightline.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

using namespace sightline;

namespace {

Camera camera_on_circle(std::size_t i, std::size_t count) {
  const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
  const Point3 eye{6 * std::cos(angle), 3, 6 * std::sin(angle)};
  return perspective_camera("camera " + std::to_string(i), {.eye = eye, .target = {0, 1, 0}}, 30);
}

// Of a view only what is seen is kept: a surface that was seen by a thousand cameras needs no thousand surfaces.
std::vector<SeenPart> seen_from_circle(const Analyzer& analyzer, std::size_t count) {
  std::vector<SeenPart> seen;
  for (std::size_t i = 0; i < count; ++i) seen.push_back(seen_part(analyzer.view(camera_on_circle(i, count)).labelled));
  return seen;
}

void print_coverage(const Analyzer& analyzer, std::size_t camera_count) {
  const Coverage coverage = cover(analyzer.mesh(), seen_from_circle(analyzer, camera_count), 0);
  const auto percent = [&](double area) { return 100 * area / coverage.area; };
  for (std::size_t i = 0; i < camera_count; ++i) {
    std::cout << "camera " << i << " sees " << percent(coverage.cameras[i].visible) << " % of the surface\n";
  }
  std::cout << "together they see " << percent(coverage.together.visible) << " %\n";
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 3) throw std::invalid_argument("usage: camera_coverage MESH.obj COUNT");
  print_coverage(Analyzer(read_obj(std::filesystem::path(argv[1])).mesh), std::stoul(argv[2]));
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
