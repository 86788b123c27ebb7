#include "tests/tools/model_shots.h"

#include <algorithm>
#include <cstdlib>

namespace sightline::tests {

namespace fs = std::filesystem;

namespace {

struct Box {
  Point3 low = Point3::Zero();
  Point3 high = Point3::Zero();
};

Box box_of(const Mesh& mesh) {
  Box box{mesh.vertices.front(), mesh.vertices.front()};
  for (const Point3& p : mesh.vertices) {
    box.low = {std::min(box.low.x(), p.x()), std::min(box.low.y(), p.y()), std::min(box.low.z(), p.z())};
    box.high = {std::max(box.high.x(), p.x()), std::max(box.high.y(), p.y()), std::max(box.high.z(), p.z())};
  }
  return box;
}

}  // namespace

fs::path models_folder() {
  const char* wanted = std::getenv("SIGHTLINE_SHARED");
  return fs::path(wanted != nullptr ? wanted : SIGHTLINE_SHARED_DIR) / "models";
}

std::vector<fs::path> models() {
  std::vector<fs::path> result;
  if (!fs::exists(models_folder())) return result;
  for (const auto& entry : fs::directory_iterator(models_folder())) {
    if (entry.path().extension() == ".obj") result.push_back(entry.path());
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<fs::path> near_degenerate_scenes() {
  std::vector<fs::path> result;
  const fs::path folder = models_folder().parent_path() / "near-degenerate";
  if (!fs::is_directory(folder)) return result;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.is_directory()) result.push_back(entry.path() / "s.toml");
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<Shot> shots(const Mesh& mesh) {
  const Box box = box_of(mesh);
  const Point3 centre = 0.5 * (box.low + box.high);
  const Vector3 extent = box.high - box.low;
  const double size = norm(extent);
  const auto view = [&](const Vector3& from) {
    ViewPoint v;
    v.eye = centre + from;
    v.target = centre;
    return v;
  };
  return {{perspective_camera("front", view(size * Vector3{0.2, 0.3, 1.5}), 40), Sides::both},
          {perspective_camera("close", view({0.3 * extent.x(), 0.2 * extent.y(), 0.4 * extent.z()}), 70), Sides::both},
          {orthographic_camera("diagonal", view(size * Vector3{1, 0.8, 0.6}), 0.7 * size), Sides::front}};
}

}  // namespace sightline::tests
