#include "formats/reading/stl_reader.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "formats/reading/mesh_collector.h"
#include "formats/reading/mesh_warnings.h"

namespace sightline::inline formats {

namespace {

bool is_word(std::string_view token, std::string_view word) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::ranges::equal(token, word, {}, lower);
}

class StlParser {
 public:
  StlParser(InputBytes& in, const ReadLimits& limits, Normals normals) : in_(in), mesh_(in, limits, normals) {}

  MeshFile parse_text();
  MeshFile parse_binary();

 private:
  void expect(std::string_view word);
  void parse_solid();
  void parse_facet();
  Vector3 parse_normal();
  Vector3 next_position();
  Vector3 next_floats();
  void add_facet(const Vector3& normal, const std::array<Point3, 3>& corners);
  MeshFile finish();

  InputBytes& in_;
  MeshCollector mesh_;
  std::uint64_t vertex_count_ = 0;
  std::size_t against_winding_ = 0;
};

void StlParser::expect(std::string_view word) {
  const std::string_view token = in_.next_token();
  if (token.empty()) in_.fail_at_end();
  if (!is_word(token, word))
    in_.fail("STL needs \"" + std::string(word) + "\" here, not " + quoted(token) + "; export the mesh again");
}

// Numbers that are none are no reason to refuse what nobody asks for.
Vector3 StlParser::parse_normal() {
  std::array<double, 3> normal{};
  for (double& x : normal) {
    const std::string_view token = in_.next_token_of_line();
    try {
      x = parse_coordinate(token);
    } catch (const std::invalid_argument&) {
      x = 0;
    }
  }
  return {normal[0], normal[1], normal[2]};
}

Vector3 StlParser::next_position() {
  expect("vertex");
  std::array<double, 3> position{};
  for (double& x : position) x = coordinate_of(in_, in_.next_token());
  return {position[0], position[1], position[2]};
}

void StlParser::parse_facet() {
  expect("normal");
  const Vector3 normal = parse_normal();
  in_.leave_line();
  expect("outer");
  expect("loop");
  std::array<Point3, 3> corners;
  for (Point3& corner : corners) corner = next_position();
  expect("endloop");
  expect("endfacet");
  add_facet(normal, corners);
}

void StlParser::parse_solid() {
  in_.leave_line();
  for (std::string_view token = in_.next_token(); !is_word(token, "endsolid"); token = in_.next_token()) {
    if (token.empty()) in_.fail_at_end();
    if (!is_word(token, "facet"))
      in_.fail("STL needs \"facet\" or \"endsolid\" here, not " + quoted(token) + "; export the mesh again");
    parse_facet();
  }
  in_.leave_line();
}

MeshFile StlParser::parse_text() {
  (void)in_.skip("\xEF\xBB\xBF");
  expect("solid");
  parse_solid();
  for (std::string_view token = in_.next_token(); !token.empty(); token = in_.next_token()) {
    if (!is_word(token, "solid"))
      in_.fail("STL needs \"solid\" or the end here, not " + quoted(token) + "; export the mesh again");
    parse_solid();
  }
  return finish();
}

Vector3 StlParser::next_floats() {
  std::array<double, 3> numbers{};
  for (double& x : numbers) x = double{float_of(in_.take(4), std::endian::little)};
  return {numbers[0], numbers[1], numbers[2]};
}

MeshFile StlParser::parse_binary() {
  in_.begin_binary();
  in_.pass_over(stl_header_size - 4);
  const auto count = unsigned_of<std::uint32_t>(in_.take(4), std::endian::little);
  mesh_.expect(3 * std::uint64_t{count}, count);
  for (std::uint32_t f = 0; f < count; ++f) {
    const Vector3 normal = next_floats();
    std::array<Point3, 3> corners;
    for (Point3& corner : corners) corner = next_floats();
    in_.pass_over(2);
    add_facet(normal, corners);
  }
  if (!in_.at_end()) mesh_.warn("what follows the last triangle is not read");
  return finish();
}

// A normal that is not finite makes no comparison true.
void StlParser::add_facet(const Vector3& normal, const std::array<Point3, 3>& corners) {
  for (const Point3& corner : corners) {
    mesh_.add_vertex(corner);
    ++vertex_count_;
    mesh_.add_corner(static_cast<std::int64_t>(vertex_count_) - 1, vertex_count_);
  }
  mesh_.end_face();
  const Vector3 of_winding = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  if (of_winding.dot(normal) < -0.5 * norm(of_winding) * norm(normal)) ++against_winding_;
}

MeshFile StlParser::finish() {
  if (against_winding_ > 0)
    mesh_.warn("the normals of " + counted(against_winding_, "facet") +
               " point against the winding of the corners; the winding counts");
  mesh_.weld();
  return std::move(mesh_).finish();
}

}  // namespace

MeshFile read_stl_text(InputBytes& in, const ReadLimits& limits, Normals normals) {
  return StlParser(in, limits, normals).parse_text();
}

MeshFile read_stl_binary(InputBytes& in, const ReadLimits& limits, Normals normals) {
  return StlParser(in, limits, normals).parse_binary();
}

}  // namespace sightline::inline formats
