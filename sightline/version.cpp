#include "sightline/version.h"

namespace sightline {

const char* version() { return SIGHTLINE_VERSION; }

}  // namespace sightline
