#include "peers/peer_list.h"

#include <utility>

#include "peers/appel.h"
#include "peers/back_face_culling.h"
#include "peers/bsp_tree.h"
#include "peers/depth_sort.h"
#include "peers/every_pair.h"
#include "peers/floating_horizon.h"
#include "peers/koucky.h"
#include "peers/ray_casting.h"
#include "peers/sweep_peers.h"
#include "peers/warnock.h"
#include "peers/watkins.h"
#include "peers/z_buffer.h"

namespace sightline::peers {

std::vector<Peer> all_peers() {
  std::vector<Peer> all{back_face_culling(), z_buffer(),   ray_casting(), depth_sort(), bsp_tree(),        warnock(),
                        watkins(),           every_pair(), koucky(),      appel(),      floating_horizon()};
  for (Peer& sweep : sweep_peers()) all.push_back(std::move(sweep));
  return all;
}

}  // namespace sightline::peers
