// Warnings about normals: what they make of reflections may not be what their owner means.
//
// In:  a mesh, the normals of its file, the options of reflections that use them.
// Out: a line per doubt (vertex_normals.h), which ends with what to do.
#pragma once

#include <string>
#include <vector>

#include "geometry/mesh/mesh.h"
#include "reflect/world/reflection_options.h"

namespace sightline::cli {

[[nodiscard]] std::vector<std::string> normal_warnings(const PolygonMesh& mesh, const std::vector<Vector3>& given,
                                                       const ReflectionOptions& options);

}  // namespace sightline::cli
