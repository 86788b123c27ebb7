#include "cli/scene/scene_file.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>
#include <string>
#include <vector>

#include "geometry/numbers/errors.h"
#include "tests/tools/says_what_to_do.h"

namespace sightline::tests::scene_file_test {
using namespace cli;

namespace {

const std::string mesh_part = "[mesh]\nfile = \"a.obj\"\n";  // lines 1 and 2
const std::string pinhole = "[[camera]]\nname = \"front\"\neye = [0, 0, 5]\ntarget = [0, 0, 0]\nfov_y_deg = 40\n";
const std::string good = mesh_part + pinhole;

struct WrongScene {
  std::string text;
  std::size_t line;
  std::string says;
};

void check_refused(const WrongScene& wrong) {
  INFO(wrong.text);
  try {
    static_cast<void>(parse_scene(wrong.text, "dir/scene.toml"));
    FAIL_CHECK("the scene was accepted");
  } catch (const InputError& error) {
    const std::string what = error.what();
    INFO(what);
    CHECK(error.line() == wrong.line);
    CHECK(std::ranges::none_of(what, [](char c) { return static_cast<unsigned char>(c) < 0x20; }));
    CHECK(what.find(wrong.says) != std::string::npos);
    CHECK(says_what_to_do(what));
    CHECK(what.rfind(wrong.line == 0 ? "dir/scene.toml: " : "dir/scene.toml:" + std::to_string(wrong.line) + ": ", 0) ==
          0);
  }
}

std::string with(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return std::string(text).replace(at, from.size(), to);
}

const std::string matrix = "[[500, 0, 320, 1600], [0, 500, 240, 1200], [0, 0, 1, 5]]";
const std::string matrix_camera = "[[camera]]\nname = \"p\"\nP = " + matrix + "\nimage = [640, 480]\n";
std::string panel(const std::string& corners) { return "[[panel]]\nname = \"left\"\ncorners = " + corners + "\n"; }
const std::string placed = "[[panel]]\nname = \"left\"\ncenter = [1, 2, 3]\n";  // lines 8 to 10
const std::string square = "[[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]]";

}  // namespace

TEST_CASE("a scene file gives the mesh, the sides and every form of camera") {
  const std::string text = mesh_part + "sides = \"front\"\n" + pinhole + "aspect = 1.5\nnear = 1\nfar = 9.5\n" +
                           "[[camera]]\nname = \"sun\"\neye = [9, 9, 9]\ntarget = [0, 0, 0]\nup = [0, 0, 1]\n"
                           "orthographic_height = 2.0\n" +
                           matrix_camera + "pixel_origin = \"center\"\n" +
                           "[[camera]]\nname = \"krt\"\nK = [[500, 0, 320], [0, 500, 240], [0, 0, 1]]\n"
                           "R = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\nt = [0, 0, 5]\nimage = [640, 480]\n";
  const SceneDescription scene = parse_scene(text, "dir/scene.toml");
  CHECK(scene.file == "dir/scene.toml");
  CHECK(scene.mesh_file == "dir/a.obj");
  CHECK(scene.sides == SidesPolicy::front);
  REQUIRE(scene.cameras.size() == 4);
  CHECK(scene.cameras[0].name == "front");
  CHECK(scene.cameras[0].aspect == 1.5);
  CHECK(scene.cameras[0].near_distance == 1.0);
  CHECK(scene.cameras[0].far_distance == 9.5);
  CHECK(scene.cameras[0].eye.xyz == Vector3{0, 0, 5});
  CHECK(scene.cameras[1].projection == Projection::orthographic);
  CHECK(scene.cameras[1].eye.w == 0);
  CHECK(scene.cameras[2].origin == Point3{0, 0, -5});
  CHECK(scene.cameras[3].origin == Point3{0, 0, -5});
  CHECK(scene.cameras[3].right == Vector3{500.0 / 320, 0, 0});
  CHECK(scene.cameras[2].right == Vector3{500.0 / 320, 0, 1.0 / 640});
}

TEST_CASE("sides are automatic where the file does not say, and an absolute mesh path stays") {
  const SceneDescription scene = parse_scene(with(good, "a.obj", "/meshes/a.obj"), "dir/scene.toml");
  CHECK(scene.sides == SidesPolicy::automatic);
  CHECK(scene.mesh_file == "/meshes/a.obj");
}

TEST_CASE("panels have names, corners and sides that shine") {
  CHECK(parse_scene(good, "scene.toml").panels.empty());
  const SceneDescription scene = parse_scene(good + panel(square) + "[[panel]]\nname = \"right\"\ncorners = " + square +
                                                 "\nemits = \"front\"\n" + "[reflection]\nmode = \"exact\"\n",
                                             "scene.toml");
  REQUIRE(scene.panels.size() == 2);
  CHECK(scene.panels[0].name == "left");
  CHECK(scene.panels[0].emits == Emits::both);
  CHECK(scene.panels[0].corners == std::vector<Point3>{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}});
  CHECK(scene.panels[1].emits == Emits::front);
}

TEST_CASE("how reflections are found") {
  const auto options_of = [](const std::string& lines) {
    return parse_scene(good + "[reflection]\n" + lines, "scene.toml").reflection;
  };
  CHECK(parse_scene(good, "scene.toml").reflection.mode == ReflectionMode::exact);
  CHECK(options_of("mode = \"exact\"\n").mode == ReflectionMode::exact);
  CHECK(options_of("mode = \"triangles\"\n").mode == ReflectionMode::triangles);
  CHECK(options_of("mode = \"triangles\"\n").normals == MirrorNormals::vertex);
  CHECK(options_of("mode = \"triangles\"\nnormals = \"face\"\n").normals == MirrorNormals::face);
  CHECK(options_of("mode = \"smooth\"\n").tolerance == 1e-3);
  CHECK(options_of("mode = \"smooth\"\ntolerance = 0.25\n").tolerance == 0.25);
}

TEST_CASE("panels by their middle, their front, and their size or radius") {
  const auto corners_of = [](const std::string& lines) {
    return parse_scene(good + placed + lines, "scene.toml").panels.at(0).corners;
  };
  const std::vector<Point3> upright{{0, 0, 3}, {2, 0, 3}, {2, 4, 3}, {0, 4, 3}};
  CHECK(corners_of("normal = [0, 0, 9]\nsize = [2, 4]\n") == upright);
  CHECK(corners_of("target = [1, 2, 9]\nsize = [2, 4]\n") == upright);
  CHECK(corners_of("target = [1, 2, 9]\nsize = [4, 2]\nup = [-5, 0, 1]\n") ==
        std::vector<Point3>{{2, 0, 3}, {2, 4, 3}, {0, 4, 3}, {0, 0, 3}});
  const std::vector<Point3> disc = corners_of("normal = [1, 1, 1]\nradius = 5\n");
  CHECK(disc.size() == 64);
  Vector3 twice_area = Vector3::Zero();
  for (std::size_t i = 0; i < 64; ++i) {
    CHECK(norm(disc[i] - Point3(1, 2, 3)) == doctest::Approx(5).epsilon(1e-3));
    CHECK(norm(0.5 * (disc[i] + disc[(i + 1) % 64]) - Point3(1, 2, 3)) == doctest::Approx(5).epsilon(1e-3));
    twice_area += (disc[i] - Point3(1, 2, 3)).cross(disc[(i + 1) % 64] - Point3(1, 2, 3));
  }
  CHECK(twice_area.dot(Vector3(1, 1, 1)) / std::sqrt(3.0) / 2 == doctest::Approx(25 * std::numbers::pi));
}

TEST_CASE("characters beyond ASCII are welcome in quotes and comments, and brackets at the start of a row") {
  const auto mesh_called = [](const std::string& quoted) {
    return parse_scene("\xEF\xBB\xBF# \u00e9 [\n" + with(good, "\"a.obj\"", quoted), "scene.toml").mesh_file;
  };
  CHECK(mesh_called("\"\u00e9\\\".obj\"") == "\u00e9\".obj");
  CHECK(mesh_called("'\u00e9\\'") == "\u00e9\\");
  CHECK(mesh_called("'''\n\u00e9\\''''") == "\u00e9\\'");
  CHECK(mesh_called("\"\"\"\u00e9\\\"\"\"\"\"") == "\u00e9\"\"");
  CHECK(mesh_called("\"\"\"a\\ \n  \u00e9\"\"\"") == "a\u00e9");
  const std::string rows = "[\n[500, 0, 320, 1600],\n\t[0, 500, 240, 1200], # [ \u00e9\n[0, 0, 1, 5]]";
  CHECK_NOTHROW((void)parse_scene(with(mesh_part + matrix_camera, matrix, rows), "scene.toml"));
}

TEST_CASE("what is wrong in a scene file is named with key and line") {
  const std::string twice = good + pinhole;
  const std::vector<WrongScene> scenes = {
      {"[mesh", 1, "not valid TOML"},
      {mesh_part + "a = [2, f\n]\n", 3, "not valid TOML: "},
      {mesh_part + "[[{ a = 1", 3, "not valid TOML: Error while parsing key: expected bare key"},
      {mesh_part + "[ ]\n", 3, "tables with blank bare keys are explicitly prohibited"},
      {mesh_part + "a = [\n[1],\n[ ]]\n[\n", 6, "not valid TOML: Error while parsing key: expected bare key"},
      {mesh_part + "a\u00e9 = 1\n", 3, "expected '=', saw '\\xc3\\xa9'"},
      {mesh_part + "a = 1 \u00a1\n", 3, "expected a comment or whitespace, saw '\\xc2\\xa1'"},
      {mesh_part + "a = \"\"\u2028\n", 3, "expected a comment or whitespace, saw '\\xe2\\x80\\xa8'"},
      {mesh_part + "a = \"\"\"\"\n\u00e9\\\"\"\"\"\"\"\u00e9", 4, "expected a comment or whitespace, saw '\\xc3\\xa9'"},
      {mesh_part + "a = \"\"\"\\\uFEFE\"\"\"\n", 3, "unknown escape sequence"},
      {mesh_part + "file = \"b.obj\"\n", 3, "not valid TOML"},
      {"", 0, "no [mesh]"},
      {pinhole, 0, "no [mesh]"},
      {"mesh = 3\n" + pinhole, 1, "'mesh' must be a table"},
      {mesh_part, 0, "no [[camera]]"},
      {"camera = []\n" + mesh_part, 1, "no [[camera]]"},
      {"camera = [1]\n" + mesh_part, 1, "must be an array of tables"},
      {mesh_part + "[camera]\nname = \"front\"\n", 3, "must be an array of tables"},
      {mesh_part + "[panel]\n" + pinhole, 3, "'panel' must be an array of tables"},
      {good + "[[panel]]\n", 8, "[[panel]] has no 'name'"},
      {good + "[[panel]]\nname = \"a b\"\n", 9, "has a space"},
      {good + "[[panel]]\nname = \"a/b\"\n", 9, "has one of /"},
      {good + "[[panel]]\nname = \"a\"\n", 8, "none of corners, size, radius"},
      {good + panel("[[0, 0, 0], [1, 0, 0]]"), 10, "panel \"left\": too few corners"},
      {good + panel("[[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0.5]]"), 10, "its corners are not in one plane"},
      {good + panel("[[0, 0, 0], [1, 0, 0], [1, 1]]"), 10, "'corners' must be of the form"},
      {good + panel("[0, 0, 0]"), 10, "'corners' must be of the form"},
      {good + panel("7"), 10, "'corners' must be of the form [[x, y, z], ...]"},
      {good + panel(square) + "emits = \"back\"\n", 11, "'emits' must be \"front\" or \"both\""},
      {good + panel(square) + "colour = 1\n", 11, "unknown key 'colour' in [[panel]]"},
      {good + panel(square) + "radius = 1\n", 11, "both 'corners' and 'radius'"},
      {good + panel(square) + "up = [0, 1, 0]\n", 11, "unknown key 'up' in [[panel]]"},
      {good + panel(square) + "planarity = -1\n", 11, "'planarity' must be at least 0 and below 1"},
      {good + placed + "size = [1, 2]\n", 8, "either 'normal' or 'target'"},
      {good + placed + "size = [1, 2]\nnormal = [0, 0, 0]\n", 12, "the panel's front looks nowhere"},
      {good + placed + "size = [1, 2]\ntarget = [1, 2, 3]\n", 12, "the panel's front looks nowhere"},
      {good + placed + "size = [1, 0]\nnormal = [0, 0, 1]\n", 11, "'size' must be above 0"},
      {good + placed + "size = [1, 2]\nnormal = [0, 2, 0]\n", 8, "'up' is along its normal; choose another 'up'"},
      {good + placed + "radius = 0\nnormal = [0, 0, 1]\n", 11, "'radius' must be above 0"},
      {good + placed + "radius = 1.7976e308\nnormal = [9, 9, 1]\n", 11, "too large for double arithmetic"},
      {good + "[coincidence]\ndistance = 1\n", 9, "'distance' must be at least 0 and below 1"},
      {good + "[coincidence]\npolicy = \"weld\"\n", 9, "'policy' must be \"exact\" or \"snap\""},
      {"coincidence = 1\n" + good, 1, "'coincidence' must be a table"},
      {good + panel(square) + panel(square), 12, "a second panel is called \"left\""},
      {good + "[reflection]\nmode = \"rough\"\n", 9, "'mode' must be \"exact\", \"triangles\" or \"smooth\""},
      {good + "[reflection]\nmode = \"smooth\"\ntolerance = 0\n", 10, "'tolerance' must be between 0 and 1"},
      {good + "[reflection]\nmode = \"exact\"\ntolerance = 0.1\n", 10, "'tolerance' is for mode \"smooth\" only"},
      {good + "[reflection]\nnormals = \"face\"\n", 9, "'normals' is for mode \"triangles\" only"},
      {good + "[reflection]\nmode = \"triangles\"\nnormals = \"up\"\n", 10, "'normals' must be \"face\" or \"vertex\""},
      {good + "[reflection]\nmade = \"exact\"\n", 9, "unknown key 'made' in [reflection]"},
      {"reflection = 1\n" + good, 1, "'reflection' must be a table"},
      {"colour = 1\n" + good, 1, "unknown key 'colour' in the scene file"},
      {"\"one\\ntwo\" = 1\n" + good, 1, "unknown key 'one\\x0atwo' in the scene file"},
      {mesh_part + "side = \"auto\"\n" + pinhole, 3, "unknown key 'side' in [mesh]; it can have: file, name, sides"},
      {good + "zoom = 1\nfocus = 2\n", 8, "unknown key 'zoom' in [[camera]]"},
      {good + "image = [1, 1]\n", 8, "unknown key 'image'"},
      {mesh_part + matrix_camera + "eye = [1, 2, 3]\n", 7, "unknown key 'eye'"},
      {with(good, "file = \"a.obj\"\n", "\n"), 1, "[mesh] has no 'file'"},
      {with(good, "\"a.obj\"", "7"), 2, "'file' must be a text"},
      {mesh_part + "sides = \"back\"\n" + pinhole, 3, "'sides' must be \"auto\", \"front\" or \"both\""},
      {mesh_part + "sides = 1\n" + pinhole, 3, "'sides' must be a text"},
      {with(good, "name = \"front\"\n", "\n"), 3, "[[camera]] has no 'name'"},
      {with(good, "eye = [0, 0, 5]\n", "\n"), 3, "[[camera]] has no 'eye'"},
      {with(good, "[0, 0, 5]", "[0, 0]"), 5, "'eye' must be of the form"},
      {with(good, "[0, 0, 5]", "5"), 5, "'eye' must be of the form"},
      {with(good, "[0, 0, 5]", "[0, 0,\n \"5\"]"), 6, "'eye' must be made of numbers"},
      {with(good, "[0, 0, 5]", "[0, 0, inf]"), 5, "'eye' must be finite"},
      {with(good, "= 40", "= true"), 7, "'fov_y_deg' must be made of numbers"},
      {with(good, "= 40", "= nan"), 7, "'fov_y_deg' must be finite"},
      {with(good, "= 40", "= 180"), 3, "field of view"},
      {with(good, "[0, 0, 5]", "[0, 0, 0]"), 3, "eye and target are the same point"},
      {good + "up = [0, 0, 1]\n", 3, "up is along the view direction"},
      {good + "near = 3\nfar = 2\n", 3, "near is not less than far"},
      {with(good, "fov_y_deg = 40\n", "\n"), 3, "none of fov_y_deg, orthographic_height, P, K"},
      {good + "orthographic_height = 2\n", 8, "both 'fov_y_deg' and 'orthographic_height'"},
      {good + "P = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]\n", 8, "both 'fov_y_deg' and 'P'"},
      {with(mesh_part + matrix_camera, "[0, 0, 1, 5]", "[0, 0, 1]"), 5, "'P' must be of the form"},
      {with(mesh_part + matrix_camera, ", [0, 0, 1, 5]", ""), 5, "'P' must be of the form"},
      {with(mesh_part + matrix_camera, "[0, 0, 1, 5]", "[500, 500, 560, 5]"), 3, "singular"},
      {with(mesh_part + matrix_camera, "[0, 0, 1, 5]", "[0, 0, 0, 0]"), 3, "singular"},
      {with(mesh_part + matrix_camera, "image = [640, 480]\n", ""), 3, "[[camera]] has no 'image'"},
      {with(mesh_part + matrix_camera, "[640, 480]", "[640, -480]"), 3, "height"},
      {mesh_part + matrix_camera + "pixel_origin = \"centre\"\n", 7, "'pixel_origin' must be"},
      {mesh_part + "[[camera]]\nname = \"k\"\nK = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\nimage = [2, 2]\n", 3, "no 'R'"},
      {twice, 9, "a second camera is called \"front\""},
  };
  for (const WrongScene& wrong : scenes) check_refused(wrong);
}

TEST_CASE("a camera's name becomes a folder and must be safe as one") {
  for (const char* name : {"", ".", "..", ".hidden", "../up", "a/b", "/etc", "a\\\\b", "a\\nb", "a\\u0000b",
                           "a\\u0085b", "-o", " a", "a ", "a.", "c:", "a*", "a\\u007f"}) {
    check_refused({with(good, "\"front\"", "\"" + std::string(name) + "\""), 4, "the camera's name"});
  }
  check_refused({with(good, "\"front\"", "\"" + std::string(101, 'a') + "\""), 4, "the camera's name"});
  for (const char* name : {"a", "front 2", "v1.5", "caf\u00e9", "_x-y", "\u524d"}) {
    CHECK(parse_scene(with(good, "\"front\"", "\"" + std::string(name) + "\""), "s.toml").cameras[0].name == name);
  }
}

TEST_CASE("a scene file that cannot be read is an error with its name") {
  CHECK_THROWS_WITH_AS(static_cast<void>(read_scene_file("/nowhere/scene.toml")),
                       doctest::Contains("/nowhere/scene.toml: the scene file cannot be read"), InputError);
  CHECK_THROWS_WITH_AS(static_cast<void>(read_scene_file(SIGHTLINE_FIXTURES_DIR)),
                       doctest::Contains("cannot be read: Is a directory"), InputError);
}

TEST_CASE("the bundled scenes are valid") {
  CHECK(read_scene_file(SIGHTLINE_FIXTURES_DIR "/fang/scene.toml").cameras.size() == 1);
  CHECK(read_scene_file(SIGHTLINE_FIXTURES_DIR "/demo/scene.toml").cameras.size() == 3);
}

}  // namespace sightline::tests::scene_file_test
