// These names are what points, edges and faces are called in a log.
//
// In:  a view, and the names of vertices and faces that a scene brings with it.
// Out: short names. A vertex without a name of its own is v and its number in the file, from 1; a corner that was
//      made by clipping, or by cutting along common lines, is m and a number; where several vertices fall on one
//      point the first of them names it. An edge is named by its ends, upper first. A crossing is x and a number, in
//      sweep order.
#pragma once

#include <string>
#include <vector>

#include "geometry/mesh/cut_mesh.h"
#include "geometry/projection/projected_scene.h"

namespace sightline::trace {

struct SceneNames {
  std::vector<std::string> vertices;   // by vertex; those beyond have none
  std::vector<std::string> faces;      // by face; those beyond are called by their number
  std::vector<std::string> crossings;  // in sweep order
};

[[nodiscard]] std::string name_of_vertex(VertexId v, const SceneNames& given);

// There is a name per point of the scene.
[[nodiscard]] std::vector<std::string> names_of_points(const ProjectedScene& scene, const SceneNames& given);
// There is a name per face.
[[nodiscard]] std::vector<std::string> names_of_faces(const CutMesh& mesh, const SceneNames& given);

[[nodiscard]] std::string name_of_crossing(std::size_t number, const SceneNames& given);

// Returns "OP", or "v1-v12" where a name is longer than a letter.
[[nodiscard]] std::string name_of_edge(const std::string& upper, const std::string& lower);

// Returns Fang's name of a 2D vertex: o for O, and d' for the second face that gets one at D.
[[nodiscard]] std::string name_of_emitted(const std::string& point, std::size_t earlier);

// Returns "a", "a and b", or "a, b and c".
[[nodiscard]] std::string listed(const std::vector<std::string>& words);

}  // namespace sightline::trace
