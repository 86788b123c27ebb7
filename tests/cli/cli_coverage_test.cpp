// This tests coverage.csv: its text, through the command, and when it appears.
#include <doctest/doctest.h>

#include <algorithm>

#include "formats/writing/coverage_table.h"
#include "tests/cli/result_snapshot.h"
#include "tests/tools/command_runner.h"

namespace sightline::tests::cli_coverage_test {

namespace {

namespace fs = std::filesystem;

constexpr const char* head = "face,camera,panel,visible_area,reflecting_area,visible_share,reflecting_share";

// Parallel rays go straight down on a square of side 4 and a triangle beside it, and on a face that is none: `left`
// sees [0, 2] x [0, 2] of the square, `middle, low` [1, 3] x [1, 3].
struct Squares : TemporaryFolder {
  Squares() {
    static_cast<void>(file("mesh.obj",
                           "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 9 0 0\nv 10 0 0\nv 9 1 0\n"
                           "f 1 2 3 4\nf 5 6 7\nf 1 2 1\n"));
  }
  [[nodiscard]] static std::string camera(const std::string& name, const std::string& x_y) {
    return "[[camera]]\nname = \"" + name + "\"\neye = [" + x_y + ", 8]\ntarget = [" + x_y +
           ", 0]\nup = [0, 1, 0]\northographic_height = 2\n";
  }
  [[nodiscard]] std::string scene(const std::string& cameras) const {
    return file("scene.toml", "[mesh]\nfile = \"mesh.obj\"\n" + cameras);
  }
  [[nodiscard]] fs::path out() const { return path() / "out"; }
  [[nodiscard]] RunResult run(const std::string& scene) const {
    return run_sightline({"analyze", scene, "-o", out().string()});
  }
  [[nodiscard]] std::vector<std::string> rows() const { return lines_of(read_text(out() / "coverage.csv")); }
};

const std::string two_cameras = Squares::camera("left", "1, 1") + Squares::camera("middle, low", "2, 2");

}  // namespace

TEST_CASE("the table of a coverage, row by row") {
  Coverage coverage;
  coverage.area = 8;
  coverage.cameras = {{2, 1.5, {1, 0.5}}, {4, 0, {0, 0}}};
  coverage.together = {5, 2, {1, 1.5}};
  coverage.faces = {{8, 5, 2}, {0, 0, 0}};
  CHECK(lines_of(coverage_table(coverage, {"a", "b, c"}, {"p", "q"})) ==
        std::vector<std::string>{head, ",a,p,2,1,0.25,0.125", ",a,q,2,0.5,0.25,0.0625", ",\"b, c\",p,4,0,0.5,0",
                                 ",\"b, c\",q,4,0,0.5,0", ",a,,2,1.5,0.25,0.1875", ",\"b, c\",,4,0,0.5,0",
                                 ",,p,5,1,0.625,0.125", ",,q,5,1.5,0.625,0.1875", ",,,5,2,0.625,0.25",
                                 "0,,,5,2,0.625,0.25", "1,,,0,0,0,0"});
}

TEST_CASE("coverage.csv has the union of what cameras see, and the summary names it, in 80 columns") {
  const Squares squares;
  const RunResult run = squares.run(squares.scene(two_cameras));
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  const auto rows = squares.rows();
  REQUIRE(rows.size() == 7);
  CHECK(rows[0] == head);
  CHECK(rows[1].starts_with(",left,,"));
  CHECK(rows[2].starts_with(",\"middle, low\",,"));
  CHECK(rows[3].starts_with(",,,"));
  CHECK(std::stod(split(rows[1], ',')[3]) == doctest::Approx(4).epsilon(1e-9));
  CHECK(std::stod(split(rows[3], ',')[3]) == doctest::Approx(7).epsilon(1e-9));
  CHECK(std::stod(split(rows[3], ',')[5]) == doctest::Approx(7 / 16.5).epsilon(1e-9));
  CHECK(split(rows[4], ',')[0] == "0");
  CHECK(std::stod(split(rows[4], ',')[3]) == doctest::Approx(7).epsilon(1e-9));
  CHECK(std::stod(split(rows[4], ',')[5]) == doctest::Approx(7.0 / 16).epsilon(1e-9));
  CHECK(rows[5] == "1,,,0,0,0,0");
  CHECK(rows[6] == "2,,,0,0,0,0");
  CHECK(run.out.find("coverage.csv") != std::string::npos);
  CHECK(run.out.find("visible in one or more                           7          42.42 %\n") != std::string::npos);
  CHECK(run.out.find("reflecting") == std::string::npos);
  for (const std::string& line : lines_of(run.out)) {
    if (line.find('/') == std::string::npos) CHECK(line.size() <= 80);
  }
}

TEST_CASE("one camera: the file is there, and the summary has nothing more to say") {
  const Squares squares;
  const RunResult run = squares.run(squares.scene(Squares::camera("left", "1, 1")));
  REQUIRE(run.exit_code == 0);
  const auto rows = squares.rows();
  REQUIRE(rows.size() == 6);
  CHECK(rows[1].substr(6) == rows[2].substr(2));
  CHECK(run.out.find("together\n") != std::string::npos);
  CHECK(run.out.find("visible in one or more") == std::string::npos);
}

TEST_CASE("with panels: each with each camera, then each for itself") {
  const Squares squares;
  const std::string panel = "[[panel]]\nname = \"lamp\"\ncorners = [[-9, -9, 9], [9, -9, 9], [9, 9, 9], [-9, 9, 9]]\n";
  const RunResult run = squares.run(squares.scene(two_cameras + panel));
  REQUIRE(run.exit_code == 0);
  const auto rows = squares.rows();
  REQUIRE(rows.size() == 10);
  for (const std::size_t row : {1U, 5U}) {
    const auto cells = split(rows[row], ',');
    CHECK(cells[2] == "lamp");
    CHECK(cells[3] == cells[4]);
    CHECK(std::stod(cells[4]) == doctest::Approx(row == 1 ? 4 : 7).epsilon(1e-9));
  }
  CHECK(run.out.find("reflecting a panel in one or more                7          42.42 %\n") != std::string::npos);
}

TEST_CASE("a run that fails leaves coverage.csv as it was, one that ends replaces it") {
  const Squares squares;
  REQUIRE(squares.run(squares.scene(two_cameras)).exit_code == 0);
  const Snapshot before = snapshot_of(squares.out());
  CHECK(before.contains("coverage.csv"));
  // The last camera's folder cannot be made.
  static_cast<void>(squares.file("out/in the way", "mine"));
  const std::string blocked = squares.scene(Squares::camera("left", "3, 3") + Squares::camera("in the way", "2, 2"));
  CHECK(squares.run(blocked).exit_code == 1);
  CHECK(snapshot_of(squares.out()).at("coverage.csv") == before.at("coverage.csv"));
  fs::remove(squares.out() / "in the way");
  CHECK(snapshot_of(squares.out()) == before);
  CHECK(squares.run(blocked).exit_code == 0);
  CHECK(snapshot_of(squares.out()).at("coverage.csv") != before.at("coverage.csv"));
  CHECK(leftovers_in(squares.out()) == 0);
}

TEST_CASE("a folder or a link called coverage.csv is refused before anything is analysed") {
  const Squares squares;
  const std::string scene = squares.scene(two_cameras);
  fs::create_directories(squares.out() / "coverage.csv");
  const RunResult run = squares.run(scene);
  CHECK(run.exit_code == 1);
  CHECK(run.err.find("coverage.csv: cannot be written") != std::string::npos);
  CHECK(snapshot_of(squares.path()).size() == 2);
  fs::remove(squares.out() / "coverage.csv");
  fs::create_symlink(squares.path() / "mesh.obj", squares.out() / "coverage.csv");
  CHECK(squares.run(scene).exit_code == 1);
  CHECK(fs::is_symlink(squares.out() / "coverage.csv"));
  CHECK_FALSE(fs::exists(squares.out() / "left"));
}

TEST_CASE("no camera is called coverage.csv or report.html, in whatever letters") {
  const Squares squares;
  for (const char* name : {"coverage.csv", "Coverage.CSV", "report.html", "REPORT.html"}) {
    const RunResult run = squares.run(squares.scene(Squares::camera(name, "1, 1")));
    CHECK(run.exit_code == 1);
    CHECK(run.err.find("scene.toml:4: the camera's name is that of a file beside the cameras' folders") !=
          std::string::npos);
    CHECK_FALSE(fs::exists(squares.out()));
  }
  CHECK(squares.run(squares.scene(Squares::camera("coverage", "1, 1"))).exit_code == 0);
}

}  // namespace sightline::tests::cli_coverage_test
