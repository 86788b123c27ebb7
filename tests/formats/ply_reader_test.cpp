#include "formats/reading/ply_reader.h"

#include <doctest/doctest.h>

#include <limits>

#include "tests/tools/mesh_bytes.h"

namespace sightline::tests::ply_reader_test {
namespace {

const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string corners = "property list uchar int vertex_indices\n";

std::string header(const std::string& format, const std::string& elements) {
  return "ply\nformat " + format + " 1.0\n" + elements + "end_header\n";
}
std::string text(const std::string& elements, const std::string& body) { return header("ascii", elements) + body; }

const std::string triangle = "element vertex 3\n" + xyz + "element face 1\n" + corners;
const std::string points = "0 0 0\n1 0 0\n0 1 0\n";

void check_is_triangle(const MeshFile& read) {
  CHECK(read.mesh.vertices == std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(read.mesh.facet_count() == 1);
}

}  // namespace

TEST_CASE("PLY: line ends, a byte order mark, comments, numbers over several lines") {
  const std::string good = text(triangle, points + "3 0 1 2\n");
  std::string returns = good;
  std::ranges::replace(returns, '\n', '\r');
  for (const std::string& form : {good, returns, "\xEF\xBB\xBF" + good,
                                  text("comment property x\nobj_info element\n" + triangle, points + "3 0 1 2"),
                                  text(triangle, "0\n0\n0\n1 0 0\n0 1\n\n0\n3 0\n1 2\n")}) {
    check_is_triangle(imported(form));
    CHECK(imported(form).warnings.empty());
  }
}

TEST_CASE("PLY in binary after a header whose lines end with CR alone") {
  std::string bytes = header("binary_little_endian", triangle);
  std::ranges::replace(bytes, '\n', '\r');
  // The first byte of the data is a line feed.
  const float first = std::bit_cast<float>(0x3F80000AU);
  bytes += raw(first);
  for (const int x : {0, 0, 1, 0, 0, 0, 1, 0}) bytes += raw(static_cast<float>(x));
  bytes += "\x03" + raw(0) + raw(1) + raw(2);
  CHECK(imported(bytes).mesh.vertices[0].x() == double{first});
}

TEST_CASE("PLY: every type by both of its names, in both orders") {
  const std::string elements =
      "element vertex 3\nproperty int8 x\nproperty char a\nproperty uint8 b\nproperty uchar y\nproperty int16 "
      "c\nproperty "
      "short d\nproperty uint16 e\nproperty ushort z\nproperty int32 f\nproperty int g\nproperty uint32 h\nproperty "
      "uint "
      "i\nproperty float32 j\nproperty float k\nproperty float64 l\nproperty double m\nelement face 1\nproperty list "
      "uint16 "
      "float weights\nproperty list int32 int8 vertex_index\n";
  for (const std::endian endian : {std::endian::little, std::endian::big}) {
    std::string bytes = header(endian == std::endian::little ? "binary_little_endian" : "binary_big_endian", elements);
    for (const auto& [x, y, z] : {std::array{-128, 0, 0}, std::array{127, 0, 65535}, std::array{0, 255, 0}}) {
      bytes += raw(static_cast<std::int8_t>(x), endian) + "aB" + raw(static_cast<std::uint8_t>(y), endian) + "ccddee" +
               raw(static_cast<std::uint16_t>(z), endian) + "ffffgggghhhhiiiijjjjkkkkllllllllmmmmmmmm";
    }
    bytes += raw(std::uint16_t{2}, endian) + "11112222" + raw(std::int32_t{3}, endian) + std::string("\2\1\0", 3);
    const Mesh mesh = imported(bytes).mesh;
    CHECK(mesh.vertices == std::vector<Point3>{{-128, 0, 0}, {127, 0, 65535}, {0, 255, 0}});
    CHECK(mesh.faces[0][0] == VertexId(2));
  }
}

TEST_CASE("PLY: faces before vertices, and what is not of the surface") {
  check_is_triangle(imported(text("element face 1\n" + corners + "element vertex 3\n" + xyz, "3 0 1 2\n" + points)));
  check_is_triangle(imported(text("element camera 2\nproperty list int float list\nproperty float x\n" + triangle +
                                      "element nothing 200000000000000\n",
                                  "2 1 nan 0\n0 x\n" + points + "3 0 1 2\n")));
  const MeshFile more = imported(text(triangle, points + "3 0 1 2 255\n"));
  check_is_triangle(more);
  check_warned(more, "1 line with more numbers than the header declares, which are not read, from line 13 on");
  check_warned(imported(text(triangle, points + "3 0 1 2\n17")), "what follows the mesh is not read");
}

TEST_CASE("PLY of points alone is an empty scene") {
  const MeshFile read = imported(text("element vertex 3\n" + xyz, points));
  CHECK(read.mesh.vertices.size() == 3);
  check_warned(read, "the scene is empty: no face is left to draw");
  check_warned(imported(text("element vertex 0\n" + xyz + "element face 0\n", "")), "the scene is empty");
}

TEST_CASE("PLY: defects of faces are found as in OBJ") {
  const std::string quad = "element vertex 3\n" + xyz + "element face 3\n" + corners;
  const MeshFile read = imported(text(quad, points + "3 0 1 2\n3 1 2 0\n2 0 1\n"));
  check_warned(read, "1 face skipped (repeated face): 1");
  check_warned(read, "1 face skipped (too few corners): 2");
}

TEST_CASE("PLY: normals where they are asked for") {
  const std::string elements = "element vertex 3\n" + xyz +
                               "property float nx\nproperty double ny\nproperty float nz\n" + "element face 1\n" +
                               corners;
  const std::string body = "0 0 0 0 0 1\n1 0 0 0 0.1 1\n0 1 0 0 0 2\n3 1 2 0\n";
  CHECK(imported(text(elements, body)).corner_normals.empty());
  CHECK(imported(text(elements, body), Normals::read).corner_normals ==
        std::vector<Vector3>{{0, 0.1, 1}, {0, 0, 2}, {0, 0, 1}});
  CHECK(imported(text(triangle, points + "3 0 1 2"), Normals::read).corner_normals ==
        std::vector<Vector3>(3, Vector3::Zero()));
}

TEST_CASE("PLY: headers that are none") {
  const std::string end = "end_header\n";
  check_refused("ply\n", "it:2: the file ends before");
  check_refused("ply\n" + triangle + end + points + "3 0 1 2\n", "the header has no format");
  check_refused(header("binary_middle_endian", triangle),
                "it:2: PLY is ascii, binary_little_endian or binary_big_endian");
  check_refused("ply\nformat ascii 2.0\n" + triangle + end, "it:2: PLY is read in version 1.0, not \"2.0\"");
  check_refused(text("", ""), "the header has no element vertex");
  check_refused(text("element vertex 1\nproperty float x\nproperty float y\n", "0 0"), "the properties x, y and z");
  check_refused(text("element vertex 3\n" + xyz + "element face 1\nproperty int v\n", points),
                "the property list vertex_indices");
  check_refused(text("element vertex 0\n" + xyz + "element tristrips 1\nproperty list int int vertex_indices\n", "1 1"),
                "triangle strips (tristrips) are not read");
  check_refused(text("property float x\n", ""), "it:3: a property before the first element");
  check_refused(text("element vertex -1\n" + xyz, ""), "it:3: \"-1\" is no number of elements");
  check_refused(text("element vertex 1.5\n" + xyz, ""), "it:3: \"1.5\" is no number of elements");
  check_refused(text("element vertex\n" + xyz, ""), "it:3: ");
  check_refused(text("element vertex 1\nproperty half x\n", ""), "it:4: \"half\" is no type of PLY");
  check_refused(text("element vertex 1\nproperty float\n", ""), "it:4: a property needs a name");
  check_refused(text("element vertex 1\nproperty float x\nproperty double x\n", ""), "a second property \"x\"");
  check_refused(text("element vertex 1\n" + xyz + "element vertex 1\n", ""), "a second element \"vertex\"");
  check_refused(text("element face 1\nproperty list float int vertex_indices\n", ""), "a list needs an integer");
  check_refused(text("element face 1\nproperty list int float vertex_indices\n", ""), "corners need integers");
  check_refused(text("elements vertex 3\n", ""), "\"elements\" is no word of a PLY header");
  check_refused(text("element a 999999999999999999999\nproperty int a\n", ""), "more elements than any file has");
  std::string many = "element a 1\n";
  for (int i = 0; i < 10001; ++i) many += "property int a\n";
  check_refused(text(many, ""), "more than 10000 properties");
}

TEST_CASE("PLY: bodies that are none") {
  check_refused(text(triangle, points + "3 0 1 3\n"), "it:13: a corner names vertex 3 of 3, counted from 0");
  check_refused(text(triangle, points + "3 0 1 -1\n"), "a corner names vertex -1 of 3");
  check_refused(text(triangle, points + "3 0 1 1.0\n"), "\"1.0\" is no index of a vertex");
  check_refused(text(triangle, points + "-3 0 1 2\n"), "a list of length -3");
  check_refused(text(triangle, points + "99999999999999999999 0 1 2\n"), "it:14: the file ends before");
  check_refused(text(triangle, points), "the file ends before its mesh does");
  check_refused(text(triangle, "0 0 0\n1 inf 0\n"), "it:11: coordinate \"inf\" is not finite");
  check_refused(text(triangle, "0 0 0\n1 1e999 0\n"), "is beyond the range of double");
  check_refused(text(triangle, "0 0 0\n1 0x10 0\n"), "\"0x10\" is not a number");
}

TEST_CASE("PLY in binary: numbers that are none are refused at their byte") {
  const std::string start = header("binary_little_endian", triangle);
  const auto vertices = [](float last) { return std::string(32, '\0') + raw(last); };
  check_refused(start + vertices(std::numeric_limits<float>::quiet_NaN()) + "\x01",
                "it: at byte " + std::to_string(start.size() + 36) + ": a coordinate is not finite");
  check_refused(start + vertices(1) + "\x03" + raw(0) + raw(1) + raw(-1), "a corner names vertex -1 of 3");
  check_refused(start + vertices(1) + "\xFF" + raw(0), "the file ends before its mesh does");
  const std::string skipped = header("binary_big_endian", "element a 1\nproperty list uint double b\n" + triangle);
  check_refused(skipped + "\xFF\xFF\xFF\xFF" + std::string(1000, 'x'), "the file ends before its mesh does");
}

TEST_CASE("PLY: what is announced is refused before it is read, or held") {
  const ReadLimits limits{std::uint64_t{1} << 26};
  const auto announced = [](const std::string& vertices, const std::string& faces) {
    return header("binary_big_endian",
                  "element vertex " + vertices + "\n" + xyz + "element face " + faces + "\n" + corners);
  };
  check_refused(announced("4294967295", "1"), "it:10: the mesh that is announced needs about ", limits);
  check_refused(announced("1", "1000000000"), "bytes of memory, and the limit is 67108864; raise it with --max-memory",
                limits);
  check_refused(announced("4294967296", "1"), "is too large; divide it");
  check_refused(announced("1", "4294967295"), "is too large; divide it");
  check_refused(announced("9223372036854775807", "1"), "more elements than any file has");
  const std::string face =
      header("ascii", "element vertex 3\n" + xyz + "element face 1\nproperty list uint int vertex_index\n");
  std::string many;
  for (int i = 0; i < 10001; ++i) many += " 0";
  check_refused(face + points + "10001" + many, "a face of more than 10000 corners; divide it");
}

TEST_CASE("PLY from a source that gives a byte at a time is the same") {
  const std::string bytes = bytes_in(std::filesystem::path(SIGHTLINE_FIXTURES_DIR) / "formats" / "big_endian.ply");
  std::size_t at = 0;
  InputBytes in(
      [&](std::span<char> to) {
        if (at == bytes.size()) return std::size_t{0};
        to[0] = bytes[at++];
        return std::size_t{1};
      },
      "it");
  const Mesh mesh = read_ply(in, {}, Normals::passed_over).mesh;
  CHECK(mesh.vertices == imported(bytes).mesh.vertices);
  CHECK(mesh.faces.corners == imported(bytes).mesh.faces.corners);
}

}  // namespace sightline::tests::ply_reader_test
