// A scene chosen by bytes: any faces at all on a lattice, unlike the random scenes of oracle/scenes, which keep promises.
//
// In:  any bytes. Out: a scene of at most eight faces; what its corners are is in the bytes, what its camera is in the
//      first two of them. Faces may be degenerate, repeat each other, and pass through each other.
#pragma once

#include <string_view>

#include "oracle/scenes/moved_scene.h"

namespace sightline::fuzz {

[[nodiscard]] lattice::RandomScene chosen_scene(std::string_view bytes);

// Returns how the scene is to be moved off its lattice: that is in the number of the bytes.
[[nodiscard]] inline lattice::Moved move_of(std::string_view bytes) {
  return lattice::every_move[bytes.size() % lattice::every_move.size()];
}

}  // namespace sightline::fuzz
