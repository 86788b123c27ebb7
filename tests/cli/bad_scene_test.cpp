// Scene files that are none, and cameras that are none, go through the command: it gives exit code 1 and one line, and
// writes nothing.
#include <doctest/doctest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>

#include "tests/tools/command_case.h"
#include "tests/tools/running_command.h"
#include "tests/tools/says_what_to_do.h"

namespace sightline::tests::bad_scene_test {

namespace {

namespace fs = std::filesystem;

const fs::path fixtures = fs::path(SIGHTLINE_FIXTURES_DIR) / "bad-scene";

struct SceneCase {
  std::string file;
  std::size_t line = 0;  // 0: of the file as a whole, or of the mesh
  std::string says;
};

const std::vector<SceneCase> cases{
    {"aspect_negative.toml", 4, "aspect"},
    {"camera_is_table.toml", 4, "'camera' must be an array of tables: [[camera]]"},
    {"cameras_are_numbers.toml", 1, "'camera' must be an array of tables: [[camera]]"},
    {"date_as_number.toml", 8, "'fov_y_deg' must be made of numbers"},
    {"deep_arrays.toml", 6, "not valid TOML"},
    {"deep_keys.toml", 4, "more than 1000 dots in one line"},
    {"deep_tables.toml", 4, "more than 1000 dots in one line"},
    {"duplicate_key.toml", 3, "not valid TOML"},
    {"duplicate_names.toml", 11, "a second camera is called \"front\""},
    {"empty.toml", 0, "there is no [mesh]"},
    {"eye_at_target.toml", 4, "eye"},
    {"eye_beyond_double.toml", 6, "not valid TOML"},
    {"eye_has_two_numbers.toml", 6, "'eye' must be of the form"},
    {"eye_huge_integer.toml", 6, "not valid TOML"},
    {"eye_infinite.toml", 6, "'eye' must be finite"},
    {"eye_is_text.toml", 6, "'eye' must be of the form"},
    {"eye_nan.toml", 6, "'eye' must be finite"},
    {"fov_half_turn.toml", 4, "field of view"},
    {"fov_nan.toml", 8, "'fov_y_deg' must be finite"},
    {"fov_zero.toml", 4, "field of view"},
    {"image_of_no_pixels.toml", 4, "image"},
    {"matrix_of_wrong_size.toml", 6, "'P' must be of the form"},
    {"matrix_of_zeros.toml", 4, "singular"},
    {"matrix_with_nan.toml", 6, "'P' must be finite"},
    {"mesh_is_folder.toml", 0, "is a directory, not a file of a mesh"},
    {"mesh_is_number.toml", 2, "'file' must be a text in quotes"},
    {"mesh_name_with_line_ends.toml", 0, "cannot be opened"},
    {"mesh_name_with_nul.toml", 2, "'file' has a NUL character"},
    {"missing_mesh.toml", 0, "absent.obj: cannot be opened"},
    {"name_empty.toml", 5, "is empty"},
    {"name_goes_up.toml", 5, "begins with a dot"},
    {"name_goes_up_deeper.toml", 5, "has one of /"},
    {"name_hidden.toml", 5, "begins with a dot"},
    {"name_is_absolute.toml", 5, "has one of /"},
    {"name_too_long.toml", 5, "is longer than 100 bytes"},
    {"name_with_backslash.toml", 5, "has one of /"},
    {"name_with_c1_control.toml", 5, "has a control character"},
    {"name_with_escape.toml", 5, "has a control character"},
    {"name_with_nul.toml", 5, "has a control character"},
    {"name_with_slash.toml", 5, "has one of /"},
    {"near_beyond_far.toml", 4, "near"},
    {"no_camera.toml", 0, "there is no [[camera]]"},
    {"no_mesh.toml", 0, "there is no [mesh]"},
    {"not_toml.toml", 1, "not valid TOML"},
    {"not_utf8.toml", 2, "not valid TOML"},
    {"nul_bytes.toml", 3, "not valid TOML"},
    {"obj_as_scene.toml", 1, "not valid TOML"},
    {"two_forms.toml", 9, "give exactly one"},
    {"unknown_table.toml", 10, "unknown key 'light'"},
    {"unterminated_text.toml", 2, "not valid TOML"},
    {"up_along_view.toml", 4, "up"},
    {"utf16.toml", 1, "not valid TOML"},
};

// The folder is gone afterwards; it is for files that cannot be kept.
struct Folder : TemporaryFolder {
  std::string mesh = file("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");

  [[nodiscard]] std::string scene(const std::string& cameras) const {
    return file("scene.toml", "[mesh]\nfile = \"triangle.obj\"\n" + cameras);
  }
  [[nodiscard]] Outcome run(const std::string& scene_file) const {
    return run_to_end({"analyze", scene_file, "--quiet", "-o", (path() / "out").string()});
  }
};

std::string camera(std::size_t number) {
  return "[[camera]]\nname = \"c" + std::to_string(number) +
         "\"\neye = [0.3, 0.3, 5]\ntarget = [0.3, 0.3, 0]\nfov_y_deg = 40\n";
}

void check_refused(const Folder& folder, const Outcome& outcome, const std::string& start, const std::string& says) {
  INFO(outcome.err);
  CHECK(outcome.exit_code == 1);
  CHECK(outcome.out.empty());
  CHECK(is_error_line(outcome.err, start));
  CHECK(says_what_to_do(outcome.err));
  CHECK(outcome.err.find(says) != std::string::npos);
  CHECK_FALSE(fs::exists(folder.path() / "out"));
}

}  // namespace

TEST_CASE("every bad scene has a case, and two that are odd are good") {
  std::vector<std::string> files{"byte_order_mark.toml", "eye_too_far_apart.toml", "triangle.obj"};
  for (const SceneCase& c : cases) files.push_back(c.file);
  std::ranges::sort(files);
  CHECK(files_in(fixtures) == files);
  const Folder folder;
  for (const char* file : {"byte_order_mark.toml", "eye_too_far_apart.toml"})
    CHECK(folder.run((fixtures / file).string()).exit_code == 0);
}

TEST_CASE("bad scenes are refused with file, line and cause") {
  const Folder folder;
  for (const SceneCase& c : cases) {
    INFO(c.file);
    const std::string file = (fixtures / c.file).string();
    const std::string start = c.line == 0 ? "" : file + ":" + std::to_string(c.line) + ": ";
    check_refused(folder, folder.run(file), start, c.says);
  }
}

TEST_CASE("scene files that cannot be read are refused") {
  const Folder folder;
  check_refused(folder, folder.run((folder.path() / "absent.toml").string()), (folder.path() / "absent.toml").string(),
                "No such file");
  fs::create_directory(folder.path() / "folder.toml");
  check_refused(folder, folder.run((folder.path() / "folder.toml").string()), (folder.path() / "folder.toml").string(),
                "Is a directory");
  if (getuid() == 0) return;  // root reads what nobody may read
  for (const char* name : {"scene.toml", "triangle.obj"}) {
    const std::string scene = folder.scene(camera(0));
    chmod((folder.path() / name).c_str(), 0);
    check_refused(folder, folder.run(scene), (folder.path() / name).string(), "");
    chmod((folder.path() / name).c_str(), 0600);
  }
}

TEST_CASE("a hundred thousand cameras are read in a moment, and two of one name are found among them") {
  const Folder folder;
  std::string cameras;
  for (std::size_t i = 0; i < 100000; ++i) cameras += camera(i);
  const std::string scene = folder.scene(cameras + camera(54321));
  const Outcome outcome = folder.run(scene);
  check_refused(folder, outcome, scene + ":500004: ", "a second camera is called \"c54321\"");
  CHECK(outcome.cpu_seconds < 60);
}

TEST_CASE("nesting of any depth is refused, not followed") {
  const Folder folder;
  const auto repeated = [](const std::string& text, std::size_t times) {
    std::string result;
    for (std::size_t i = 0; i < times; ++i) result += text;
    return result;
  };
  for (const std::string& deep :
       {"a = " + repeated("[", 1000000), "a = " + repeated("{a = ", 1000000), "a" + repeated(".a", 1000000) + " = 1",
        "[a" + repeated(".a", 1000000) + "]", "[[" + repeated("a.", 1000000) + "a]]",
        "a = {" + repeated("a.", 1000000) + "a = 1}", "a" + repeated(".\"a\"", 1000000) + " = 1"}) {
    const std::string scene = folder.scene(deep + "\n");
    check_refused(folder, folder.run(scene), scene + ":3: ", "");
  }
}

TEST_CASE("the deepest nesting that is not refused for its depth is not followed too far") {
  const Folder folder;
  std::string keys = "a";
  for (int i = 0; i < 999; ++i) keys += ".a";
  std::string value = "1";
  for (int i = 0; i < 200; ++i) value = "{a = " + value + "}";
  const std::string scene = folder.scene("[" + keys + "]\n" + keys + " = " + value + "\n");
  check_refused(folder, folder.run(scene), scene + ":3: ", "unknown key 'a'");
}

}  // namespace sightline::tests::bad_scene_test
