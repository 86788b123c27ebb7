#include "peers/peer_list.h"

#include <utility>

#include "peers/lines/appel.h"
#include "peers/lines/floating_horizon.h"
#include "peers/painters/back_face_culling.h"
#include "peers/painters/bsp_tree.h"
#include "peers/painters/depth_sort.h"
#include "peers/painters/every_pair.h"
#include "peers/painters/koucky.h"
#include "peers/painters/sweep_peers.h"
#include "peers/pixels/ray_casting.h"
#include "peers/pixels/warnock.h"
#include "peers/pixels/watkins.h"
#include "peers/pixels/z_buffer.h"

namespace sightline::peers {

std::vector<Peer> all_peers() {
  std::vector<Peer> all{back_face_culling(), z_buffer(),   ray_casting(), depth_sort(), bsp_tree(),        warnock(),
                        watkins(),           every_pair(), koucky(),      appel(),      floating_horizon()};
  for (Peer& sweep : sweep_peers()) all.push_back(std::move(sweep));
  return all;
}

}  // namespace sightline::peers
