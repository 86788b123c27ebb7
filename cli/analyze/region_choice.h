// The faces of the regions that a scene file names.
//
// In:  the regions of a surface, and a choice of some of them: by name, or by what their material is. A name is that of a mesh,
//      object, group or material, or of all of them that are called so; MESH/NAME is the one in that mesh, KIND:NAME the one of
//      that kind (object:body).
// Out: per face 1 where it is in one of them. No region without a name is meant by any name.
// Errors: InputError with the scene file and line: a name that no region has, with at most ten of those that there are; materials
//      of which none fits.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/scene/scene_mesh.h"
#include "formats/reading/face_regions.h"

namespace sightline::cli {

using FaceMask = std::vector<std::uint8_t>;

[[nodiscard]] FaceMask faces_of(const FaceRegions& regions, const RegionChoice& choice, const std::string& scene_file);
[[nodiscard]] FaceMask faces_of(const FaceRegions& regions, const MaterialChoice& choice,
                                const std::string& scene_file);

}  // namespace sightline::cli
