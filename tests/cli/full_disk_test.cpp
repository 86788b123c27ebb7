// A disk is full, at every amount of space left: the old results stay as they are.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>

#include "tests/cli/result_snapshot.h"
#include "tests/tools/running_command.h"

namespace sightline::tests::full_disk_test {

namespace {

namespace fs = std::filesystem;

constexpr int page = 4096;
constexpr int pages_of_disk = 200;

void write_text(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }

// Enters a name space of its own, in which a file system can be mounted without anyone else seeing it; without rights,
// by way of a user name space, where the system allows that.
bool enter_mount_space() {
  const uid_t user = getuid();
  const gid_t group = getgid();
  if (unshare(CLONE_NEWNS) != 0) {
    if (unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) return false;
    write_text("/proc/self/setgroups", "deny");
    write_text("/proc/self/uid_map", "0 " + std::to_string(user) + " 1");
    write_text("/proc/self/gid_map", "0 " + std::to_string(group) + " 1");
  }
  return mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0;
}

bool mount_small_disk(const fs::path& folder) {
  const std::string size = "size=" + std::to_string(pages_of_disk * page);
  return enter_mount_space() && mount("none", folder.c_str(), "tmpfs", 0, size.c_str()) == 0;
}

// Leaves so many pages on the disk.
void fill(const fs::path& filler, int free_pages) {
  fs::remove(filler);
  std::ofstream out(filler, std::ios::binary);
  out << std::string(std::size_t{pages_of_disk} * page, 'x');
  out.close();
  fs::resize_file(filler, fs::file_size(filler) / page * page - static_cast<std::uintmax_t>(free_pages * page));
}

bool is_one_line_about_space(const std::string& err) {
  return std::ranges::count(err, '\n') == 1 &&
         err.find("cannot be written: No space left on device") != std::string::npos;
}

// Runs the command with so much space; returns "" where the result is as it should be, else what is wrong.
std::string try_with(const TemporaryFolder& folder, const fs::path& disk, const Snapshot& before, const Snapshot& after,
                     int free_pages, int& refused) {
  fill(disk / "filler", free_pages);
  const Outcome outcome =
      run_to_end({"analyze", (folder.path() / "b.toml").string(), "--quiet", "-o", (disk / "results").string()});
  const Snapshot seen = snapshot_of(disk / "results");
  const bool left = leftovers_in(disk / "results") > 0;
  refused += outcome.exit_code == 1 ? 1 : 0;
  const bool good = outcome.exit_code == 0
                        ? seen == after
                        : outcome.exit_code == 1 && seen == before && is_one_line_about_space(outcome.err);
  if (good && !left) return "";
  return std::to_string(free_pages) + " pages: exit code " + std::to_string(outcome.exit_code) +
         (left ? ", a temporary folder is left" : "") + ", " + outcome.err;
}

// This runs in a process of its own, since a mount space cannot be left. Returns a line per thing that is wrong, then a
// summary.
std::string fill_disk(const TemporaryFolder& folder) {
  const fs::path disk = folder.path() / "disk";
  fs::create_directory(disk);
  if (!mount_small_disk(disk)) return "no mount";
  const std::string results = (disk / "results").string();
  const std::string other = (folder.path() / "other").string();
  (void)run_to_end({"analyze", (folder.path() / "a.toml").string(), "--quiet", "-o", results});
  (void)run_to_end({"analyze", (folder.path() / "b.toml").string(), "--quiet", "-o", other});
  const Snapshot before = snapshot_of(results);
  std::string wrong = before.size() == 20 ? "" : "the disk does not hold the first result\n";
  int refused = 0;
  int runs = 0;
  for (int pages = 0; snapshot_of(results) == before && pages < pages_of_disk / 2; ++pages, ++runs) {
    wrong += try_with(folder, disk, before, snapshot_of(other), pages, refused);
  }
  return wrong + "tmpfs: " + std::to_string(runs) + " runs, " + std::to_string(refused) + " refused";
}

// Returns what `work` returns, computed in a child process.
template <class Work>
std::string in_child(Work work) {
  std::array<int, 2> ends{};
  REQUIRE(pipe(ends.data()) == 0);
  const pid_t child = fork();
  if (child == 0) {
    const std::string text = work();
    const bool written = write(ends[1], text.data(), text.size()) == static_cast<ssize_t>(text.size());
    _exit(written ? 0 : 1);
  }
  close(ends[1]);
  std::string text;
  std::array<char, 4096> buffer{};
  for (ssize_t n = 0; (n = read(ends[0], buffer.data(), buffer.size())) > 0;)
    text.append(buffer.data(), static_cast<std::size_t>(n));
  close(ends[0]);
  waitpid(child, nullptr, 0);
  return text;
}

}  // namespace

TEST_CASE("a full disk is exit code 1 in one line, and the old results are as they were") {
  const TemporaryFolder folder;
  folder.file("a.toml", three_camera_scene(0));
  folder.file("b.toml", three_camera_scene(1));
  const std::string found = in_child([&] { return fill_disk(folder); });
  if (found == "no mount") {
    MESSAGE("no right to mount a tmpfs: only the limit of file sizes below was tested");
    return;
  }
  MESSAGE(found);
  CHECK(found.starts_with("tmpfs: "));
  int runs = 0;
  int refused = 0;
  CHECK(std::sscanf(found.c_str(), "tmpfs: %d runs, %d refused", &runs, &refused) == 2);
  CHECK(refused >= 10);
  CHECK(runs == refused + 1);
}

TEST_CASE("a file beyond the limit of file sizes is exit code 1 in one line, and the old results are as they were") {
  const TemporaryFolder folder;
  const std::string a = folder.file("a.toml", three_camera_scene(0));
  const std::string b = folder.file("b.toml", three_camera_scene(1));
  const fs::path results = folder.path() / "results";
  REQUIRE(run_to_end({"analyze", a, "-o", results.string()}).exit_code == 0);
  const Snapshot before = snapshot_of(results);
  std::size_t largest = 0;
  for (const auto& [path, text] : before) largest = std::max(largest, text.size());
  for (const std::size_t limit : {std::size_t{0}, std::size_t{1}, largest / 2, largest - 1}) {
    const Outcome outcome = run_to_end({"analyze", b, "--quiet", "-o", results.string()}, {.file_size = limit});
    INFO("limit " << limit);
    CHECK(outcome.exit_code == 1);
    CHECK(snapshot_of(results) == before);
    CHECK(leftovers_in(results) == 0);
    if (limit < 200) continue;  // standard error is a file too
    CHECK(std::ranges::count(outcome.err, '\n') == 1);
    CHECK(outcome.err.find("cannot be written: File too large") != std::string::npos);
  }
}

TEST_CASE("standard output that cannot be written is exit code 1") {
  const TemporaryFolder folder;
  const std::string scene = folder.file("a.toml", three_camera_scene(0));
  CHECK(std::system(("'" SIGHTLINE_COMMAND "' analyze '" + scene + "' --json > /dev/full 2> /dev/null").c_str()) ==
        256);
}

}  // namespace sightline::tests::full_disk_test
