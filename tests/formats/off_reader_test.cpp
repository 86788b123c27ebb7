#include "formats/reading/off_reader.h"

#include <doctest/doctest.h>

#include "tests/tools/mesh_bytes.h"

namespace sightline::tests::off_reader_test {
namespace {

const std::string points = "0 0 0\n1 0 0\n0 1 0\n";

void check_is_triangle(const std::string& text) {
  INFO(text);
  const MeshFile read = imported(text);
  CHECK(read.mesh.vertices == std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(read.mesh.facet_count() == 1);
  CHECK(read.warnings.empty());
}

}  // namespace

TEST_CASE("OFF: line ends, comments, blanks, counts beside the keyword, edges or none") {
  check_is_triangle("OFF\n3 1 0\n" + points + "3 0 1 2\n");
  check_is_triangle("OFF\n3 1\n" + points + "3 0 1 2");
  check_is_triangle("OFF 3 1 0\n" + points + "3 0 1 2");
  check_is_triangle("OFF3 1 0\n" + points + "3 0 1 2");
  check_is_triangle("\xEF\xBB\xBF# a comment\n\n \t OFF # more\r\n# and more\r\n3 1 0 # counts\r\n" + points +
                    "\r\n3 0 1 2 # face\r\n# end");
  check_is_triangle("OFF\r3 1 0\r0 0 0\r1 0 0\r0 1 0\r3 0 1 2\r");
  check_is_triangle("OFF\n3 1 0\n0 0\n0\n1 0 0\n0 1\n0\n3 0\n1 2\n");
}

TEST_CASE("OFF: colours, texture coordinates and normals") {
  for (const char* colours : {"", " 7", " 255 0 0", " 0.1 0.2 0.3 1"})
    check_is_triangle("OFF\n3 1 0\n" + points + "3 0 1 2" + colours + "\n");
  check_is_triangle("COFF\n3 1 0\n0 0 0 255 0 0\n1 0 0 1 2 3 4\n0 1 0 9\n3 0 1 2\n");
  check_is_triangle("STOFF\n3 1 0\n0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 1\n3 0 1 2\n");
  check_is_triangle("NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n");
  const std::string all =
      "STCNOFF\n3 1 0\n0 0 0 0 0 1 255 0 0 1 0 0\n1 0 0 0 0.1 1 1 2 3 4 0 0\n0 1 0 0 0 2 9 0 0\n3 1 2 0\n";
  check_is_triangle(all);
  CHECK(imported(all, Normals::read).corner_normals == std::vector<Vector3>{{0, 0.1, 1}, {0, 0, 2}, {0, 0, 1}});
  CHECK(imported("OFF\n3 1 0\n" + points + "3 0 1 2", Normals::read).corner_normals ==
        std::vector<Vector3>(3, Vector3::Zero()));
}

TEST_CASE("OFF of points alone is an empty scene; what follows the mesh is a warning") {
  check_warned(imported("OFF\n3 0 0\n" + points), "the scene is empty");
  check_warned(imported("OFF\n3 0 0\n" + points + "3 0 1 2\n"), "what follows the mesh is not read");
  check_warned(imported("OFF\n3 1 0\n" + points + "2 0 1\n"), "1 face skipped (too few corners): 0");
}

TEST_CASE("OFF that is not read says what to do") {
  check_refused("OFF BINARY\n", "it:1: OFF in binary is not read; save it as OFF in text");
  check_refused("4OFF\n1 0 0\n0 0 0 1\n", "OFF in other than three dimensions, \"4OFF\", is not read");
  check_refused("C4nOFF\n3 1 0 0\n", "OFF in other than three dimensions");
}

TEST_CASE("OFF: counts and indices that are none") {
  check_refused("OFF\n", "it:2: the file ends");
  check_refused("OFF\n-3 1 0\n", "it:2: \"-3\" is no number of vertices");
  check_refused("OFF\n3 1.5 0\n", "\"1.5\" is no number of faces");
  check_refused("OFF\n3 1 0 0\n" + points + "3 0 1 2", "the line of counts is followed by 2 more numbers");
  check_refused("OFF\n4 1 0\n" + points + "3 0 1 2\n", "more number");
  check_refused("OFF\n3 2 0\n" + points + "3 0 1 2\n", "the file ends before its mesh does");
  check_refused("OFF\n3 1 0\n" + points + "3 0 1 3\n", "it:6: a corner names vertex 3 of 3, counted from 0");
  check_refused("OFF\n3 1 0\n" + points + "3 0 1 -1\n", "a corner names vertex -1 of 3");
  check_refused("OFF\n3 1 0\n" + points + "3 0 1 2.0\n", "corner \"2.0\" is no index");
  check_refused("OFF\n3 1 0\n" + points + "-3 0 1 2\n", "\"-3\" is no number of corners");
  check_refused("OFF\n3 1 0\n" + points + "4294967295 0 1 2\n", "the file ends");
  std::string many;
  for (int i = 0; i < 10001; ++i) many += " 0";
  check_refused("OFF\n3 1 0\n" + points + "10001" + many, "a face of more than 10000 corners; divide it");
}

TEST_CASE("OFF: numbers that may be another vertex's are not passed over") {
  check_refused("OFF\n4 1 0\n0 0 0 1 0 0\n0 1 0 1 1 0\n4 0 1 2 3\n", "it:3: a vertex is followed by 3 more numbers");
  check_refused("OFF\n3 2 0\n" + points + "3 0 1 2 3 2 1 0\n", "the file ends");
  check_refused("OFF\n3 2 0\n" + points + "3 0 1 2  3 2 1 0 1\n", "a face is followed by 5 more numbers");
}

TEST_CASE("OFF: coordinates that are none, and more than there is room for") {
  check_refused("OFF\n3 1 0\n0 nan 0\n", "it:3: coordinate \"nan\" is not finite");
  check_refused("OFF\n3 1 0\n0 0,5 0\n", "\"0,5\" is not a number");
  check_refused("OFF\n3 1 0\n0 1e400 0\n", "beyond the range of double");
  const ReadLimits limits{std::uint64_t{1} << 26};
  check_refused("OFF\n4294967295 1 0\n", "it:2: the mesh that is announced needs about", limits);
  check_refused("OFF\n1 1000000000 0\n", "the limit is 67108864; raise it", limits);
  check_refused("OFF\n4294967296 1 0\n", "is too large; divide it");
  check_refused("OFF\n18446744073709551615 9223372036854775807 0\n", "is too large; divide it");
}

}  // namespace sightline::tests::off_reader_test
