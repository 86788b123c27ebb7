// Which faces mirror a light panel into a camera? Prints the area that reflects it, face by face.
//   panel_reflections MESH.obj     (the camera and the panel below suit a vase of height 2 that stands at the origin)
#include <sightline/sightline.h>

#include <array>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <vector>

using namespace sightline;

namespace {

Panel window_on_the_left() { return {"window", {{-4, 0, 1}, {-4, 0, 4}, {-4, 3.5, 4}, {-4, 3.5, 1}}, Emits::both}; }

Camera camera_in_front() { return perspective_camera("front", {.eye = {1.6, 3.6, 4.6}, .target = {0, 1, 0}}, 25); }

// A labelled triangle mirrors all of the panel's bit or nothing of it, so what reflects is a union of triangles.
Coverage reflected(const Mesh& mesh) {
  const Analyzer analyzer(mesh);
  const View view = analyzer.view(camera_in_front(), {window_on_the_left()});
  const std::array seen{seen_part(view.labelled)};
  return cover(analyzer.mesh(), seen, 1);
}

void print_reflections(const Mesh& mesh) {
  const Coverage coverage = reflected(mesh);
  for (std::size_t face = 0; face < coverage.faces.size(); ++face) {
    const FaceCoverage& areas = coverage.faces[face];
    if (areas.reflecting == 0) continue;
    std::cout << "face " << face << " reflects " << areas.reflecting << " of " << areas.area << '\n';
  }
  std::cout << "together " << coverage.together.any_panel << " of " << coverage.together.visible << " that are seen\n";
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) throw std::invalid_argument("usage: panel_reflections MESH.obj");
  print_reflections(read_obj(std::filesystem::path(argv[1])).mesh);
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
