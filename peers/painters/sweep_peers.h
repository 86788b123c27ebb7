// The sweep itself, as peers of its own default: in float and double arithmetic, and on coarser grids of the image.
//
// Source: Sechrest and Greenberg 1982, Nurmi 1985, Fang 1993. Precision: object. Cost: O((n + k) log n) for n edges and
// k crossings; projection is part of it here, since the arithmetic and the grid begin there.
// Cannot: on a grid of b bits tell points apart that are nearer to each other than 2^-b of half the window; in float or
// double promise to end with a result at all.
#pragma once

#include "peers/scene/peer.h"

namespace sightline::peers {

// Returns the three arithmetics on the grid of 40 bits, then exact arithmetic on grids of 32, 24, 16, 12 and 8.
[[nodiscard]] std::vector<Peer> sweep_peers();

}  // namespace sightline::peers
