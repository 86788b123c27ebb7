// The meshes of ../shared/models, prepared as the command prepares them.
//
// Out: makers, by the size of the files, ascending; none where the folder is not there.
// Complexity, errors: see side_by_side_scenes.h.
#pragma once

#include <vector>

#include "bench/scenes/side_by_side_scenes.h"

namespace sightline::bench {

[[nodiscard]] std::vector<SceneMaker> model_makers();

}  // namespace sightline::bench
