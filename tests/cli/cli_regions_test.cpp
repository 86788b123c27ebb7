// Regions and several meshes, through the command: laws that its tables keep, on the files as they are written.
#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/cli/result_snapshot.h"
#include "tests/tools/command_runner.h"
#include "tests/tools/obj_case.h"

namespace sightline::tests::cli_regions_test {
namespace {

namespace fs = std::filesystem;
using Row = std::map<std::string, std::string>;

// A box of twelve triangles with fronts outside, around a place; its first vertex has this number.
std::string box(double x, double y, double z, double half, int first) {
  std::ostringstream text;
  for (int i = 0; i < 8; ++i)
    text << "v " << x + ((i & 1) != 0 ? half : -half) << ' ' << y + ((i & 2) != 0 ? half : -half) << ' '
         << z + ((i & 4) != 0 ? half : -half) << '\n';
  for (const auto& f : {std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4}, std::array{2, 6, 7, 3},
                        std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}}) {
    text << "f " << first + f[0] << ' ' << first + f[1] << ' ' << first + f[2] << '\n';
    text << "f " << first + f[0] << ' ' << first + f[2] << ' ' << first + f[3] << '\n';
  }
  return text.str();
}

const std::string chrome = "newmtl chrome\nKs 0.9 0.9 0.9\nillum 3\nnewmtl clay\nKs 0.1 0.1 0.1\nillum 1\n";
const std::string left_box = "o left\ng boxes small\nusemtl chrome\n" + box(-1, 0, 0, 0.5, 1);
const std::string right_box = "o right\ng boxes\nusemtl clay\n" + box(1, 0, 0.5, 0.75, 9);
const std::string floor_plate = "o floor\ng\nusemtl clay\nv -3 -1 -3\nv -3 -1 3\nv 3 -1 3\nv 3 -1 -3\nf 17 18 19 20\n";
const std::string assembly = "mtllib paint.mtl\n" + left_box + right_box + floor_plate;

const std::string cameras =
    "[[camera]]\nname = \"front\"\neye = [0.5, 2, 7]\ntarget = [0, 0, 0]\nfov_y_deg = 40\n"
    "[[camera]]\nname = \"side\"\neye = [6, 3, -2]\ntarget = [0, 0, 0]\nfov_y_deg = 30\n"
    "[[panel]]\nname = \"lamp\"\ncorners = [[-40, 5, -40], [40, 5, -40], [40, 5, 40], [-40, 5, 40]]\n";

// A folder with the assembly and scenes of it.
struct Scenes : TemporaryFolder {
  Scenes() {
    static_cast<void>(file("all.obj", assembly));
    static_cast<void>(file("paint.mtl", chrome));
  }
  [[nodiscard]] RunResult run(const std::string& name, const std::string& surface,
                              const std::string& views = cameras) const {
    return run_sightline(
        {"analyze", file(name + ".toml", surface + views), "-o", (path() / name).string(), "--threads", "2"});
  }
  [[nodiscard]] fs::path out(const std::string& name, const std::string& result) const {
    return path() / name / result;
  }
};

const std::string whole = "[mesh]\nfile = \"all.obj\"\n";

// No cell of these tables has a comma.
std::vector<Row> rows_of(const fs::path& table) {
  const std::vector<std::string> lines = lines_of(read_text(table));
  const std::vector<std::string> head = split(lines.at(0), ',');
  std::vector<Row> rows;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::vector<std::string> cells = split(lines[i], ',');
    Row row;
    for (std::size_t c = 0; c < head.size(); ++c) row[head[c]] = c < cells.size() ? cells[c] : "";
    rows.push_back(row);
  }
  return rows;
}

double number(const Row& row, const std::string& column) {
  const std::string& cell = row.at(column);
  return cell.empty() ? 0 : std::stod(cell);
}

Row row_of(const std::vector<Row>& rows, const std::string& camera, const std::string& kind, const std::string& name) {
  for (const Row& row : rows) {
    if (row.at("camera") == camera && row.at("kind") == kind && row.at("name") == name) return row;
  }
  throw std::out_of_range("no row " + camera + " " + kind + " " + name);
}

bool is_close(double a, double b) { return std::fabs(a - b) <= 1e-12 * std::max({1.0, std::fabs(a), std::fabs(b)}); }

// Of the table of a camera's faces, from a number on.
double face_sum(const fs::path& table, const std::string& column, std::size_t first, std::size_t end) {
  double sum = 0;
  const std::vector<Row> rows = rows_of(table);
  for (std::size_t f = first; f < end; ++f) sum += number(rows.at(f), column);
  return sum;
}

const std::vector<std::string> area_columns{"area",       "in_view_area",       "visible_area",
                                            "image_area", "visible_image_area", "reflecting_area:lamp"};

void check_same_tables(const fs::path& one, const fs::path& other) {
  const std::vector<Row> first = rows_of(one);
  const std::vector<Row> second = rows_of(other);
  REQUIRE(first.size() == second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    for (const std::string& column : area_columns) {
      INFO("row " << i << ", column " << column);
      CHECK(is_close(number(first[i], column), number(second[i], column)));
    }
  }
}

}  // namespace

TEST_CASE("regions.csv: objects and materials add up to the whole, for each camera and for all together") {
  const Scenes scenes;
  const RunResult run = scenes.run("whole", whole);
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  const std::vector<Row> rows = rows_of(scenes.out("whole", "regions.csv"));
  for (const char* camera : {"front", "side", ""}) {
    const Row all = row_of(rows, camera, "all", "");
    for (const char* kind : {"object", "material"}) {
      std::map<std::string, double> sums;
      for (const Row& row : rows) {
        if (row.at("camera") != camera || row.at("kind") != kind) continue;
        for (const auto& [column, cell] : row) sums[column] += column.find("area") < 40 ? number(row, column) : 0;
        sums["faces"] += number(row, "faces");
      }
      for (const std::string& column : area_columns) CHECK(is_close(sums[column], number(all, column)));
      CHECK(sums["faces"] == 25);
      CHECK(is_close(sums["reflecting_area"], number(all, "reflecting_area")));
    }
    CHECK(number(row_of(rows, camera, "group", "boxes"), "faces") == 24);
    CHECK(number(row_of(rows, camera, "group", "small"), "faces") == 12);
    CHECK(number(row_of(rows, camera, "group", ""), "faces") == 1);
    CHECK(number(all, "visible_area") > 1);
    CHECK(number(all, "reflecting_area") > 0.1);
  }
  for (const Row& row : rows) CHECK(row.at("kind") != "smoothing");
}

TEST_CASE("regions.csv: a region's areas are the sums of its faces in faces.csv and coverage.csv") {
  const Scenes scenes;
  REQUIRE(scenes.run("whole", whole).exit_code == 0);
  const std::vector<Row> rows = rows_of(scenes.out("whole", "regions.csv"));
  for (const char* camera : {"front", "side"}) {
    const fs::path faces = scenes.out("whole", camera) / "faces.csv";
    for (const std::string& column : area_columns) {
      CHECK(is_close(number(row_of(rows, camera, "object", "left"), column), face_sum(faces, column, 0, 12)));
      CHECK(is_close(number(row_of(rows, camera, "object", "right"), column), face_sum(faces, column, 12, 24)));
      CHECK(is_close(number(row_of(rows, camera, "material", "clay"), column), face_sum(faces, column, 12, 25)));
    }
  }
  std::vector<Row> covered;
  for (const Row& row : rows_of(scenes.out("whole", "coverage.csv"))) {
    if (!row.at("face").empty()) covered.push_back(row);
  }
  double visible = 0;
  double reflecting = 0;
  for (std::size_t f = 0; f < 12; ++f) {
    visible += number(covered.at(f), "visible_area");
    reflecting += number(covered.at(f), "reflecting_area");
  }
  const Row left = row_of(rows, "", "object", "left");
  CHECK(is_close(number(left, "visible_area"), visible));
  CHECK(is_close(number(left, "reflecting_area"), reflecting));
  CHECK(is_close(number(left, "visible_share"), visible / 6));
  CHECK(left.at("image_area") == "");
}

TEST_CASE("a file that is divided into two meshes gives the same areas, face by face") {
  const Scenes scenes;
  static_cast<void>(scenes.file("first.obj", "mtllib paint.mtl\n" + left_box));
  // Its vertices are numbered from 1 again.
  static_cast<void>(scenes.file("rest.obj", "o right\n" + box(1, 0, 0.5, 0.75, 1) +
                                                "o floor\nv -3 -1 -3\nv -3 -1 3\nv 3 -1 3\nv 3 -1 -3\nf 9 10 11 12\n"));
  REQUIRE(scenes.run("whole", whole).exit_code == 0);
  const RunResult run = scenes.run("two", "[[mesh]]\nfile = \"first.obj\"\n[[mesh]]\nfile = \"rest.obj\"\n");
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  for (const char* camera : {"front", "side"})
    CHECK(read_text(scenes.out("whole", camera) / "faces.csv") == read_text(scenes.out("two", camera) / "faces.csv"));
  CHECK(read_text(scenes.out("whole", "coverage.csv")) == read_text(scenes.out("two", "coverage.csv")));
  const std::vector<Row> rows = rows_of(scenes.out("two", "regions.csv"));
  CHECK(number(row_of(rows, "", "mesh", "first"), "faces") == 12);
  CHECK(row_of(rows, "", "object", "right").at("mesh") == "rest");
  CHECK(number(row_of(rows, "front", "mesh", "rest"), "visible_area") ==
        doctest::Approx(face_sum(scenes.out("two", "front") / "faces.csv", "visible_area", 12, 25)));
  const auto report = nlohmann::json::parse(read_text(scenes.out("two", "front") / "report.json"));
  CHECK(report["scene"]["meshes"][1]["first_face"] == 12);
  CHECK(report["scene"]["meshes"][1]["name"] == "rest");
  CHECK(run.out.find("first.obj and 1 more: 20 vertices, 25 faces") != std::string::npos);
}

TEST_CASE("what is ignored is neither seen nor in the way: as a file without it, and the others keep their numbers") {
  const Scenes scenes;
  static_cast<void>(scenes.file("without.obj", "mtllib paint.mtl\n" + left_box + "o floor\ng\nusemtl clay\n" +
                                                   "v -3 -1 -3\nv -3 -1 3\nv 3 -1 3\nv 3 -1 -3\nf 9 10 11 12\n"));
  REQUIRE(scenes.run("whole", whole).exit_code == 0);
  REQUIRE(scenes.run("ignoring", whole + "[regions]\nignore = [\"right\"]\n").exit_code == 0);
  REQUIRE(scenes.run("without", "[mesh]\nfile = \"without.obj\"\n").exit_code == 0);
  for (const char* camera : {"front", "side"}) {
    const std::vector<Row> left_out = rows_of(scenes.out("ignoring", camera) / "faces.csv");
    const std::vector<Row> never_there = rows_of(scenes.out("without", camera) / "faces.csv");
    REQUIRE(left_out.size() == 25);
    REQUIRE(never_there.size() == 13);
    for (std::size_t f = 0; f < 25; ++f) {
      if (f >= 12 && f < 24) {
        CHECK(left_out[f].at("facing") == "skipped");
        continue;
      }
      for (const std::string& column : area_columns)
        CHECK(left_out[f].at(column) == never_there[f < 12 ? f : 12].at(column));
    }
  }
  CHECK(number(row_of(rows_of(scenes.out("ignoring", "regions.csv")), "", "object", "floor"), "visible_area") >
        number(row_of(rows_of(scenes.out("whole", "regions.csv")), "", "object", "floor"), "visible_area"));
}

TEST_CASE("moving the mesh is moving cameras and panels the other way round") {
  const Scenes scenes;
  // A quarter turn around y and a step: x = z' - 2, y = y' + 1, z = -x' for places (x', y', z') of the file.
  const std::string placed =
      "[mesh]\nfile = \"all.obj\"\nplacement = [[0, 0, 1, -2], [0, 1, 0, 1], [-1, 0, 0, 0], [0, 0, 0, 1]]\n";
  const std::string turned_cameras =
      "[[camera]]\nname = \"front\"\neye = [5, 3, -0.5]\ntarget = [-2, 1, 0]\nfov_y_deg = 40\n"
      "[[camera]]\nname = \"side\"\neye = [-4, 4, -6]\ntarget = [-2, 1, 0]\nfov_y_deg = 30\n"
      "[[panel]]\nname = \"lamp\"\ncorners = [[-42, 6, 40], [-42, 6, -40], [38, 6, -40], [38, 6, 40]]\n";
  REQUIRE(scenes.run("whole", whole).exit_code == 0);
  REQUIRE(scenes.run("placed", placed, turned_cameras).exit_code == 0);
  check_same_tables(scenes.out("whole", "regions.csv"), scenes.out("placed", "regions.csv"));
}

TEST_CASE("a mirror image seen from the mirrored place, with only fronts, is what it was") {
  const Scenes scenes;
  const std::string mirrored =
      "[mesh]\nfile = \"all.obj\"\nsides = \"front\"\nplacement = [[-1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]\n";
  const std::string mirrored_cameras =
      "[[camera]]\nname = \"front\"\neye = [-0.5, 2, 7]\ntarget = [0, 0, 0]\nfov_y_deg = 40\n"
      "[[camera]]\nname = \"side\"\neye = [-6, 3, -2]\ntarget = [0, 0, 0]\nfov_y_deg = 30\n"
      "[[panel]]\nname = \"lamp\"\ncorners = [[-40, 5, -40], [40, 5, -40], [40, 5, 40], [-40, 5, 40]]\n";
  REQUIRE(scenes.run("whole", whole + "sides = \"front\"\n").exit_code == 0);
  REQUIRE(scenes.run("mirrored", mirrored, mirrored_cameras).exit_code == 0);
  check_same_tables(scenes.out("whole", "regions.csv"), scenes.out("mirrored", "regions.csv"));
  CHECK(number(row_of(rows_of(scenes.out("mirrored", "regions.csv")), "front", "object", "left"), "visible_area") > 1);
}

TEST_CASE("of_interest: shares and sums are those of its faces, in coverage.csv, report and summary") {
  const Scenes scenes;
  const RunResult run = scenes.run("whole", whole + "[regions]\nof_interest = [\"small\", \"object:right\"]\n");
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  double visible = 0;
  double area = 0;
  for (const Row& row : rows_of(scenes.out("whole", "coverage.csv"))) {
    if (row.at("face").empty() || row.at("face") == "24") continue;
    visible += number(row, "visible_area");
  }
  area = 6 * 1.0 + 6 * 2.25;
  const std::vector<Row> rows = rows_of(scenes.out("whole", "coverage.csv"));
  const Row* together = nullptr;
  for (const Row& row : rows) {
    if (row.at("face").empty() && row.at("camera").empty() && row.at("panel").empty()) together = &row;
  }
  REQUIRE(together != nullptr);
  CHECK(is_close(number(*together, "visible_area"), visible));
  CHECK(is_close(number(*together, "visible_share"), visible / area));
  const Row chosen = row_of(rows_of(scenes.out("whole", "regions.csv")), "", "of_interest", "");
  CHECK(is_close(number(chosen, "visible_area"), visible));
  const auto report = nlohmann::json::parse(read_text(scenes.out("whole", "front") / "report.json"));
  CHECK(report["areas"]["of_interest"]["faces"] == 24);
  CHECK(is_close(report["areas"]["of_interest"]["surface"], area));
  CHECK(is_close(report["areas"]["of_interest"]["visible"],
                 face_sum(scenes.out("whole", "front") / "faces.csv", "visible_area", 0, 24)));
  CHECK(is_close(report["reflections"]["panels"][0]["area_of_interest"],
                 face_sum(scenes.out("whole", "front") / "faces.csv", "reflecting_area:lamp", 0, 24)));
  CHECK(run.out.find("of interest: 24 faces, area 19.5") != std::string::npos);
}

TEST_CASE("mirrors by name and by material: others reflect nothing, and block; in each mode") {
  const Scenes scenes;
  for (const char* mode : {"exact", "triangles", "smooth"}) {
    const std::string reflection = std::string("[reflection]\nmode = \"") + mode + "\"\n" +
                                   (mode == std::string("exact") ? "" : "crease_angle_deg = 30\n");
    REQUIRE(scenes.run("all", whole + reflection).exit_code == 0);
    REQUIRE(scenes.run("named", whole + reflection + "mirrors = [\"right\"]\n").exit_code == 0);
    REQUIRE(
        scenes.run("made", whole + reflection + "mirrors_material = { illum = [1, 2], Ks_min = 0.1 }\n").exit_code ==
        0);
    const auto reflecting = [&](const char* run, const char* object) {
      return number(row_of(rows_of(scenes.out(run, "regions.csv")), "", "object", object), "reflecting_area");
    };
    INFO(mode);
    CHECK(reflecting("all", "left") > 0.1);
    CHECK(reflecting("named", "left") == 0);
    CHECK(reflecting("named", "floor") == 0);
    CHECK(reflecting("named", "right") == doctest::Approx(reflecting("all", "right")).epsilon(0.01));
    CHECK(reflecting("made", "left") == 0);
    CHECK(reflecting("made", "right") == doctest::Approx(reflecting("all", "right")).epsilon(0.01));
    CHECK(reflecting("made", "floor") == doctest::Approx(reflecting("all", "floor")).epsilon(0.01));
  }
}

TEST_CASE("what is of interest, or mirrors, and is ignored altogether is refused") {
  const Scenes scenes;
  for (const std::string key : {"[regions]\nof_interest", "[reflection]\nmirrors"}) {
    const std::string ignored = key.starts_with("[regions]") ? "\nignore" : "\n[regions]\nignore";
    const RunResult run = scenes.run("none", whole + key + " = [\"right\"]" + ignored + " = [\"right\"]\n");
    CHECK(run.exit_code == 1);
    CHECK(run.err.find("none.toml:4: '" + key.substr(key.find('\n') + 1) + "': all of its faces are ignored, too") !=
          std::string::npos);
    CHECK(scenes.run("some", whole + key + " = [\"right\", \"left\"]" + ignored + " = [\"right\"]\n").exit_code == 0);
  }
}

TEST_CASE("a name that no region has is refused with those that there are; so are materials that none is like") {
  const Scenes scenes;
  const RunResult run = scenes.run("whole", whole + "[regions]\nignore = [\"rigth\"]\n");
  CHECK(run.exit_code == 1);
  CHECK(
      run.err.ends_with("whole.toml:4: 'ignore': no region is called \"rigth\"; there are \"left\", \"right\", "
                        "\"floor\", \"boxes\", \"small\", \"chrome\", \"clay\"; correct the name, or leave it out\n"));
  CHECK_FALSE(fs::exists(scenes.path() / "whole"));
  const RunResult made = scenes.run("whole", whole + "[reflection]\nmirrors_material = { Ks_min = 0.95 }\n");
  CHECK(made.exit_code == 1);
  CHECK(
      made.err.ends_with("whole.toml:4: 'mirrors_material': no material is so; there are \"chrome\" (illum 3, Ks 0.9 "
                         "0.9 0.9), \"clay\" (illum 1, Ks 0.1 0.1 0.1); change its conditions, or look whether the "
                         "file that mtllib names is "
                         "beside the mesh\n"));
  std::string many = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (int i = 0; i < 15; ++i) many += "o part" + std::to_string(i) + "\nf 1 2 3\n";
  static_cast<void>(scenes.file("many.obj", many));
  const RunResult listed = scenes.run("many", "[mesh]\nfile = \"many.obj\"\n[regions]\nignore = [\"x\"]\n");
  CHECK(listed.err.find("\"part9\", and 5 more; correct the name") != std::string::npos);
  CHECK(listed.err.find("part10") == std::string::npos);
}

TEST_CASE("hostile names stay one line of the table, and no formula") {
  const Scenes scenes;
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";
  static_cast<void>(scenes.file("bad.obj", corners + "o =HYPERLINK(\"http://x\")\nf 1 2 3\no 3-7\nf 2 4 3\no a" +
                                               std::string(1, '\0') + "b\x1b[31m\xff\nf 1 4 3\no " +
                                               std::string(300000, 'n') + "\nf 1 2 4\n"));
  const RunResult run = scenes.run("bad", "[mesh]\nfile = \"bad.obj\"\n");
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  const std::string table = read_text(scenes.out("bad", "regions.csv"));
  CHECK(table.find(",object,,\"'=HYPERLINK(\"\"http://x\"\")\",1,") != std::string::npos);
  CHECK(table.find(",object,,'3-7,1,") != std::string::npos);
  CHECK(table.find(",object,,a\\x00b\\x1b[31m\\xff,1,") != std::string::npos);
  CHECK(table.find(",object,," + std::string(200, 'n') + ",1,") != std::string::npos);
  for (const std::string& line : lines_of(run.out)) CHECK(is_one_line(line));
}

TEST_CASE("the summary says how much of each object is seen, in 80 columns") {
  const Scenes scenes;
  const RunResult run = scenes.run("whole", whole);
  const std::vector<std::string> lines = lines_of(run.out);
  CHECK(std::ranges::find(lines, "object                           area seen by any     share reflecting     share") !=
        lines.end());
  const auto left = std::ranges::find_if(lines, [](const std::string& line) { return line.starts_with("left   "); });
  REQUIRE(left != lines.end());
  const Row row = row_of(rows_of(scenes.out("whole", "regions.csv")), "", "object", "left");
  char share[32];
  std::snprintf(share, sizeof share, " %.2f %% ", 100 * number(row, "visible_share"));
  CHECK(left->find(share) != std::string::npos);
  for (const std::string& line : lines) {
    if (line.find('/') == std::string::npos) CHECK(line.size() <= 80);
  }
  std::string many = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (int i = 0; i < 15; ++i) many += "g part" + std::to_string(i) + "\nf 1 2 3\n";
  static_cast<void>(scenes.file("many.obj", many));
  const RunResult groups = scenes.run("many", "[mesh]\nfile = \"many.obj\"\n");
  CHECK(groups.out.find("\ngroup     ") != std::string::npos);
  CHECK(groups.out.find("\nand 7 more in regions.csv\n") != std::string::npos);
}

}  // namespace sightline::tests::cli_regions_test
