// This tests what --max-memory may say, and where its default comes from.
#include "cli/system/memory_limit.h"

#include <doctest/doctest.h>

#include <array>

#include "cli/command_line.h"
#include "tests/tools/command_runner.h"

namespace sightline::tests::memory_limit_test {
using namespace cli;

namespace {

std::uint64_t limit_from(const char* text) {
  const std::array arguments{"sightline", "analyze", "scene.toml", "--json", "--max-memory", text};
  return std::get<AnalyzeOptions>(parse_command_line(static_cast<int>(arguments.size()), arguments.data())).max_memory;
}

constexpr std::uint64_t gibibyte = std::uint64_t{1} << 30;

}  // namespace

TEST_CASE("bytes with and without a suffix") {
  CHECK(parse_bytes("0") == 0);
  CHECK(parse_bytes("1024") == 1024);
  CHECK(parse_bytes("3K") == 3 * 1024);
  CHECK(parse_bytes("2M") == 2 * 1024 * 1024);
  CHECK(parse_bytes("5G") == 5 * gibibyte);
  CHECK(parse_bytes("1T") == 1024 * gibibyte);
  CHECK(parse_bytes("16777215T") == std::uint64_t{16777215} * 1024 * gibibyte);
  for (const char* wrong : {"", "G", "-1", "+1", "1.5G", "1 G", "1g", "1GB", "1GG", "0x10", "16777216T", "1e9",
                            "18446744073709551616", "99999999999999999999G"}) {
    INFO(wrong);
    CHECK_FALSE(parse_bytes(wrong));
  }
}

TEST_CASE("the option is refused where it is no size or too small, and has a default") {
  CHECK(limit_from("64M") == 64 * 1024 * 1024);
  CHECK_THROWS_WITH_AS((void)limit_from("63M"), "--max-memory: 63M is less than 64.0 MiB; give at least that",
                       CommandLineError);
  CHECK_THROWS_WITH_AS((void)limit_from("lots"),
                       "--max-memory: 'lots' is not a number of bytes; write one, like 800M or 4G", CommandLineError);
  const std::array arguments{"sightline", "analyze", "scene.toml", "--json"};
  const auto options = parse_command_line(static_cast<int>(arguments.size()), arguments.data());
  CHECK(std::get<AnalyzeOptions>(options).max_memory == default_memory_limit());
  CHECK(default_memory_limit() >= smallest_memory_limit);
}

TEST_CASE("the limit of a container, of either version, the lowest of all around it") {
  const tests::TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "fs" / "a" / "b");
  std::filesystem::create_directories(folder.path() / "fs" / "memory" / "c");
  const std::filesystem::path mounts = folder.path() / "fs";
  const auto limit_of = [&](const std::string& membership) {
    return cgroup_memory_limit(folder.file("cgroup", membership), mounts);
  };
  CHECK_FALSE(limit_of("0::/a/b\n"));
  folder.file("fs/a/b/memory.max", "max\n");
  CHECK_FALSE(limit_of("0::/a/b\n"));
  folder.file("fs/a/memory.max", "3000000\n");
  CHECK(limit_of("0::/a/b\n") == 3000000);
  folder.file("fs/a/b/memory.max", "2000000\n");
  CHECK(limit_of("0::/a/b\n") == 2000000);
  CHECK(limit_of("0::/a\n") == 3000000);
  folder.file("fs/memory.max", "1000000\n");
  CHECK(limit_of("0::/not/there\n") == 1000000);
  folder.file("fs/memory/c/memory.limit_in_bytes", "500000\n");
  CHECK(limit_of("9:name=systemd:/c\n4:cpu,memory:/c\n") == 500000);
  CHECK_FALSE(limit_of("9:name=systemd:/c\n4:cpu:/c\nnonsense\n"));
  CHECK(limit_of("4:memory:/c\n0::/a\n") == 500000);
  CHECK_FALSE(cgroup_memory_limit(folder.path() / "absent", mounts));
}

}  // namespace sightline::tests::memory_limit_test
