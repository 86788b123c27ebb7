// Folders of results appear together: this tests what stays, what goes, and what is refused.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cli/system/result_folders.h"
#include "tests/cli/result_snapshot.h"
#include "tests/tools/command_runner.h"

namespace sightline::tests::result_folders_test {
using namespace cli;

namespace {

namespace fs = std::filesystem;

// Earlier results are in the folder `out`: page/a and page/b.
struct EarlierResults {
  TemporaryFolder folder;
  fs::path out = folder.path() / "out";

  EarlierResults() {
    fs::create_directories(out / "page");
    folder.file("out/page/a", "old a");
    folder.file("out/page/b", "old b");
  }
};

}  // namespace

TEST_CASE("nothing changes before results are published, and all of it afterwards") {
  const EarlierResults earlier;
  const Snapshot before = snapshot_of(earlier.out);
  {
    ResultFolders results(earlier.out);
    results.write("page", "a", "new a");
    results.write("second", "a", "new");
    CHECK(snapshot_of(earlier.out) == before);
    CHECK(leftovers_in(earlier.out) == 1);
    results.publish();
    CHECK(snapshot_of(earlier.out) == Snapshot{{"page/a", "new a"}, {"page/b", "old b"}, {"second/a", "new"}});
  }
  CHECK(leftovers_in(earlier.out) == 0);
}

TEST_CASE("a file beside the folders appears with them, and replaces an old one") {
  const EarlierResults earlier;
  earlier.folder.file("out/beside", "old");
  earlier.folder.file("out/foreign", "mine");
  fs::permissions(earlier.out / "beside", fs::perms::owner_read | fs::perms::owner_write);
  const Snapshot before = snapshot_of(earlier.out);
  {
    ResultFolders results(earlier.out);
    results.write_beside("first", "new");
    results.write("page", "a", "new a");
    results.write_beside("beside", "new");
    CHECK(snapshot_of(earlier.out) == before);
    results.publish();
  }
  CHECK(snapshot_of(earlier.out) ==
        Snapshot{{"beside", "new"}, {"first", "new"}, {"foreign", "mine"}, {"page/a", "new a"}, {"page/b", "old b"}});
  CHECK(fs::status(earlier.out / "beside").permissions() == (fs::perms::owner_read | fs::perms::owner_write));
  CHECK(leftovers_in(earlier.out) == 0);
}

TEST_CASE("a file beside the folders that is not published leaves the old one, or nothing") {
  const EarlierResults earlier;
  earlier.folder.file("out/beside", "old");
  const Snapshot before = snapshot_of(earlier.out);
  {
    ResultFolders results(earlier.out);
    results.write_beside("beside", "new");
    results.write_beside("first", "new");
  }
  CHECK(snapshot_of(earlier.out) == before);
}

TEST_CASE("a folder or a link in the place of a file beside the folders is refused, also when it comes late") {
  const EarlierResults earlier;
  fs::create_symlink("page/a", earlier.out / "link");
  ResultFolders results(earlier.out);
  for (const char* name : {"page", "link"}) {
    CHECK_THROWS_AS(results.require_place_beside(name), OutputError);
    CHECK_THROWS_AS(results.write_beside(name, ""), OutputError);
  }
  results.write("page", "a", "new a");
  results.write_beside("late", "new");
  fs::create_directory(earlier.out / "late");
  const Snapshot before = snapshot_of(earlier.out);
  CHECK_THROWS_AS(results.publish(), OutputError);
  CHECK(snapshot_of(earlier.out) == before);
}

TEST_CASE("a folder and a file beside it cannot have one name") {
  const EarlierResults earlier;
  ResultFolders results(earlier.out);
  results.write("folder", "a", "");
  CHECK_THROWS_AS(results.write_beside("folder", ""), OutputError);
  results.write_beside("file", "");
  CHECK_THROWS_AS(results.write("file", "a", ""), OutputError);
}

TEST_CASE("results that are not published leave nothing, not even the folders made for them") {
  const EarlierResults earlier;
  const Snapshot before = snapshot_of(earlier.out);
  {
    ResultFolders results(earlier.out);
    results.write("page", "a", "new a");
    OutputFolder deeper(earlier.folder.path() / "x" / "y", "z");
    deeper.write("a", "new");
    CHECK(fs::exists(earlier.folder.path() / "x" / "y"));
  }
  CHECK(snapshot_of(earlier.out) == before);
  CHECK(leftovers_in(earlier.out) == 0);
  CHECK_FALSE(fs::exists(earlier.folder.path() / "x"));
}

TEST_CASE("foreign files, folders and links stay what they are") {
  const EarlierResults earlier;
  const fs::path page = earlier.out / "page";
  fs::create_directories(page / "mine" / "deeper");
  fs::permissions(page / "mine", fs::perms::owner_all);
  earlier.folder.file("out/page/mine/deeper/note", "kept");
  fs::create_symlink("nowhere", page / "link");
  struct stat before {};
  REQUIRE(stat((page / "b").c_str(), &before) == 0);
  OutputFolder output(earlier.out, "page");
  output.write("a", "new a");
  output.publish();
  struct stat after {};
  REQUIRE(stat((page / "b").c_str(), &after) == 0);
  CHECK(after.st_ino == before.st_ino);
  CHECK(after.st_mtim.tv_nsec == before.st_mtim.tv_nsec);
  CHECK(read_text(page / "mine" / "deeper" / "note") == "kept");
  CHECK(fs::status(page / "mine").permissions() == fs::perms::owner_all);
  CHECK(fs::read_symlink(page / "link") == "nowhere");
  CHECK(read_text(page / "a") == "new a");
}

TEST_CASE("a foreign file that comes while results are published stays too") {
  const EarlierResults earlier;
  fs::create_directory(earlier.folder.path() / "new");
  carry_over_foreign_files(earlier.out / "page", earlier.folder.path() / "new");
  earlier.folder.file("out/page/late", "late");
  carry_over_foreign_files(earlier.out / "page", earlier.folder.path() / "new");
  CHECK(snapshot_of(earlier.folder.path() / "new") == Snapshot{{"a", "old a"}, {"b", "old b"}, {"late", "late"}});
}

TEST_CASE("the folder keeps its permissions") {
  const EarlierResults earlier;
  fs::permissions(earlier.out / "page", fs::perms::owner_all);
  OutputFolder output(earlier.out, "page");
  output.write("a", "new a");
  output.publish();
  CHECK(fs::status(earlier.out / "page").permissions() == fs::perms::owner_all);
}

TEST_CASE("a file or a link in the folder's place is refused, and a folder with content in a file's") {
  const EarlierResults earlier;
  earlier.folder.file("out/file", "mine");
  fs::create_directory_symlink("page", earlier.out / "link");
  fs::create_directories(earlier.out / "page" / "c");
  earlier.folder.file("out/page/c/note", "mine");
  const Snapshot before = snapshot_of(earlier.out);
  ResultFolders results(earlier.out);
  CHECK_THROWS_AS(results.write("file", "a", ""), OutputError);
  CHECK_THROWS_AS(results.write("link", "a", ""), OutputError);
  results.write("page", "c", "new");
  CHECK_THROWS_AS(results.publish(), OutputError);
  CHECK(snapshot_of(earlier.out) == before);
}

TEST_CASE("a file that has come into the folder's place is refused when it is published") {
  const EarlierResults earlier;
  ResultFolders results(earlier.out);
  results.write("page", "a", "new a");
  results.write("place", "a", "new");
  earlier.folder.file("out/place", "in the way since then");
  const Snapshot before = snapshot_of(earlier.out);
  CHECK_THROWS_AS(results.publish(), OutputError);
  CHECK(snapshot_of(earlier.out) == before);
}

TEST_CASE("where one folder cannot be replaced, none is") {
  const EarlierResults earlier;
  const fs::path root = earlier.folder.path();
  for (const char* name : {"one", "two"}) fs::create_directory(root / name);
  const std::vector<Replacement> replacements = {{root / "one", earlier.out / "page", root / "aside one"},
                                                 {root / "two", earlier.out / "fresh", root / "aside two"},
                                                 {root / "missing", earlier.out / "page", root / "aside three"}};
  const Snapshot before = snapshot_of(root);
  std::vector<Replaced> replaced;
  std::error_code error;
  CHECK(replace_all(replacements, replaced, error) == &replacements[2]);
  CHECK(error == std::errc::no_such_file_or_directory);
  CHECK(snapshot_of(root) == before);
  CHECK(fs::exists(root / "two"));
  CHECK_FALSE(fs::exists(earlier.out / "fresh"));
}

TEST_CASE("where the file beside the folders cannot be replaced, no folder is") {
  const EarlierResults earlier;
  const fs::path root = earlier.folder.path();
  fs::create_directory(root / "one");
  earlier.folder.file("out/beside", "old");
  const std::vector<Replacement> replacements = {{root / "one", earlier.out / "page", root / "aside one"},
                                                 {root / "missing", earlier.out / "beside", root / "aside two"}};
  const Snapshot before = snapshot_of(root);
  std::vector<Replaced> replaced;
  std::error_code error;
  CHECK(replace_all(replacements, replaced, error) == &replacements[1]);
  CHECK(snapshot_of(root) == before);
}

TEST_CASE("the temporary folder of a run that was killed goes, that of one that lives stays") {
  const EarlierResults earlier;
  ResultFolders living(earlier.out);
  living.write("page", "a", "of the other run");
  fs::create_directories(earlier.out / ".sightline-partial-dead" / "new" / "page");
  CHECK(leftovers_in(earlier.out) == 2);
  {
    ResultFolders next(earlier.out);
    CHECK(leftovers_in(earlier.out) == 2);
    CHECK_FALSE(fs::exists(earlier.out / ".sightline-partial-dead"));
  }
  living.publish();
  CHECK(read_text(earlier.out / "page" / "a") == "of the other run");
}

TEST_CASE("in two steps, where a file system cannot exchange: the old folder is aside, and can come back") {
  const EarlierResults earlier;
  const fs::path root = earlier.folder.path();
  fs::create_directory(root / "fresh");
  earlier.folder.file("fresh/a", "new a");
  const Replacement replacement{root / "fresh", earlier.out / "page", root / "aside"};
  const Snapshot before = snapshot_of(root);
  std::error_code error;
  CHECK(replace_in_two_steps(replacement, error) == Replaced::in_two_steps);
  CHECK_FALSE(error);
  CHECK(read_text(earlier.out / "page" / "a") == "new a");
  CHECK(read_text(old_one(replacement, Replaced::in_two_steps) / "a") == "old a");
  undo(replacement, Replaced::in_two_steps);
  CHECK(snapshot_of(root) == before);
  fs::remove_all(root / "fresh");
  CHECK(replace_in_two_steps(replacement, error) == Replaced::nothing);
  CHECK(error == std::errc::no_such_file_or_directory);
  CHECK(read_text(earlier.out / "page" / "a") == "old a");
}

TEST_CASE("an old folder that a killed run had moved aside goes back, unless there is a new one") {
  const EarlierResults earlier;
  const fs::path aside = earlier.out / ".sightline-partial-dead" / "old";
  fs::create_directories(aside / "page");
  earlier.folder.file("out/.sightline-partial-dead/old/page/a", "older");
  fs::create_directories(aside / "moved");
  earlier.folder.file("out/.sightline-partial-dead/old/moved/a", "moved");
  earlier.folder.file("out/.sightline-partial-dead/old/beside", "moved");
  const ResultFolders next(earlier.out);
  CHECK(snapshot_of(earlier.out) ==
        Snapshot{{"beside", "moved"}, {"moved/a", "moved"}, {"page/a", "old a"}, {"page/b", "old b"}});
  CHECK(leftovers_in(earlier.out) == 1);
}

}  // namespace sightline::tests::result_folders_test
