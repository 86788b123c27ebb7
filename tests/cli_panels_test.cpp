// Panels in every output of the command.
#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "command_runner.h"

using namespace sightline::testing;
using Json = nlohmann::ordered_json;

namespace {

// The mirror of tests/reflection_test.cpp, in two triangles: the panel "left" is mirrored in the unit square around the
// origin, half of it in each triangle; the panel "dark" shows its back.
struct Results : TemporaryFolder {
  Results() {
    static_cast<void>(file("floor.obj", "v -8 -8 0\nv 8 -8 0\nv 8 8 0\nv -8 8 0\nf 1 2 3\nf 1 3 4\n"));
    const std::string scene = file("scene.toml",
                                   "[mesh]\nfile = \"floor.obj\"\n[[camera]]\nname = \"down\"\nimage = [2, 2]\n"
                                   "pixel_origin = \"corner\"\nP = [[1, 0, -1, 6], [0, -1, -1, 4], [0, 0, -1, 4]]\n"
                                   "[[panel]]\nname = \"left\"\n"
                                   "corners = [[1, -1, 4], [3, -1, 4], [3, 1, 4], [1, 1, 4]]\n"
                                   "[[panel]]\nname = \"dark\"\nemits = \"front\"\n"
                                   "corners = [[1, -1, 5], [3, -1, 5], [3, 1, 5], [1, 1, 5]]\n");
    run = run_sightline({"analyze", scene, "--quiet", "-o", (path() / "out").string()});
  }
  [[nodiscard]] std::string text(const std::string& name) const { return read_text(path() / "out" / "down" / name); }

  RunResult run;
};

}  // namespace

TEST_CASE("panels in faces.csv, report.json, labelled.ply, labelled.obj and view.svg") {
  const Results results;
  INFO(results.run.err);
  REQUIRE(results.run.exit_code == 0);

  const auto rows = lines_of(results.text("faces.csv"));
  REQUIRE(rows.size() == 3);
  CHECK(rows[0].ends_with(",reflecting_area:left,reflecting_area:dark"));
  for (const std::size_t row : {1U, 2U}) {
    const auto cells = split(rows[row], ',');
    CHECK(std::stod(cells[7]) == doctest::Approx(0.5).epsilon(1e-9));
    CHECK(cells[8] == "0");
  }

  const Json report = Json::parse(results.text("report.json"));
  const Json& reflections = report["reflections"];
  CHECK(reflections["mode"] == "exact");
  REQUIRE(reflections["panels"].size() == 2);
  CHECK(reflections["panels"][0]["name"] == "left");
  CHECK(reflections["panels"][0]["emits"] == "both");
  CHECK(reflections["panels"][0]["area"].get<double>() == doctest::Approx(1).epsilon(1e-9));
  CHECK(reflections["panels"][0]["image_area"].get<double>() == doctest::Approx(0.0625).epsilon(1e-9));
  CHECK(reflections["panels"][0]["polygons"] == 2);
  CHECK(reflections["panels"][1]["area"] == 0);
  CHECK(reflections["pyramids"].get<int>() >= 2);
  CHECK(report["times_s"].contains("reflect"));

  const std::string ply = results.text("labelled.ply");
  CHECK(ply.find("property uchar seen\nproperty uchar reflecting_left\nproperty uchar reflecting_dark\nend_header\n") !=
        std::string::npos);

  const auto obj = lines_of(results.text("labelled.obj"));
  CHECK(std::ranges::count(obj, "g visible reflecting_left") == 1);
  CHECK(std::ranges::count_if(obj, [](const std::string& line) { return line.find("dark") != std::string::npos; }) ==
        0);

  const std::string svg = results.text("view.svg");
  CHECK(svg.find("<g class=\"reflecting\" data-panel=\"left\"") != std::string::npos);
  CHECK(svg.find("<path id=\"reflecting-left-0\" data-face=\"0\"") != std::string::npos);
  CHECK(svg.find("<path id=\"reflecting-left-1\" data-face=\"1\"") != std::string::npos);
  CHECK(svg.find("reflecting-dark-") == std::string::npos);
}

TEST_CASE("the summary says what each panel is worth") {
  const Results results;
  const RunResult run =
      run_sightline({"analyze", (results.path() / "scene.toml").string(), "-o", (results.path() / "out").string()});
  CHECK(run.exit_code == 0);
  const auto lines = lines_of(run.out);
  const auto left = std::ranges::find_if(lines, [](const std::string& line) {
    return line.starts_with("down ") && line.find(" left ") != std::string::npos;
  });
  REQUIRE(left != lines.end());
  CHECK(left->find(" 1 ") != std::string::npos);
  CHECK(left->ends_with(" %"));
  CHECK(left->size() <= 80);
}
