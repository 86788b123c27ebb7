// Every peer is here, in the order in which a course would meet them.
#pragma once

#include <vector>

#include "peers/scene/peer.h"

namespace sightline::peers {

// Names are distinct.
[[nodiscard]] std::vector<Peer> all_peers();

}  // namespace sightline::peers
