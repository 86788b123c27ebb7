// One mesh in every format is one mesh; public files have the vertices, faces and area that another program, written in
// another language, counts in them; no file that is cut short is taken for a whole one.
#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "formats/reading/mesh_reader.h"
#include "sightline/analyzer.h"
#include "tests/tools/command_runner.h"
#include "tests/tools/mesh_bytes.h"

namespace sightline::tests::mesh_formats_test {
namespace {

namespace fs = std::filesystem;

const fs::path folder = fs::path(SIGHTLINE_FIXTURES_DIR) / "formats";

const std::vector<std::string> with_polygons{"text.ply", "little_endian.ply", "big_endian.ply", "house.off",
                                             "house.stcnoff"};
std::vector<std::string> with_triangles() {
  std::vector<std::string> files{"text.stl", "binary.stl", "house.gltf", "beside.gltf", "house.glb"};
#ifdef SIGHTLINE_HAS_EXPAT
  files.emplace_back("house.3mf");
#endif
  return files;
}

std::vector<std::string> all_files() {
  std::vector<std::string> files = with_triangles();
  files.insert(files.end(), with_polygons.begin(), with_polygons.end());
  return files;
}

MeshFile read(const std::string& file) { return import_mesh(folder / file, {}, Normals::passed_over); }

std::vector<std::array<double, 3>> sorted_positions(const Mesh& mesh) {
  std::vector<std::array<double, 3>> positions;
  for (const Point3& p : mesh.vertices) positions.push_back({p.x(), p.y(), p.z()});
  std::ranges::sort(positions);
  return positions;
}

double visible_area(const Mesh& mesh) {
  const ViewPoint view{{3, 5, 7}, {0, 0, 0}, {0, 1, 0}, 1, {}, {}};
  double area = 0;
  for (const VisiblePolygon& polygon : Analyzer(mesh).view(perspective_camera("c", view, 60)).polygons.polygons)
    area += polygon.area;
  return area;
}

}  // namespace

TEST_CASE("polygons are read as they are") {
  const Mesh house = read("house.obj").mesh;
  CHECK(house.vertices.size() == 9);
  for (const std::string& file : with_polygons) {
    INFO(file);
    const MeshFile other = read(file);
    CHECK(other.warnings.empty());
    CHECK(other.mesh.vertices == house.vertices);
    CHECK(other.mesh.faces.corners == house.faces.corners);
    CHECK(other.mesh.faces.begin == house.faces.begin);
  }
}

TEST_CASE("triangles of a mesh lie where its polygons do, and are seen as much") {
  const Mesh house = read("house.obj").mesh;
  for (const std::string& file : with_triangles()) {
    INFO(file);
    const Mesh mesh = read(file).mesh;
    CHECK(validate(mesh).empty());
    CHECK(mesh.face_count() == 14);
    CHECK(sorted_positions(mesh) == sorted_positions(house));
    CHECK(area_of(mesh) == doctest::Approx(area_of(house)).epsilon(1e-15));
    CHECK(visible_area(mesh) == doctest::Approx(visible_area(house)).epsilon(1e-14));
  }
}

TEST_CASE("the library reads what the command does, but for what it leaves to the command") {
  for (const std::string& file : all_files()) {
    INFO(file);
    const std::string bytes = bytes_in(folder / file);
    if (file.ends_with(".stl") || std::ranges::find(with_polygons, file) != with_polygons.end()) {
      CHECK(read_mesh(folder / file).mesh.vertices == read(file).mesh.vertices);
      CHECK(read_mesh(bytes, file).mesh.vertices == read(file).mesh.vertices);
    } else {
      CHECK_THROWS_WITH_AS((void)read_mesh(folder / file),
                           doctest::Contains("is read by the command sightline from a file"), InputError);
    }
  }
}

namespace {

// What is cut off may say nothing more: then it is read, and as the whole.
void check_cut(const std::string& bytes, std::size_t size, const Mesh& whole) {
  INFO("cut to " << size << " of " << bytes.size() << " bytes");
  try {
    const Mesh mesh = import_mesh(std::string_view(bytes).substr(0, size), "cut", {}, Normals::passed_over).mesh;
    CHECK(mesh.vertices == whole.vertices);
    CHECK(mesh.faces.corners == whole.faces.corners);
  } catch (const InputError& error) {
    CHECK(is_one_line(error.what()));
  }
}

}  // namespace

TEST_CASE("a file that is cut short anywhere is refused, or whole without what is cut off") {
  for (const std::string& file : all_files()) {
    INFO(file);
    if (file == "beside.gltf") continue;
    const std::string bytes = bytes_in(folder / file);
    const Mesh whole = imported(bytes).mesh;
    // One letter more is a keyword of OBJ.
    for (std::size_t size = 2; size < bytes.size(); ++size) check_cut(bytes, size, whole);
  }
}

TEST_CASE("doubles come back bit for bit") {
  constexpr unsigned seed = 20261130;
  INFO("seed " << seed);
  constexpr std::size_t count = 30000;
  const std::vector<double> values = random_finite_doubles(count, seed);
  const std::string vertices = std::to_string(count / 3);
  std::string lines;
  for (std::size_t i = 0; i < count; ++i) lines += with_17_digits(values[i]) + (i % 3 == 2 ? "\n" : " ");
  check_vertices_are(imported("OFF\n" + vertices + " 0 0\n" + lines).mesh, values);
  const std::string header =
      " 1.0\nelement vertex " + vertices + "\nproperty double x\nproperty double y\nproperty double z\nend_header\n";
  check_vertices_are(imported("ply\nformat ascii" + header + lines).mesh, values);
  for (const std::endian endian : {std::endian::little, std::endian::big}) {
    std::string bytes =
        endian == std::endian::little ? "ply\nformat binary_little_endian" : "ply\nformat binary_big_endian";
    bytes += header;
    for (const double value : values) bytes += raw(value, endian);
    check_vertices_are(imported(bytes).mesh, values);
  }
}

TEST_CASE("numbers in the text of STL come back bit for bit") {
  constexpr unsigned seed = 20261201;
  INFO("seed " << seed);
  const std::vector<double> values = random_finite_doubles(9000, seed);
  std::string text = "solid\n";
  for (std::size_t i = 0; i < values.size(); i += 3) {
    if (i % 9 == 0) text += "facet normal 0 0 0\nouter loop\n";
    text += "vertex " + with_17_digits(values[i]) + " " + with_17_digits(values[i + 1]) + " " +
            with_17_digits(values[i + 2]) + "\n";
    if (i % 9 == 6) text += "endloop\nendfacet\n";
  }
  check_vertices_are(imported(text + "endsolid\n").mesh, values);
}

namespace {

struct PublicFile {
  std::string file;
  std::size_t vertices;
  std::size_t faces;
  double area;
  std::string warning;  // none if empty
};

// Counted and measured by a program in Python that shares nothing with this one.
const std::vector<PublicFile> public_files{
    {"ADIS16480.STL", 3672, 7436, 0.007353442457, ""},
    {"plate_holes.STL", 618, 1252, 133343.4119, ""},
    {"multibody.stl", 20, 32, 0.3672389512, ""},
    {"fuji_ascii.stl", 174, 344, 13189.91594, ""},
    {"fixed_top.ply", 2374, 4772, 15317.70897, ""},
    {"octagonal_pocket.ply", 1658, 3262, 0.07482245334, ""},
    {"fuze_ascii.ply", 502, 1000, 0.04472226040, "1000 lines with more numbers than the header declares"},
    {"multi.ply", 4, 1, 4, ""},
    {"ballA.off", 1900, 3796, 605.9094133, ""},
    {"comments.off", 8, 6, 32.0000043, ""},
    {"whitespace.off", 8, 6, 32.0000043, ""},
    {"groups.obj", 1156, 2308, 144.5301517, ""},
    {"two_objects.obj", 12, 16, 8.366025404, ""},
    {"ico4.obj", 642, 1280, 12.50617583, ""},
    {"Duck.glb", 2399, 4212, 7.023517084, ""},
    {"rgb_cube_with_primitives.gltf", 24, 12, 24, ""},
#ifdef SIGHTLINE_HAS_EXPAT
    {"counterXP.3MF", 4661 + 5 * 7723, 8080 + 5 * 15134, 169951.3852, ""},
#endif
};

}  // namespace

TEST_CASE("public files have the vertices, faces and area that are counted in them") {
  const fs::path shared = shared_folder("formats");
  if (shared.empty()) {
    MESSAGE("skipped: no folder of public files");
    return;
  }
  for (const PublicFile& expected : public_files) {
    INFO(expected.file);
    const MeshFile file = import_mesh(shared / expected.file, {}, Normals::passed_over);
    CHECK(file.mesh.vertices.size() == expected.vertices);
    CHECK(file.mesh.face_count() == expected.faces);
    CHECK(area_of(file.mesh) == doctest::Approx(expected.area).epsilon(1e-9));
    CHECK(file.warnings.empty() == expected.warning.empty());
    if (!expected.warning.empty()) check_warned(file, expected.warning);
  }
  for (const std::string& file : files_in(shared)) {
    const bool has_row = std::ranges::count(public_files, file, &PublicFile::file) == 1;
    CHECK_MESSAGE((has_row || file.ends_with(".mtl") || file.ends_with(".3MF")), file);
  }
}

namespace {

nlohmann::json report_of(const std::string& mesh, const std::string& output) {
  const RunResult run = run_sightline({"analyze", mesh, "--eye=3,5,7", "--target=0,0,0", "--fov-y=60", "--sides=both",
                                       "--json", "--quiet", "-o", output});
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  return nlohmann::json::parse(run.out);
}

}  // namespace

TEST_CASE("the labelled surface is read back, with the same areas") {
  const TemporaryFolder results;
  const std::string out = results.path() / "first";
  const nlohmann::json first = report_of((folder / "house.glb").string(), out);
  const double visible = first["areas"]["image_visible"];
  CHECK(visible > 0.1);
  for (const char* file : {"labelled.ply", "labelled.obj"}) {
    INFO(file);
    const nlohmann::json again = report_of(out + "/view/" + file, results.path() / (std::string("of_") + file));
    CHECK(again["areas"]["surface"].get<double>() ==
          doctest::Approx(first["areas"]["surface"].get<double>()).epsilon(1e-12));
    CHECK(again["areas"]["image_visible"].get<double>() == doctest::Approx(visible).epsilon(1e-9));
    CHECK(again["warnings"].empty());
  }
}

}  // namespace sightline::tests::mesh_formats_test
