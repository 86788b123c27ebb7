// This is libFuzzer's entry to one check, which SIGHTLINE_FUZZ_CHECK names. An exception that leaves it ends the run,
// and the input is kept.
#include <cstddef>
#include <cstdint>

#include "fuzz/checks.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  sightline::fuzz::SIGHTLINE_FUZZ_CHECK({reinterpret_cast<const char*>(data), size});
  return 0;
}
