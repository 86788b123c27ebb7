#include "trace/sweep_log.h"

namespace sightline::trace {

const char* to_string(PointKind kind) {
  switch (kind) {
    case PointKind::top:
      return "top";
    case PointKind::side:
      return "side";
    case PointKind::bottom:
      return "bottom";
    case PointKind::crossing:
      return "crossing";
  }
  return "";
}

}  // namespace sightline::trace
