#include "formats/reading/mesh_collector.h"

#include <cmath>
#include <limits>

#include "formats/reading/mesh_warnings.h"
#include "geometry/mesh/mesh_topology.h"

namespace sightline::inline formats {

namespace {

constexpr std::uint64_t most_ids = std::numeric_limits<std::uint32_t>::max();

bool is_finite(const Vector3& v) { return std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z()); }

// Gives each vertex that stays its new number, and removes the others.
std::vector<VertexId> keep_first_of_equals(std::vector<Point3>& vertices, std::vector<Vector3>& normals) {
  const std::vector<VertexId> first = weld_vertices(vertices).weld;
  std::vector<VertexId> number(vertices.size(), VertexId(0));
  std::size_t kept = 0;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (first[v].index() < v) {
      number[v] = number[first[v].index()];
      continue;
    }
    number[v] = VertexId(kept);
    vertices[kept] = vertices[v];
    if (!normals.empty()) normals[kept] = normals[v];
    ++kept;
  }
  vertices.resize(kept);
  if (!normals.empty()) normals.resize(kept);
  return number;
}

}  // namespace

void MeshCollector::require_memory(std::uint64_t vertices, std::uint64_t corners, std::uint64_t faces,
                                   const char* what_needs_it) const {
  // Normals count twice: so many are held while a list grows.
  const std::uint64_t of_normals = reads_normals_ ? 2 * sizeof(Vector3) * (vertices + corners) : 0;
  const std::uint64_t needed = memory_for_mesh(vertices, corners, faces) + of_normals;
  if (needed <= limits_.memory) return;
  in_.fail(std::string(what_needs_it) + " needs about " + std::to_string(needed) +
           " bytes of memory, and the limit is " + std::to_string(limits_.memory) + "; raise it with --max-memory");
}

void MeshCollector::expect(std::uint64_t vertices, std::uint64_t faces) const {
  if (vertices > most_ids || faces > most_ids / 3)
    in_.fail("a mesh of " + std::to_string(vertices) + " vertices and " + std::to_string(faces) +
             " faces is too large; divide it into meshes of at most " + std::to_string(most_ids / 3) + " faces");
  require_memory(vertices, 3 * faces, faces, "the mesh that is announced");
}

void MeshCollector::add_vertex(const Point3& position, const Vector3& normal) {
  if (!is_finite(position)) in_.fail("a coordinate is not finite; remove its vertex, or export the mesh again");
  if (reads_normals_ && !is_finite(normal)) in_.fail("a normal is not finite; export the mesh with other normals");
  if (vertices_.size() == most_ids) in_.fail("more than 4294967295 vertices; divide the mesh");
  vertices_.push_back(position);
  if (reads_normals_) normals_.push_back(normal);
  require_memory(vertices_.size(), faces_.corners.size(), faces_.size(), "the mesh up to here");
}

void MeshCollector::add_corner(std::int64_t index, std::uint64_t vertex_count) {
  if (index < 0 || static_cast<std::uint64_t>(index) >= vertex_count)
    in_.fail("a corner names vertex " + std::to_string(index) + " of " + std::to_string(vertex_count) +
             ", counted from 0; export the mesh again");
  if (corners_.size() == most_corners)
    in_.fail("a face of more than " + std::to_string(most_corners) + " corners; divide it");
  corners_.emplace_back(static_cast<std::size_t>(index));
}

void MeshCollector::end_face() {
  if (faces_.corners.size() + corners_.size() > most_ids) in_.fail("more than 4294967295 corners; divide the mesh");
  faces_.push_back(corners_);
  corners_.clear();
  require_memory(vertices_.size(), faces_.corners.size(), faces_.size(), "the mesh up to here");
}

void MeshCollector::weld() {
  const std::vector<VertexId> number = keep_first_of_equals(vertices_, normals_);
  for (VertexId& corner : faces_.corners) corner = number[corner.index()];
}

MeshFile MeshCollector::finish() && {
  MeshFile result;
  result.warnings = std::move(warnings_);
  if (reads_normals_) {
    result.corner_normals.reserve(faces_.corners.size());
    for (const VertexId v : faces_.corners) result.corner_normals.push_back(normals_[v.index()]);
    normals_ = {};
  }
  result.mesh = build_mesh(std::move(vertices_), std::move(faces_));
  warn_about_defects(result.mesh, in_.name(), result.warnings);
  warn_if_empty(result.mesh, in_.name(), result.warnings);
  return result;
}

void warn_about_rest(InputBytes& in, bool is_text, MeshCollector& mesh) {
  if (is_text ? in.only_blanks_left() : in.at_end()) return;
  mesh.warn("what follows the mesh is not read");
}

double coordinate_of(const InputBytes& in, std::string_view token) {
  if (token.empty()) in.fail_at_end();
  try {
    return parse_coordinate(token);
  } catch (const std::invalid_argument& error) {
    in.fail(std::string(error.what()) + "; correct it, or export the mesh again");
  }
}

std::uint64_t count_of(const InputBytes& in, std::string_view token, const std::string& what) {
  if (token.empty()) in.fail_at_end();
  const auto count = parse_integer(token);
  if (!count || *count < 0) in.fail(quoted(token) + " is no number of " + what + "; export the mesh again");
  return static_cast<std::uint64_t>(*count);
}

}  // namespace sightline::inline formats
