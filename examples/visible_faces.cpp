// Which faces of an OBJ file does a camera see? Prints those that it sees, and how much of the window each fills.
//   visible_faces MESH.obj EYE_X EYE_Y EYE_Z TARGET_X TARGET_Y TARGET_Z
#include <sightline/sightline.h>

#include <cstdlib>
#include <iostream>
#include <map>
#include <string>
#include <vector>

using namespace sightline;

namespace {

// Returns shares of the window [-1, 1]^2, whose area is 4.
std::map<FaceId, double> visible_shares(const VisiblePolygons& visible) {
  std::map<FaceId, double> shares;
  for (const VisiblePolygon& polygon : visible.polygons) {
    if (!polygon.below_resolution) shares[polygon.face] += polygon.area / 4;
  }
  return shares;
}

void print_visible_faces(const std::string& file, const ViewPoint& view) {
  const MeshFile obj = read_obj(file);
  for (const std::string& warning : obj.warnings) std::cerr << warning << '\n';

  // Faces that pass through each other are cut along their common lines here, once for all cameras.
  const Analyzer analyzer(obj.mesh);
  const View seen = analyzer.view(perspective_camera("camera", view, 25));

  const std::map<FaceId, double> shares = visible_shares(seen.polygons);
  for (const auto& [face, share] : shares) std::cout << "face " << face.value << " fills " << share << '\n';
  std::cout << shares.size() << " of " << analyzer.mesh().face_count() << " faces are seen\n";
}

}  // namespace

int main(int argc, char** argv) try {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() != 7) throw std::invalid_argument("usage: visible_faces MESH.obj, eye and target: six numbers");
  const auto number = [&](std::size_t i) { return std::stod(words[i]); };
  print_visible_faces(words[0],
                      {.eye = {number(1), number(2), number(3)}, .target = {number(4), number(5), number(6)}});
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
