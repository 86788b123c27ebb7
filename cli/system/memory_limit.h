// How much memory the command may use: --max-memory, or three quarters of the machine's.
//
// "The machine's" is its physical memory, or the limit of a container (cgroup, version 1 or 2) where that is lower.
// The limit is kept in three ways: reading stops where the counts so far need more (obj_reader.h), the sweep does not
// start where it would need more (memory_estimate.h), and what neither can foresee (how many edges cross, how much is
// visible) fails at the limit itself (hold_to), as std::bad_alloc.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "geometry/numbers/errors.h"

namespace sightline::cli {

// More memory is needed than the limit allows; what() has both numbers.
class MemoryError : public Error {
 public:
  // what: what the memory is for.
  MemoryError(const std::string& what, std::uint64_t needed, std::uint64_t limit);
  // The limit was met with so much in use.
  MemoryError(std::uint64_t used, std::uint64_t limit);
};

// Too little to read the smallest scene.
constexpr std::uint64_t smallest_memory_limit = std::uint64_t{64} << 20;

[[nodiscard]] std::uint64_t default_memory_limit();

// Digits, and optionally K, M, G or T (powers of 1024); nullopt where it is something else or does not fit.
[[nodiscard]] std::optional<std::uint64_t> parse_bytes(std::string_view text);

// "3.2 GiB".
[[nodiscard]] std::string bytes_text(std::uint64_t bytes);

// From here on the process gets no more than this (RLIMIT_DATA: what it has allocated, touched or not, next to
// its code). Without effect where an address sanitizer needs more for itself.
void hold_to(std::uint64_t limit);

// The lowest limit of the process' cgroups; nullopt for none. membership: /proc/self/cgroup; mounts: /sys/fs/cgroup.
[[nodiscard]] std::optional<std::uint64_t> cgroup_memory_limit(const std::filesystem::path& membership,
                                                               const std::filesystem::path& mounts);

}  // namespace sightline::cli
