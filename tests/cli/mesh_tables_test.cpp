// The tables of a scene file about its surface: what they mean, and each refusal with its line and its remedy.
#include <doctest/doctest.h>

#include "cli/scene/scene_file.h"
#include "geometry/numbers/errors.h"

namespace sightline::tests::mesh_tables_test {
using namespace cli;

namespace {

const std::string camera = "[[camera]]\nname = \"c\"\neye = [0, 0, 5]\ntarget = [0, 0, 0]\nfov_y_deg = 40\n";

SceneDescription scene_of(const std::string& surface) { return parse_scene(surface + camera, "dir/scene.toml"); }

SceneMesh mesh_with(const std::string& keys) { return scene_of("[mesh]\nfile = \"a.obj\"\n" + keys).meshes.at(0); }

std::string refusal(const std::string& surface) {
  try {
    static_cast<void>(scene_of(surface));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

struct Refused {
  std::string surface;
  std::string message;
};

const std::string file = "[mesh]\nfile = \"a.obj\"\n";

const std::vector<Refused> refused{
    {"mesh = 3\n", "dir/scene.toml:1: 'mesh' must be a table, [mesh], or an array of tables, [[mesh]]"},
    {"mesh = []\n", "dir/scene.toml:1: 'mesh' must be a table, [mesh], or an array of tables, [[mesh]]"},
    {"mesh = [1]\n", "dir/scene.toml:1: 'mesh' must be a table, [mesh], or an array of tables, [[mesh]]"},
    {file + "place = 1\n",
     "dir/scene.toml:3: unknown key 'place' in [mesh]; it can have: file, name, sides, placement, up_axis, units, "
     "scale; correct or remove it"},
    {file + "up_axis = \"w\"\n", "dir/scene.toml:3: 'up_axis' must be \"x\", \"y\" or \"z\""},
    {file + "units = \"km\"\n", "dir/scene.toml:3: 'units' must be \"mm\", \"cm\", \"m\", \"in\" or \"ft\""},
    {file + "scale = 0\n", "dir/scene.toml:3: 'scale' must be above 0; for a mirror image use 'placement'"},
    {file + "units = \"m\"\nscale = 2\n", "dir/scene.toml:4: the mesh has both 'units' and 'scale'; give at most one"},
    {file + "placement = [1, 2]\n", "dir/scene.toml:3: 'placement' must be of the form [number, ...] with 4 entries"},
    {file + "placement = [[1, 0, 0, 0], [0, 1, 0, 0]]\n",
     "dir/scene.toml:3: 'placement' must be a matrix of 3 or 4 rows with 4 entries each"},
    {file + "placement = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 2]]\n",
     "dir/scene.toml:3: the last row of 'placement' must be [0, 0, 0, 1]; divide the matrix by its last entry"},
    {file + "placement = [[1, 0, 0, 0], [0, 1, 0, 0], [1, 1, 0, 0]]\n",
     "dir/scene.toml:3: 'placement' is singular: it flattens the mesh; give its first three columns rank 3"},
    {file + "name = \"a/b\"\n",
     "dir/scene.toml:3: the mesh's name, \"a/b\", has one of / \\ : * ? \" < > |; give it another 'name'"},
    {"[[mesh]]\nfile = \"a.obj\"\n[[mesh]]\nfile = \"b/a.obj\"\n",
     "dir/scene.toml:3: a second mesh is called \"a\"; give each another 'name'"},
    {"[[mesh]]\nfile = \"a.obj\"\nsides = \"both\"\n[[mesh]]\nfile = \"b.obj\"\nsides = \"both\"\n",
     "dir/scene.toml:6: 'sides' is of the whole scene; give it once"},
    {file + "[regions]\nmirrors = [\"a\"]\n",
     "dir/scene.toml:4: unknown key 'mirrors' in [regions]; it can have: of_interest, ignore; correct or remove it"},
    {file + "[regions]\nignore = []\n", "dir/scene.toml:4: 'ignore' is empty; name regions, or leave it out"},
    {file + "[regions]\nignore = \"a\"\n", "dir/scene.toml:4: 'ignore' must be of the form [\"text\", ...]"},
    {file + "[regions]\nignore = [1]\n", "dir/scene.toml:4: 'ignore' must be made of texts in quotes"},
    {file + "[reflection]\nmirrors_material = {}\n",
     "dir/scene.toml:4: 'mirrors_material' says nothing; give illum = [...], Ks_min = ..., or both"},
    {file + "[reflection]\nmirrors_material = { illum = [1.5] }\n",
     "dir/scene.toml:4: 'illum' must be a list of integers: those that MTL files have"},
    {file + "[reflection]\nmirrors_material = { Ks = 1 }\n",
     "dir/scene.toml:4: unknown key 'Ks' in 'mirrors_material'; it can have: illum, Ks_min; correct or remove it"},
};

}  // namespace

TEST_CASE("one mesh: a table; several: an array of tables, each with its file's name unless it is given another") {
  const SceneDescription one = scene_of("[mesh]\nfile = \"sub/a.obj\"\n");
  REQUIRE(one.meshes.size() == 1);
  CHECK(one.meshes[0].file == "dir/sub/a.obj");
  CHECK(one.meshes[0].name == "");
  CHECK(one.meshes[0].placement.changes_nothing());
  const SceneDescription two =
      scene_of("[[mesh]]\nfile = \"sub/a.obj\"\n[[mesh]]\nfile = \"b.obj\"\nname = \"screen\"\nsides = \"front\"\n");
  REQUIRE(two.meshes.size() == 2);
  CHECK(two.meshes[0].name == "a");
  CHECK(two.meshes[1].name == "screen");
  CHECK(two.meshes[1].file == "dir/b.obj");
  CHECK(two.mesh_file == "dir/sub/a.obj");
  CHECK(two.sides == SidesPolicy::front);
}

TEST_CASE("a placement has 3 rows or 4, units are exact, and the upwards axis is named") {
  const std::string rows = "[0, -1, 0, 3], [1, 0, 0, 0.5], [0, 0, 1, -2]";
  const SceneMesh three = mesh_with("placement = [" + rows + "]\nunits = \"in\"\nup_axis = \"z\"\n");
  const SceneMesh four = mesh_with("placement = [" + rows + ", [0, 0, 0, 1]]\nscale = 0.5\n");
  CHECK(three.placement.matrix == four.placement.matrix);
  CHECK(three.placement.matrix(0, 1) == -1);
  CHECK(three.placement.matrix(1, 3) == 0.5);
  CHECK(three.placement.up_axis == UpAxis::z);
  CHECK(three.placement.length.numerator / three.placement.length.denominator == 0.0254);
  CHECK(four.placement.length.numerator == 0.5);
}

TEST_CASE("regions are chosen by name, and mirrors by material, too") {
  const SceneDescription scene =
      scene_of(file +
               "[regions]\nof_interest = [\"a\", \"b\"]\nignore = [\"c\"]\n[reflection]\nmode = \"exact\"\n"
               "mirrors = [\"d\"]\nmirrors_material = { illum = [3, 5], Ks_min = 0.5 }\n");
  CHECK(scene.regions.of_interest.value().names == std::vector<std::string>{"a", "b"});
  CHECK(scene.regions.ignore.value().line == 5);
  CHECK(scene.regions.mirrors.value().names == std::vector<std::string>{"d"});
  CHECK(scene.regions.mirrors_material.value().illum == std::vector<int>{3, 5});
  CHECK(scene.regions.mirrors_material.value().specular_min == 0.5);
}

TEST_CASE("what is refused, with the line and what to do") {
  for (const Refused& r : refused) {
    INFO(r.surface);
    CHECK(refusal(r.surface) == r.message);
  }
}

}  // namespace sightline::tests::mesh_tables_test
