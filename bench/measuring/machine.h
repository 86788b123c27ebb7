// On what was measured: the processor as Linux names it, and the compiler.
//
// Out: a line of text. Complexity: O(1). Errors: none; what is not known is left out.
#pragma once

#include <string>

namespace sightline::bench {

[[nodiscard]] std::string machine_line();

}  // namespace sightline::bench
