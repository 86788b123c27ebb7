#include "trace/names.h"

#include <algorithm>

namespace sightline::trace {

namespace {

bool is_capital(const std::string& name) { return name.size() == 1 && name[0] >= 'A' && name[0] <= 'Z'; }

}  // namespace

std::string name_of_vertex(VertexId v, const SceneNames& given) {
  return v.index() < given.vertices.size() ? given.vertices[v.index()] : "v" + std::to_string(v.index() + 1);
}

std::vector<std::string> names_of_points(const ProjectedScene& scene, const SceneNames& given) {
  const CutMesh& mesh = scene.mesh();
  std::vector<VertexId> vertices(scene.points.size());
  for (const ClippedCorner& corner : scene.polygon_corners) {
    VertexId& first = vertices[corner.point.index()];
    first = std::min(first, corner.vertex);
  }
  std::vector<std::string> names;
  std::size_t made = 0;
  for (const VertexId v : vertices) {
    const bool of_input = v.valid() && v.index() < mesh.input_vertex_count();
    names.push_back(of_input ? name_of_vertex(v, given) : "m" + std::to_string(++made));
  }
  return names;
}

std::vector<std::string> names_of_faces(const CutMesh& mesh, const SceneNames& given) {
  std::vector<std::string> names = given.faces;
  for (std::size_t f = names.size(); f < mesh.face_count(); ++f) names.push_back(std::to_string(f));
  return names;
}

std::string name_of_crossing(std::size_t number, const SceneNames& given) {
  return number < given.crossings.size() ? given.crossings[number] : "x" + std::to_string(number + 1);
}

std::string name_of_edge(const std::string& upper, const std::string& lower) {
  return upper + (is_capital(upper) && is_capital(lower) ? "" : "-") + lower;
}

std::string name_of_emitted(const std::string& point, std::size_t earlier) {
  std::string name = point;
  if (is_capital(point)) name[0] = static_cast<char>(name[0] - 'A' + 'a');
  return name + std::string(earlier, '\'');
}

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? " and " : ", ";
    text += words[i];
  }
  return text;
}

}  // namespace sightline::trace
