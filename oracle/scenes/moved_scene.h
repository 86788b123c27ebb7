// Scenes of a lattice, moved off it.
//
// In:  a scene. Out: its mesh, moved; the same in every run.
// A small turn leaves nothing on the lattice; a last bit leaves everything nearly on it; and parts of a spacing of the image's
// grid leave everything as far off it as rounding moves it.
#pragma once

#include <array>

#include "oracle/scenes/random_scenes.h"

namespace sightline::lattice {

enum class Moved { not_at_all, turned, by_last_bits, by_parts_of_spacings };
inline constexpr std::array every_move{Moved::not_at_all, Moved::turned, Moved::by_last_bits,
                                       Moved::by_parts_of_spacings};

[[nodiscard]] Mesh moved(const RandomScene& scene, Moved how);

}  // namespace sightline::lattice
