// Vertices and faces are collected here as a file gives them, checked, and become a mesh.
//
// In:  vertices, and faces as indices of vertices that the file has announced.
// Out: a MeshFile with the warnings that every reader gives.
// Errors: InputError, at the place that the InputBytes have reached: a coordinate that is not finite, an index that names
//         no vertex, more corners than a face may have, more of anything than ids or the limit on memory allow.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "formats/reading/input_bytes.h"
#include "formats/reading/mesh_file.h"
#include "formats/reading/read_limits.h"

namespace sightline::inline formats {

class MeshCollector {
 public:
  MeshCollector(const InputBytes& in, const ReadLimits& limits, Normals normals)
      : in_(in), limits_(limits), reads_normals_(normals == Normals::read) {}

  // Refuses before anything is held of it a mesh that is announced to be larger than the limits allow; a face counts as
  // a triangle.
  void expect(std::uint64_t vertices, std::uint64_t faces) const;

  void add_vertex(const Point3& position, const Vector3& normal = Vector3::Zero());

  // Vertices count from 0. A face may name vertices that follow, out of those that are announced.
  void add_corner(std::int64_t index, std::uint64_t vertex_count);
  void end_face();

  void warn(const std::string& what) { warnings_.push_back(in_.name() + ": " + what); }

  // Makes vertices with equal positions one: the first of them. 0 and -0 are equal.
  void weld();
  // Everything is at the end of its file.
  [[nodiscard]] MeshFile finish() &&;

 private:
  void require_memory(std::uint64_t vertices, std::uint64_t corners, std::uint64_t faces,
                      const char* what_needs_it) const;

  const InputBytes& in_;
  const ReadLimits limits_;
  const bool reads_normals_;
  std::vector<Point3> vertices_;
  std::vector<Vector3> normals_;  // where asked for: parallel to vertices_
  PolygonList faces_;
  std::vector<VertexId> corners_;  // of the face that is being read
  std::vector<std::string> warnings_;
};

// Warns where something other than blanks follows the mesh.
void warn_about_rest(InputBytes& in, bool is_text, MeshCollector& mesh);

// Returns the token as a coordinate, or as a count. `what` names it in a message.
[[nodiscard]] double coordinate_of(const InputBytes& in, std::string_view token);
[[nodiscard]] std::uint64_t count_of(const InputBytes& in, std::string_view token, const std::string& what);

}  // namespace sightline::inline formats
