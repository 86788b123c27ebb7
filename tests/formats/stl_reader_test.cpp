#include "formats/reading/stl_reader.h"

#include <doctest/doctest.h>

#include <limits>

#include "tests/tools/mesh_bytes.h"

namespace sightline::tests::stl_reader_test {
namespace {

std::string facet(const std::string& normal, const std::string& a, const std::string& b, const std::string& c) {
  return "facet normal " + normal + "\nouter loop\nvertex " + a + "\nvertex " + b + "\nvertex " + c +
         "\nendloop\nendfacet\n";
}

const std::string lone = facet("0 0 1", "0 0 0", "1 0 0", "0 1 0");

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

std::string binary(const std::string& header, const std::vector<float>& numbers, std::uint32_t count) {
  std::string bytes = header + std::string(80 - header.size(), '\0') + raw(count);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i % 9 == 0) bytes += std::string(12, '\0');
    bytes += raw(numbers[i]);
    if (i % 9 == 8) bytes += "\x12\x34";
  }
  return bytes;
}

}  // namespace

TEST_CASE("STL text: line ends, a byte order mark, upper case, blanks, several solids, no name") {
  const std::string text = "solid\n" + lone + "endsolid\n";
  std::string upper = text;
  for (char& c : upper) c = static_cast<char>(std::toupper(c));
  for (const std::string& form :
       {text, replaced(text, "\n", "\r\n"), replaced(text, "\n", "\r"), "\xEF\xBB\xBF" + text, upper,
        "\n\t " + replaced(text, "\n", "  \n\n\t"), "solid a name # and \\\n" + lone + "endsolid another\n" + text,
        replaced(text, "endfacet\nendsolid\n", "endfacet endsolid")}) {
    INFO(form);
    const MeshFile read = imported(form);
    CHECK(read.mesh.vertices.size() == 3);
    CHECK(area_of(read.mesh) == doctest::Approx(0.5));
  }
}

TEST_CASE("STL: corners are welded by value, and by nothing else") {
  const std::string text = "solid\n" + lone + facet("0 0 1", "1 0 -0", "1 1 0", "0 1 0") +
                           facet("0 0 1", "1.0000000000000002 0 0", "2 1 0", "2 0 1") + "endsolid\n";
  const Mesh mesh = imported(text).mesh;
  CHECK(mesh.vertices.size() == 4 + 3);
  CHECK(mesh.face_count() == 3);
  CHECK(mesh.faces[1][0] == VertexId(1));
  CHECK(mesh.faces[1][2] == VertexId(2));
}

TEST_CASE("STL: the winding counts; normals against it are a warning") {
  const MeshFile read = imported("solid\n" + lone + facet("0 0 -1", "0 0 1", "1 0 1", "0 1 1") +
                                 facet("nan x 0", "0 0 2", "1 0 2", "0 1 2") + "endsolid\n");
  CHECK(read.mesh.face_count() == 3);
  REQUIRE(read.warnings.size() == 1);
  check_warned(read, "the normals of 1 facet point against the winding");
  const MeshFile with_normals = imported("solid\n" + lone + "endsolid\n", Normals::read);
  CHECK(with_normals.corner_normals == std::vector<Vector3>(3, Vector3::Zero()));
}

TEST_CASE("STL text that is none is refused at its line") {
  check_refused("solid\n" + lone, "it:9: the file ends before");
  check_refused("solid\n" + lone + "endsolid\nfacet", "it:10: STL needs \"solid\" or the end here, not \"facet\"");
  check_refused("solid\nfacet normal 0 0 1\nvertex 0 0 0\n", "it:3: STL needs \"outer\" here, not \"vertex\"");
  check_refused(replaced("solid\n" + lone + "endsolid\n", "endloop", "vertex 1 1 1\nendloop"),
                "it:7: STL needs \"endloop\"");
  check_refused(replaced("solid\n" + lone + "endsolid\n", "1 0 0", "1 nan 0"),
                "it:5: coordinate \"nan\" is not finite");
  check_refused(replaced("solid\n" + lone + "endsolid\n", "1 0 0", "1,5 0 0"), "it:5: \"1,5\" is not a number");
  check_refused("solid\n" + lone + std::string(2000000, 'x'), "a word of more than 1048576 bytes");
}

TEST_CASE("binary STL is told by its size, even if it begins with solid") {
  const std::vector<float> triangle{0, 0, 0, 1, 0, 0, 0, 0.1F, 0};
  for (const std::string header : {"", "solid", "solid facet normal", "a text\nof two lines"}) {
    INFO(header);
    const Mesh mesh = imported(binary(header, triangle, 1)).mesh;
    CHECK(mesh.face_count() == 1);
    CHECK(mesh.vertices[2].y() == double{0.1F});
  }
  for (const std::uint32_t count : {0U, 2U, 0xFFFFFFFFU}) {
    check_refused(binary("solid", triangle, count), "binary data of no format that is known here; as STL");
    check_refused(binary("", triangle, count),
                  std::to_string(84 + 50 * std::uint64_t{count}) + " bytes, and it has 134;");
  }
  check_warned(imported(binary("", {}, 0)), "the scene is empty");
}

TEST_CASE("binary STL: numbers that are none are refused at their byte") {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr float infinite = std::numeric_limits<float>::infinity();
  check_refused(binary("", {0, 0, 0, 1, 0, 0, 0, nan, 0}, 1), "it: at byte 134: a coordinate is not finite");
  check_refused(binary("", {0, 0, 0, 1, 0, 0, 0, -infinite, 0}, 1), "a coordinate is not finite");
}

TEST_CASE("STL of which nobody knows the size: as much as is announced, bounded before it is read") {
  const auto read = [](const std::string& bytes, const ReadLimits& limits) {
    InputBytes in(std::string_view(bytes), "it");
    return read_stl_binary(in, limits, Normals::passed_over);
  };
  const std::string bytes = binary("", {0, 0, 0, 1, 0, 0, 0, 1, 0}, 1);
  check_warned(read(bytes + "more", {}), "what follows the last triangle is not read");
  CHECK_THROWS_WITH_AS((void)read(binary("", {}, 0xFFFFFFFF), {}), doctest::Contains("divide it into meshes"),
                       InputError);
  CHECK_THROWS_WITH_AS((void)read(binary("", {}, 1000000), {std::uint64_t{1} << 26}),
                       doctest::Contains("bytes of memory, and the limit is 67108864; raise it"), InputError);
  CHECK_THROWS_WITH_AS((void)read(binary("", {}, 1000), {}), doctest::Contains("it: at byte 84: the file ends"),
                       InputError);
}

}  // namespace sightline::tests::stl_reader_test
