#include "cli/system/memory_limit.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <limits>

namespace sightline::cli {

namespace {

// The number in the file; nullopt for none ("max" among them).
std::optional<std::uint64_t> number_in(const std::filesystem::path& file) {
  std::uint64_t value = 0;
  std::ifstream in(file);
  return in >> value ? std::optional(value) : std::nullopt;
}

std::optional<std::uint64_t> lower_of(std::optional<std::uint64_t> a, std::optional<std::uint64_t> b) {
  if (!a || !b) return a ? a : b;
  return std::min(*a, *b);
}

// A group is held to the limits of all groups around it.
std::optional<std::uint64_t> lowest_limit(const std::filesystem::path& root, std::filesystem::path group,
                                          const char* file) {
  std::optional<std::uint64_t> lowest = number_in(root / file);
  for (; group.has_relative_path(); group = group.parent_path()) {
    lowest = lower_of(lowest, number_in(root / group.relative_path() / file));
  }
  return lowest;
}

bool names_memory(std::string_view controllers) {
  return ("," + std::string(controllers) + ",").find(",memory,") != std::string::npos;
}

// One line of /proc/self/cgroup: NUMBER:CONTROLLERS:GROUP, without controllers in version 2.
std::optional<std::uint64_t> limit_of_line(const std::string& line, const std::filesystem::path& mounts) {
  const std::size_t first = line.find(':');
  const std::size_t second = line.find(':', first + 1);
  if (first == std::string::npos || second == std::string::npos) return std::nullopt;
  const std::string controllers = line.substr(first + 1, second - first - 1);
  const std::filesystem::path group = line.substr(second + 1);
  if (controllers.empty()) return lowest_limit(mounts, group, "memory.max");
  if (names_memory(controllers)) return lowest_limit(mounts / "memory", group, "memory.limit_in_bytes");
  return std::nullopt;
}

std::uint64_t physical_memory() {
  return static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

#if defined(__SANITIZE_ADDRESS__)
constexpr bool can_hold = false;
#elif defined(__has_feature)
constexpr bool can_hold = !__has_feature(address_sanitizer);
#else
constexpr bool can_hold = true;
#endif

// The code of the program and its libraries, which a limit of data leaves out.
std::uint64_t code_bytes() {
  std::uint64_t total = 0;
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::uint64_t kibibytes = 0;
    if ((word == "VmExe:" || word == "VmLib:") && status >> kibibytes) total += 1024 * kibibytes;
  }
  return total;
}

// 1024 to the power that the letter stands for; 0 for no such letter.
std::uint64_t unit_of(char letter) {
  const std::string_view letters = "KMGT";
  const std::size_t power = letters.find(letter);
  return power == letters.npos ? 0 : std::uint64_t{1} << (10 * (power + 1));
}

}  // namespace

MemoryError::MemoryError(const std::string& what, std::uint64_t needed, std::uint64_t limit)
    : Error(fmt::format("{} needs about {} of memory, and the limit is {}; raise it with --max-memory", what,
                        bytes_text(needed), bytes_text(limit))) {}

MemoryError::MemoryError(std::uint64_t used, std::uint64_t limit)
    : Error(fmt::format("more memory is needed: {} are in use, and the limit is {}; raise it with --max-memory",
                        bytes_text(used), bytes_text(limit))) {}

std::optional<std::uint64_t> cgroup_memory_limit(const std::filesystem::path& membership,
                                                 const std::filesystem::path& mounts) {
  std::optional<std::uint64_t> lowest;
  std::ifstream in(membership);
  for (std::string line; std::getline(in, line);) lowest = lower_of(lowest, limit_of_line(line, mounts));
  return lowest;
}

std::uint64_t default_memory_limit() {
  const auto group = cgroup_memory_limit("/proc/self/cgroup", "/sys/fs/cgroup");
  return std::max(*lower_of(physical_memory(), group) / 4 * 3, smallest_memory_limit);
}

std::optional<std::uint64_t> parse_bytes(std::string_view text) {
  std::uint64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc()) return std::nullopt;
  if (stop == end) return value;
  const std::uint64_t unit = unit_of(*stop);
  if (stop + 1 != end || unit == 0 || value > std::numeric_limits<std::uint64_t>::max() / unit) return std::nullopt;
  return value * unit;
}

std::string bytes_text(std::uint64_t bytes) {
  constexpr double unit = 1024;
  const auto value = static_cast<double>(bytes);
  if (value < unit * unit * unit) return fmt::format("{:.1f} MiB", value / (unit * unit));
  return fmt::format("{:.1f} GiB", value / (unit * unit * unit));
}

void hold_to(std::uint64_t limit) {
  if (!can_hold) return;
  rlimit data{};
  getrlimit(RLIMIT_DATA, &data);
  data.rlim_cur = std::min<rlim_t>(limit - std::min(limit, code_bytes()), data.rlim_max);
  setrlimit(RLIMIT_DATA, &data);
}

}  // namespace sightline::cli
