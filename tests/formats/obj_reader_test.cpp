// The OBJ reader is held against the files in fixtures/bad-obj, numbers bit for bit, and against a second reader for
// structure.
#include "formats/reading/obj_reader.h"

#include <doctest/doctest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <random>

#include "tests/tools/command_case.h"

#define TINYOBJLOADER_USE_DOUBLE
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

namespace sightline::tests::obj_reader_test {
namespace {

const std::filesystem::path fixtures = std::filesystem::path(SIGHTLINE_FIXTURES_DIR) / "bad-obj";

const std::vector<ObjCase> text_cases{
    reads("comments_only.obj", 0),
    reads("no_faces.obj", 0),
    reads("line_ends.obj", 1, 0.5),
    reads("no_final_newline.obj", 1, 0.5),
    reads("byte_order_mark.obj", 1, 0.5),
    reads("continuation.obj", 1, 0.5),
    reads("comment_continuation.obj", 1, 0.5),
    reads("extra_columns.obj", 1, 0.5),
    with_warning(reads("material_paths.obj", 1, 0.5), "is not opened"),
    with_warning(reads("unknown_keywords.obj", 1, 0.5), "3 statements not understood, from line 1 on: \"call\""),
    with_warning(reads("keyword_forms.obj", 1, 0.5), "4 statements not understood, from line 1 on: \"V\""),
    with_warning(reads("nul_padding.obj", 1, 0.5), "1 statement not understood, from line 5 on: \"\\x00"),
    with_warning(reads("binary_tail.obj", 1, 0.5), "2 statements not understood, from line 5 on: \"\\x80"),
    fails("utf16_little.obj", 1, "UTF-16 (little endian)"),
    fails("utf16_big.obj", 1, "UTF-16 (big endian)"),
    fails("other_format.obj", 3, "\"solid\""),
};

const std::vector<ObjCase> index_cases{
    reads("slash_forms.obj", 2, 1),
    with_warning(reads("missing_attributes.obj", 1, 0.5), "1 face with texture or normal indices that name nothing: 0"),
    reads("negative_indices.obj", 2, 1),
    reads("forward_reference.obj", 1, 0.5),
    fails("index_zero.obj", 4, "\"0\""),
    fails("index_past_end.obj", 5, "vertex 4 of 3"),
    fails("index_past_start.obj", 4, "\"-4\""),
    fails("index_two_to_32.obj", 4, "\"4294967299\""),
    fails("index_two_to_63.obj", 4, "\"-9223372036854775809\""),
    fails("index_two_to_64.obj", 4, "\"18446744073709551619\""),
    fails("index_decimal.obj", 4, "\"1.0\""),
    fails("index_plus_minus.obj", 4, "\"+-1\""),
    fails("index_absent.obj", 4, "\"/1\""),
    fails("index_four_parts.obj", 4, "\"1/2/3/4\""),
    fails("index_of_texture.obj", 4, "\"1/a\""),
    fails("index_without_vertices.obj", 1, "vertex 1 of 0"),
    fails("trailing_word.obj", 5, "\"x\""),
};

const std::vector<ObjCase> number_cases{
    reads("denormals.obj", 1),
    reads("underflow.obj", 1, 0.5),
    reads("huge_coordinates.obj", 1),
    reads("number_forms.obj", 1, 0.5),
    reads("halfway.obj", 1),
    fails("coordinate_nan.obj", 2, "\"NaN\" is not finite"),
    fails("coordinate_infinite.obj", 2, "\"-Infinity\" is not finite"),
    fails("coordinate_too_large.obj", 2, "\"1.8e308\" is beyond the range"),
    fails("coordinate_hexadecimal.obj", 1, "\"0x1p0\""),
    fails("coordinate_comma.obj", 1, "\"1,5\""),
    fails("coordinate_word.obj", 1, "\"one\""),
    fails("coordinate_missing.obj", 2, "three coordinates"),
    fails("coordinate_exponent.obj", 2, "\"3.1+e2\""),
    fails("coordinate_two_signs.obj", 1, "\"+-1\""),
    fails("nul_in_number.obj", 2, "\"0\\x00\""),
};

const std::vector<ObjCase> defect_cases{
    with_defect(reads("too_few_corners.obj", 1, 0.5), Defect::too_few_corners, {0, 1, 2}),
    with_defect(with_defect(reads("equal_corners.obj", 2, 1), Defect::too_few_corners, {0, 1, 2}),
                Defect::repeated_corner, {3, 4}),
    with_defect(with_defect(reads("spikes.obj", 2, 16), Defect::repeated_corner, {0, 1}), Defect::zero_area, {2}),
    with_defect(reads("on_one_line.obj", 1), Defect::zero_area, {0, 1, 2}),
    reads("almost_on_one_line.obj", 1),
    with_defect(with_defect(reads("repeated_faces.obj", 3, 2.5), Defect::repeated_face, {1}), Defect::self_crossing,
                {3}),
    reads("equal_vertices.obj", 2, 1),
    with_defect(reads("bowtie.obj", 0), Defect::self_crossing, {0}),
    with_defect(reads("twice_round.obj", 1, 0.5), Defect::self_crossing, {0}),
    with_defect(reads("pentagram.obj", 0), Defect::self_crossing, {0, 1}),
};

// k corners give k - 2 triangles; a pinch takes two of them away.
const std::vector<ObjCase> polygon_cases{
    reads("concave.obj", 2, 1),
    reads("concave_upright.obj", 3, 2.5),
    reads("collinear_corner.obj", 1 + 4, 4 + 3),
    reads("keyhole.obj", 8, 36 - 4),
    reads("bridge_with_corner.obj", 10, 36 - 4),
    reads("pinched.obj", 2, 2),
    reads("hole_touches.obj", 5, 36 - 1.5),
    reads("warped_quad.obj", 2),
    reads("folded_pentagon.obj", 3),
};

TEST_CASE("every file in fixtures/bad-obj has a case") {
  CHECK(files_in(fixtures) == files_of({text_cases, index_cases, number_cases, defect_cases, polygon_cases}));
}

TEST_CASE("lines, encodings and keywords") { check_cases(fixtures, text_cases); }
TEST_CASE("indices") { check_cases(fixtures, index_cases); }
TEST_CASE("numbers") { check_cases(fixtures, number_cases); }
TEST_CASE("faces with a defect are skipped or mended, counted and listed") { check_cases(fixtures, defect_cases); }
TEST_CASE("faces of any shape are divided right") { check_cases(fixtures, polygon_cases); }

TEST_CASE("the command does with every file in fixtures/bad-obj what its row says") {
  for (const auto& table : {text_cases, index_cases, number_cases, defect_cases, polygon_cases}) {
    for (const ObjCase& c : table) check_command(fixtures, c);
  }
}

TEST_CASE("a file that cannot be read is an error without a line") {
  CHECK_THROWS_WITH_AS((void)read_obj(fixtures / "absent.obj"), doctest::Contains("absent.obj: cannot be opened"),
                       InputError);
  CHECK_THROWS_WITH_AS((void)read_obj(fixtures), doctest::Contains("is a directory"), InputError);
}

TEST_CASE("a warning lists at most ten faces and counts all") {
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  for (int i = 0; i < 12; ++i) text += "f 1 2\n";
  const MeshFile read = read_obj(text, "many.obj");
  CHECK(read.warnings ==
        std::vector<std::string>{"many.obj: 12 faces skipped (too few corners): 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, ..."});
}

std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

// Returns all values as the coordinates of vertices, read back.
std::vector<double> read_back(const std::vector<std::string>& numbers) {
  std::string text;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
    text += "v " + numbers[i] + " " + numbers[i + 1] + " " + numbers[i + 2] + "\n";
  std::vector<double> values;
  for (const Point3& p : read_obj(text, "numbers.obj").mesh.vertices)
    values.insert(values.end(), {p.x(), p.y(), p.z()});
  return values;
}

void check_same_bits(const std::vector<double>& values, const std::vector<double>& expected) {
  REQUIRE(values.size() == expected.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < values.size(); ++i) different += bits(values[i]) != bits(expected[i]) ? 1 : 0;
  CHECK(different == 0);
}

TEST_CASE("special numbers") {
  const MeshFile halfway = read_obj(fixtures / "halfway.obj");
  const double above_one = std::nextafter(1.0, 2.0);
  const std::vector<Point3>& v = halfway.mesh.vertices;
  check_same_bits(
      {v[0].x(), v[0].y(), v[0].z(), v[1].x(), v[1].y()},
      {9007199254740992.0, 9007199254740996.0, 1.0, above_one, std::bit_cast<double>(0x000fffffffffffffULL)});
  const MeshFile underflow = read_obj(fixtures / "underflow.obj");
  check_same_bits({underflow.mesh.vertices[0].x(), underflow.mesh.vertices[1].y(), underflow.mesh.vertices[2].z()},
                  {-0.0, 0.0, 0.0});
  const double smallest = std::numeric_limits<double>::denorm_min();
  const double largest = std::numeric_limits<double>::max();
  check_same_bits(read_back({"2.4703282292062327e-324", "2.4703282292062328e-324", "-2.4703282292062328e-324",
                             "1.797693134862315807e308", "17976931348623157" + std::string(292, '0'),
                             "0." + std::string(400, '0') + "1e401"}),
                  {0.0, smallest, -smallest, largest, largest, 1.0});
}

std::vector<double> random_doubles(std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::vector<double> values;
  while (values.size() < count) {
    const double value = std::bit_cast<double>(random() & (random() % 16 == 0 ? 0x800fffffffffffffULL : ~0ULL));
    if (std::isfinite(value)) values.push_back(value);
  }
  return values;
}

std::string in_17_digits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

std::string in_fewest_digits(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

TEST_CASE("a hundred thousand doubles come back bit for bit") {
  constexpr unsigned seed = 20240607;
  INFO("seed " << seed);
  const std::vector<double> values = random_doubles(100002, seed);
  CHECK(std::ranges::count_if(values, [](double v) { return std::fpclassify(v) == FP_SUBNORMAL; }) > 1000);
  std::vector<std::string> digits;
  std::ranges::transform(values, std::back_inserter(digits), in_17_digits);
  check_same_bits(read_back(digits), values);
  std::ranges::transform(values, digits.begin(), in_fewest_digits);
  check_same_bits(read_back(digits), values);
}

// Only the structure is compared: its numbers are not correctly rounded.
void check_against_tinyobjloader(const std::filesystem::path& path) {
  INFO("file: " << path.string());
  tinyobj::attrib_t attributes;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
  std::string warning;
  std::string error;
  std::ifstream in(path);
  REQUIRE(tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, &in, nullptr, false));
  std::vector<std::size_t> sizes;
  std::vector<VertexId> corners;
  for (const auto& shape : shapes) {
    for (const auto size : shape.mesh.num_face_vertices) sizes.push_back(size);
    for (const auto& index : shape.mesh.indices) corners.emplace_back(static_cast<std::size_t>(index.vertex_index));
  }
  const Mesh mesh = read_obj(path).mesh;
  CHECK(mesh.vertices.size() == attributes.vertices.size() / 3);
  REQUIRE(mesh.face_count() == sizes.size());
  for (std::size_t f = 0; f < sizes.size(); ++f) REQUIRE(mesh.faces[f].size() == sizes[f]);
  CHECK(mesh.faces.corners == corners);
}

TEST_CASE("a second reader finds the same vertices and faces") {
  const auto folder = shared_folder("models");
  if (folder.empty()) {
    MESSAGE("skipped: no folder of models");
    return;
  }
  std::size_t count = 0;
  for (const std::string& file : files_in(folder)) {
    if (!file.ends_with(".obj")) continue;
    check_against_tinyobjloader(folder / file);
    ++count;
  }
  CHECK(count > 0);
}

}  // namespace

}  // namespace sightline::tests::obj_reader_test
