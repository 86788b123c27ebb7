#include "bench/scenes/obj_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

namespace sightline::bench {
namespace {

std::string obj_text(const PolygonMesh& mesh) {
  std::string text;
  for (const Point3& p : mesh.vertices)
    fmt::format_to(std::back_inserter(text), "v {:.9g} {:.9g} {:.9g}\n", p.x(), p.y(), p.z());
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    text += 'f';
    for (const VertexId corner : mesh.faces[f]) fmt::format_to(std::back_inserter(text), " {}", corner.index() + 1);
    text += '\n';
  }
  return text;
}

}  // namespace

TemporaryObj::TemporaryObj(const PolygonMesh& mesh)
    : path_(std::filesystem::temp_directory_path() / fmt::format("sightline-{}.obj", getpid())) {
  std::ofstream file(path_, std::ios::binary);
  file << obj_text(mesh);
  if (!file.flush()) throw std::runtime_error(path_.string() + " cannot be written");
}

TemporaryObj::~TemporaryObj() {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

}  // namespace sightline::bench
