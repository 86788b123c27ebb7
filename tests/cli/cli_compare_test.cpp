// The command `sightline compare` runs the peers: this tests what becomes of runs, and what is written of them.
#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "cli/compare/compare_page.h"
#include "cli/compare/compare_table.h"
#include "cli/compare/comparison.h"
#include "peers/peer_list.h"
#include "tests/tools/command_runner.h"
#include "tests/tools/says_what_to_do.h"

namespace sightline::tests::cli_compare_test {
using namespace cli;

using Json = nlohmann::json;

namespace {

constexpr const char* fang = SIGHTLINE_FIXTURES_DIR "/fang/scene.toml";
constexpr double limit_seconds = 0.5;
constexpr std::string_view png_signature = "\x89PNG\r\n";

peers::Outcome nothing(const peers::FlatScene& /*scene*/, int resolution) {
  return {peers::ItemBuffer(resolution), {{"pixels", 4}}};
}
peers::Outcome never_ends(const peers::FlatScene& /*scene*/, int /*resolution*/) {
  for (volatile std::uint64_t turns = 0;;) turns = turns + 1;
}
peers::Outcome refuses(const peers::FlatScene& /*scene*/, int /*resolution*/) {
  throw peers::RefusedScene("too many bodies");
}
peers::Outcome crashes(const peers::FlatScene& /*scene*/, int resolution) {
  std::raise(SIGKILL);
  return {peers::ItemBuffer(resolution), {}};
}
peers::Outcome breaks(const peers::FlatScene& /*scene*/, int /*resolution*/) {
  throw ArithmeticError("float", "no order");
}
peers::Outcome uses_memory(const peers::FlatScene& /*scene*/, int resolution) {
  std::vector<char> held(std::size_t{40} << 20, 1);
  return {peers::ItemBuffer(resolution), {{"bytes", held.size()}}};
}

CompareRun run_of(decltype(peers::Peer::run) run) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  peers::Peer peer;
  peer.name = "peer";
  peer.title = "A <peer> & more";
  peer.run = run;
  return run_peer(peer, {}, {}, 2, limit_seconds);
}

Json compared(const std::vector<std::string>& options, const TemporaryFolder& folder) {
  std::vector<std::string> arguments{"compare", fang, "--quiet", "-o", (folder.path() / "out").string()};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const RunResult run = run_sightline(arguments);
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  CHECK(run.out.empty());
  return Json::parse(read_text(folder.path() / "out" / "compare.json"));
}

std::string error_of(const std::vector<std::string>& options) {
  std::vector<std::string> arguments{"compare", fang, "-o", "nowhere"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const RunResult run = run_sightline(arguments);
  CHECK(run.out.empty());
  CHECK(says_what_to_do(run.err));
  return std::to_string(run.exit_code) + " " + run.err;
}

}  // namespace

TEST_CASE("a run that is done has its counts, errors and pictures") {
  const CompareRun run = run_of(nothing);
  CHECK(run.end == CompareEnd::done);
  REQUIRE(run.counts.size() == 1);
  CHECK(run.counts[0].number == 4);
  CHECK(run.areas.value().wrong_share == 0);
  CHECK(run.pictures.seen.starts_with(png_signature));
  CHECK(run.pictures.wrong.starts_with(png_signature));
}

TEST_CASE("a run that is not done says why") {
  CHECK(run_of(never_ends).end == CompareEnd::out_of_time);
  const CompareRun refused = run_of(refuses);
  CHECK(refused.end == CompareEnd::refused);
  CHECK(refused.why == "too many bodies");
  const CompareRun broken = run_of(breaks);
  CHECK(broken.end == CompareEnd::failed);
  CHECK(broken.why.find("no order") != std::string::npos);
  const CompareRun crashed = run_of(crashes);
  CHECK(crashed.end == CompareEnd::failed);
  CHECK(crashed.why == "it ended without a result");
}

TEST_CASE("a run's memory is what it held above what was there") {
  const std::uint64_t little = run_of(nothing).peak_bytes;
  const std::uint64_t much = run_of(uses_memory).peak_bytes;
  CHECK(much > std::uint64_t{40} << 20);
  CHECK(little < std::uint64_t{8} << 20);
}

TEST_CASE("the page writes names as text, and a row for each run") {
  Comparison comparison;
  comparison.scene = "<script>alert(1)</script>";
  comparison.runs = {run_of(nothing), run_of(refuses)};
  const std::string page = compare_page(comparison);
  CHECK(page.find("<script>") == std::string::npos);
  CHECK(page.find("A &lt;peer> &amp; more") != std::string::npos);
  CHECK(page.find("too many bodies") != std::string::npos);
  CHECK(page.find("peer-2.png") != std::string::npos);
  CHECK(page.find("No result; the table says why.") == std::string::npos);
  const auto rows = lines_of(compare_table(comparison));
  REQUIRE(rows.size() == 3);
  CHECK(split(rows[1], ',').size() == split(rows[0], ',').size());
  CHECK(rows[2].starts_with("peer,image,2,refused,\"too many bodies\",,,,,,,,,,,"));
  comparison.runs = {run_of(refuses)};
  CHECK(compare_page(comparison).find("No result; the table says why.") != std::string::npos);
}

TEST_CASE("peers have names of their own, and something to say of themselves") {
  std::set<std::string> names;
  for (const peers::Peer& peer : peers::all_peers()) {
    CAPTURE(peer.name);
    CHECK(names.insert(peer.name).second);
    CHECK(peer.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string::npos);
    for (const std::string* text : {&peer.title, &peer.source, &peer.does, &peer.errs}) CHECK_FALSE(text->empty());
  }
}

TEST_CASE("compare: all peers on Fang's scene, at two resolutions") {
  const TemporaryFolder folder;
  const Json found = compared({"--resolution", "64,16,64"}, folder);
  CHECK(found["visible_faces"] == 2);
  std::size_t expected = 0;
  for (const peers::Peer& peer : peers::all_peers()) {
    expected += peer.computed_at == peers::ComputedAt::image_precision ? 2 : 1;
  }
  CHECK(found["runs"].size() == expected);
  for (const Json& run : found["runs"]) {
    CAPTURE(run["peer"].get<std::string>());
    if (run["peer"] == "sweep-exact") CHECK(run["errors"]["wrong_share"].get<double>() < 1e-15);
    if (run["peer"] == "z-buffer")
      CHECK(run["errors"]["wrong_share"].get<double>() < 6.0 / run["resolution"].get<int>());
  }
  const auto file = [&](const char* name) { return read_text(folder.path() / "out" / name); };
  CHECK(file("z-buffer-16.png").starts_with(png_signature));
  CHECK(file("z-buffer-64-wrong.png").starts_with(png_signature));
  const std::string page = file("compare.html");
  CHECK(page.find("src=\"z-buffer-64.png\"") != std::string::npos);
  CHECK(page.find("The wrong face is in 5.3 % of the window at 16 pixels a side, 1.3 % at 64.") != std::string::npos);
  CHECK(page.find("Of the visible lines 0 are missing") != std::string::npos);
  CHECK(file("compare.svg").starts_with("<svg"));
  CHECK(lines_of(file("compare.csv")).size() == expected + 1);
}

TEST_CASE("compare: some peers only, and a summary") {
  const TemporaryFolder folder;
  CHECK(compared({"--peers", "appel,warnock", "--resolution", "8"}, folder)["runs"].size() == 2);
  const RunResult run = run_sightline(
      {"compare", fang, "--peers", "z-buffer", "--resolution", "8", "-o", (folder.path() / "out").string()});
  CHECK(run.exit_code == 0);
  CHECK(run.out.find("z-buffer") != std::string::npos);
  for (const std::string& line : lines_of(run.out)) CHECK((line.size() <= 80 || line.find('/') != std::string::npos));
}

TEST_CASE("compare: what is wrong on its command line") {
  CHECK(error_of({"--peers", "z-buffer,magic"}).starts_with("2 sightline: --peers: there is no 'magic'; there are "));
  CHECK(error_of({"--resolution", "0"}).starts_with("2 sightline: --resolution: '0' is not a whole number from 1 to "));
  CHECK(error_of({"--time-limit", "-1"}).starts_with("2 sightline: --time-limit: '-1' is not more than 0"));
  CHECK(error_of({"--eye", "1,2,3"}).starts_with("2 sightline: --eye, --target"));
  CHECK(error_of({"--camera", "none"}).starts_with("2 sightline: --camera: the scene has no 'none'; it has page"));
}

}  // namespace sightline::tests::cli_compare_test
