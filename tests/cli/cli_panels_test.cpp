// This tests panels in every output of the command.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/tools/command_runner.h"

namespace sightline::tests::cli_panels_test {

using Json = nlohmann::ordered_json;

namespace {

// The mirror of tests/reflect/reflection_test.cpp, in two triangles: the panel "left" is mirrored in the unit square around the
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
  CHECK(report["counts"]["faces"]["visible"] == 2);
  CHECK(report["counts"]["faces"]["reflecting"] == 2);
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
  const auto camera = std::ranges::find_if(lines, [](const std::string& line) { return line.starts_with("down "); });
  CHECK(camera->starts_with("down               2        2       0 "));
  CHECK(std::all_of(camera - 2, camera + 1, [](const std::string& line) { return line.size() <= 80; }));
  CHECK(left->size() <= 80);
}

namespace {

// A floor has 8 x 8 squares with sides of 1/2, two triangles each, and the panel "left" of above is a little larger.
struct TiledFloor : TemporaryFolder {
  TiledFloor() {
    std::string obj;
    for (int j = -4; j <= 4; ++j) {
      for (int i = -4; i <= 4; ++i) obj += fmt::format("v {} {} 0\n", i / 2.0, j / 2.0);
    }
    for (int j = 0; j < 8; ++j) {
      for (int i = 1; i <= 8; ++i) {
        const int low = 9 * j + i;
        obj += fmt::format("f {} {} {}\nf {} {} {}\n", low, low + 1, low + 10, low, low + 10, low + 9);
      }
    }
    static_cast<void>(file("floor.obj", obj));
  }

  // Returns the report of an analysis with these lines in [reflection].
  Json analysed(const std::string& reflection) {
    const std::string scene = file("scene.toml",
                                   "[mesh]\nfile = \"floor.obj\"\n[[camera]]\nname = \"down\"\nimage = [2, 2]\n"
                                   "pixel_origin = \"corner\"\nP = [[1, 0, -1, 6], [0, -1, -1, 4], [0, 0, -1, 4]]\n"
                                   "[[panel]]\nname = \"left\"\n"
                                   "corners = [[0.99, -1.01, 4], [3.01, -1.01, 4], [3.01, 1.01, 4], [0.99, 1.01, 4]]\n"
                                   "[reflection]\n" +
                                       reflection);
    const RunResult run = run_sightline({"analyze", scene, "--quiet", "-o", (path() / "out").string()});
    INFO(run.err);
    REQUIRE(run.exit_code == 0);
    return Json::parse(text("report.json"))["reflections"];
  }
  [[nodiscard]] std::string text(const std::string& name) const { return read_text(path() / "out" / "down" / name); }
};

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

}  // namespace

TEST_CASE("mode triangles: whole triangles, in the report, the labels and the picture") {
  TiledFloor floor;
  const Json reflections = floor.analysed("mode = \"triangles\"\nnormals = \"face\"\n");
  CHECK(reflections["mode"] == "triangles");
  CHECK(reflections["normals"] == "face");
  const Json& panel = reflections["panels"][0];
  CHECK(panel["triangles"] == 8);
  CHECK(panel["area"].get<double>() == doctest::Approx(1).epsilon(1e-9));
  CHECK(panel["image_area"].get<double>() == doctest::Approx(0.0625).epsilon(1e-9));
  CHECK(count(floor.text("view.svg"), "id=\"reflecting-left-") == 8);
  const std::string obj = floor.text("labelled.obj");
  const std::size_t group = obj.find("g visible reflecting_left\n");
  REQUIRE(group != std::string::npos);
  CHECK(count(obj.substr(group), "\nf ") == 8);
}

TEST_CASE("mode smooth: the same floor reflects as in mode exact, and the report says how near it came") {
  TiledFloor floor;
  const Json exact = floor.analysed("mode = \"exact\"\n");
  const Json smooth = floor.analysed("mode = \"smooth\"\ntolerance = 0.01\n");
  CHECK(smooth["mode"] == "smooth");
  CHECK(smooth["tolerance"] == 0.01);
  CHECK(smooth["reached"].get<double>() <= 0.01);
  CHECK_FALSE(exact.contains("tolerance"));
  const auto area = [](const Json& reflections) { return reflections["panels"][0]["area"].get<double>(); };
  CHECK(area(smooth) == doctest::Approx(area(exact)).epsilon(1e-9));
  CHECK(area(exact) == doctest::Approx(1.01 * 1.01).epsilon(1e-9));
  CHECK(smooth["panels"][0]["polygons"].get<int>() >= 8);
  CHECK(count(floor.text("view.svg"), "id=\"reflecting-left-") == smooth["panels"][0]["polygons"].get<std::size_t>());
}

TEST_CASE("normals that are not what they seem are warned of, and crease_angle_deg and means are read") {
  TemporaryFolder folder;
  const std::string corners = "v 0 0 0\nv 0 1 0\nv 1 1 0\nv 1 0 0\nv 0 0 2\nv 1 0 2\n";
  const std::string normals = "vn 0 0 -1\nvn 0 -1 0\n";
  static_cast<void>(folder.file("means.obj", corners + "f 1 2 3 4\nf 1 4 6 5\n"));
  static_cast<void>(folder.file("flat.obj", corners + normals + "f 1//1 2//1 3//1 4//1\nf 1//2 4//2 6//2 5//2\n"));
  static_cast<void>(folder.file("turned.obj", corners + "vn 0 0 1\nf 1//1 2//1 3//1 4//1\nf 1 4 6 5\n"));
  const auto warnings = [&](const std::string& mesh, const std::string& reflection) {
    const std::string scene = folder.file(
        "scene.toml", "[mesh]\nfile = \"" + mesh +
                          "\"\n[[camera]]\nname = \"c\"\neye = [3, -4, -2]\ntarget = [0, 0, 0]\nfov_y_deg = 40\n"
                          "[[panel]]\nname = \"p\"\ncorners = [[1, -1, 4], [3, -1, 4], [3, 1, 4]]\n[reflection]\n" +
                          reflection);
    const RunResult run = run_sightline({"analyze", scene, "--json"});
    CHECK(run.exit_code == 0);
    return run.exit_code == 0 ? Json::parse(run.out)["warnings"].dump() : run.err;
  };
  const std::string smooth = "mode = \"smooth\"\n";
  CHECK(warnings("flat.obj", smooth).find("those of its faces") != std::string::npos);
  CHECK(warnings("turned.obj", smooth).find("at 4 corners, first of face 0") != std::string::npos);
  CHECK(warnings("means.obj", smooth).find("up to 90 degrees (faces 0 and 1)") != std::string::npos);
  CHECK(warnings("means.obj", smooth + "crease_angle_deg = 45\nmeans = \"plain\"\n") == "[]");
  CHECK(warnings("flat.obj", "mode = \"exact\"\n") == "[]");
  const auto refusal = [&](const std::string& reflection) {
    const std::string scene = folder.file("bad.toml",
                                          "[mesh]\nfile = \"flat.obj\"\n[[camera]]\nname = \"c\"\neye = [3, -4, -2]\n"
                                          "target = [0, 0, 0]\nfov_y_deg = 40\n[reflection]\n" +
                                              reflection);
    return run_sightline({"analyze", scene, "--json"}).err;
  };
  CHECK(refusal("means = \"area\"\n").find("'means' is for modes that have vertex normals") != std::string::npos);
  CHECK(refusal(smooth + "crease_angle_deg = 200\n").find("must be from 0 to 180") != std::string::npos);
  CHECK(refusal(smooth + "means = \"angle\"\n").find("must be \"area\" or \"plain\"") != std::string::npos);
}

}  // namespace sightline::tests::cli_panels_test
