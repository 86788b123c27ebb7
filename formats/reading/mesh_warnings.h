// What readers of any format have to say of the mesh that they made.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "geometry/mesh/mesh.h"

namespace sightline::inline formats {

// Returns a list like "3, 7, 12", of at most ten of them.
[[nodiscard]] std::string id_list(std::span<const FaceId> faces);

// Returns "1 face", "2 faces".
[[nodiscard]] std::string counted(std::size_t count, const std::string& noun);

// Adds a line for each kind of defect with the faces that have it, and one if no face is left.
void warn_about_defects(const Mesh& mesh, const std::string& name, std::vector<std::string>& warnings);
void warn_if_empty(const Mesh& mesh, const std::string& name, std::vector<std::string>& warnings);

}  // namespace sightline::inline formats
