// The surface of a scene: its meshes read, placed and put together, without what is ignored; and the faces that are chosen by
// region.
//
// In:  what a scene file says (scene_file.h). Out: the surface, with what reading it has to say.
// Errors: InputError (see the readers, region_choice.h), PlacementError.
#pragma once

#include "cli/analyze/region_choice.h"
#include "cli/analyze/view_analysis.h"
#include "cli/scene/scene_file.h"
#include "formats/reading/read_limits.h"

namespace sightline::cli {

[[nodiscard]] MeshInput read_surface(const SceneDescription& scene, Normals normals, std::uint64_t max_memory,
                                     Progress& progress);

}  // namespace sightline::cli
