#include "tests/tools/command_case.h"

#include <charconv>
#include <nlohmann/json.hpp>

#include "formats/importing/mesh_import.h"
#include "geometry/mesh/box_hierarchy.h"
#include "tests/tools/says_what_to_do.h"

namespace sightline::tests {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

Box bounds(const Mesh& mesh) {
  if (mesh.vertices.empty()) return {{-1, -1, -1}, {1, 1, 1}};
  Box box{mesh.vertices.front(), mesh.vertices.front()};
  for (const Point3& p : mesh.vertices) box = hull(box, {p, p});
  return box;
}

std::string as_option(const char* option, const Vector3& v) {
  std::string text = option;
  for (const double x : {v.x(), v.y(), v.z()}) {
    std::array<char, 40> digits{};
    *std::to_chars(digits.data(), digits.data() + digits.size() - 1, x).ptr = 0;
    text += (text.back() == '=' ? "" : ",") + std::string(digits.data());
  }
  return text;
}

// The camera looks from a corner of the room at the middle of the bounding box; any camera does for a file that is no
// mesh.
std::vector<std::string> camera_options(const fs::path& file) {
  Box box{{-1, -1, -1}, {1, 1, 1}};
  try {
    box = bounds(read_obj(file).mesh);
  } catch (const InputError&) {
  }
  const Vector3 middle = 0.5 * box.low + 0.5 * box.high;
  const double extent = std::max({box.high.x() - box.low.x(), box.high.y() - box.low.y(), box.high.z() - box.low.z()});
  const double size = extent > 0 ? extent : 1;
  return {as_option("--eye=", middle + size * Vector3{0.6, 0.7, 1.9}), as_option("--target=", middle), "--fov-y=60"};
}

bool some_warning_has(const Json& report, const std::string& part) {
  return std::ranges::any_of(report["warnings"], [&](const Json& warning) {
    return warning.get<std::string>().find(part) != std::string::npos;
  });
}

void check_report(const ObjCase& c, const Json& report) {
  const std::size_t facets = report["scene"]["facets"];
  if (c.facets != any_count) CHECK(facets == static_cast<std::size_t>(c.facets));
  if (c.area != any_area) CHECK(report["areas"]["surface"].get<double>() == doctest::Approx(c.area));
  if (facets == 0) CHECK(report["areas"]["image_visible"] == 0);
  CHECK(some_warning_has(report, "scene is empty") == (facets == 0));
  if (!c.warning.empty()) CHECK(some_warning_has(report, c.warning));
  for (const FaceDefect& d : c.defects) CHECK(some_warning_has(report, to_string(d.defect)));
  CHECK(report["counts"]["faces"]["skipped"] ==
        std::ranges::count_if(c.defects, [](const FaceDefect& d) { return is_skipped(d.defect); }));
}

void check_refusal(const tests::RunResult& run, const fs::path& results, const std::string& start) {
  CHECK(run.exit_code == 1);
  CHECK(run.out.empty());
  CHECK(is_error_line(run.err, start));
  CHECK(says_what_to_do(run.err));
  CHECK_FALSE(fs::exists(results));
}

}  // namespace

tests::RunResult analyze_all_of(const fs::path& file, const std::string& results) {
  std::vector<std::string> arguments{"analyze", file.string(), "--sides=both", "--json", "-o", results};
  const auto camera = camera_options(file);
  arguments.insert(arguments.end(), camera.begin(), camera.end());
  return tests::run_sightline(arguments);
}

bool is_error_line(const std::string& err, const std::string& start) {
  return err.starts_with("sightline: " + start) && err.ends_with('\n') && is_one_line(err.substr(0, err.size() - 1));
}

void check_command(const fs::path& folder, const ObjCase& c) {
  const tests::TemporaryFolder out;
  const fs::path file = folder / c.file;
  const fs::path results = out.path() / "results";
  const tests::RunResult run = analyze_all_of(file, results.string());
  INFO("file: " << c.file << ", exit code " << run.exit_code << ", " << run.err);
  if (!c.error.empty()) {
    check_refusal(run, results, file.string() + ":" + std::to_string(c.line) + ": ");
    CHECK(run.err.find(c.error) != std::string::npos);
    return;
  }
  CHECK(run.err.empty());
  REQUIRE(run.exit_code == 0);
  CHECK(fs::exists(results / "view" / "view.svg"));
  check_report(c, Json::parse(run.out));
}

void check_command_does_as_reader(const fs::path& file) {
  const tests::TemporaryFolder out;
  const fs::path results = out.path() / "results";
  const tests::RunResult run = analyze_all_of(file, results.string());
  INFO("file: " << file.string() << ", exit code " << run.exit_code << ", " << run.err);
  try {
    const MeshFile read = import_mesh(file, {}, Normals::passed_over);
    CHECK(run.err.empty());
    REQUIRE(run.exit_code == 0);
    const Json report = Json::parse(run.out);
    CHECK(report["scene"]["facets"] == read.mesh.facet_count());
    for (const std::string& warning : read.warnings) CHECK(some_warning_has(report, warning));
  } catch (const InputError& error) {
    check_refusal(run, results, error.what());
  }
}

}  // namespace sightline::tests
