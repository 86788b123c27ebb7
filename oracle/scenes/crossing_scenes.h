// Random scenes whose faces pass through each other.
//
// In:  a seed (the same on every machine). Out: a scene of 3 to 8 faces, made of the shapes of random_scenes.h and of
//      faces made to cross.
// Holds: every corner of a face's image, clipped ones included, is exactly on the grid of the image; no face repeats
//      another, and none is degenerate.
// Wanted: common lines whose ends are on the image's grid. Where nearness (1 / W of a pinhole, minus the depth
//      otherwise) is the same in the middle of two faces that are mirrored there, the common line goes through the
//      middle of their edges in the image; depths that are powers of two make that a grid point. So faces are laid
//      through a few centres, with a near and a far side that exchange: several through one line, three through one
//      point, some whose common line ends on edges of both.
#pragma once

#include "oracle/scenes/random_scenes.h"

namespace sightline::lattice {

[[nodiscard]] RandomScene crossing_scene(std::uint64_t seed);

}  // namespace sightline::lattice
