// In the place of the pages, where they could not be bundled.
#include "cli/pages/page_template.h"

namespace sightline::cli {

std::span<const char* const> page_pieces(PageName) { return {}; }

}  // namespace sightline::cli
