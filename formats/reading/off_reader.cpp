#include "formats/reading/off_reader.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <optional>
#include <string>

#include "formats/reading/mesh_collector.h"
#include "formats/reading/mesh_warnings.h"

namespace sightline::inline formats {

namespace {

// What a keyword like STCNOFF8 is made of.
struct OffKeyword {
  bool has_texture = false;
  bool has_colours = false;
  bool has_normals = false;
  bool has_other_dimension = false;
  std::string first_count;  // where it follows without a blank
};

bool skip_prefix(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

bool is_digits(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

std::optional<OffKeyword> parse_off_keyword(std::string_view token) {
  OffKeyword keyword;
  keyword.has_texture = skip_prefix(token, "ST");
  keyword.has_colours = skip_prefix(token, "C");
  keyword.has_normals = skip_prefix(token, "N");
  keyword.has_other_dimension = skip_prefix(token, "4");
  keyword.has_other_dimension = skip_prefix(token, "n") || keyword.has_other_dimension;
  if (!skip_prefix(token, "OFF") || !is_digits(token)) return std::nullopt;
  keyword.first_count = token;
  return keyword;
}

class OffParser {
 public:
  OffParser(InputBytes& in, const ReadLimits& limits, Normals normals) : in_(in), mesh_(in, limits, normals) {}

  MeshFile parse();

 private:
  void parse_keyword();
  void parse_counts();
  void parse_vertex();
  void parse_face();
  Vector3 next_vector();
  void pass_over_numbers(const char* what, std::initializer_list<std::size_t> allowed);

  InputBytes& in_;
  MeshCollector mesh_;
  OffKeyword keyword_;
  std::uint64_t vertex_count_ = 0;
  std::uint64_t face_count_ = 0;
};

MeshFile OffParser::parse() {
  (void)in_.skip("\xEF\xBB\xBF");
  in_.set_comment('#');
  parse_keyword();
  parse_counts();
  for (std::uint64_t v = 0; v < vertex_count_; ++v) parse_vertex();
  for (std::uint64_t f = 0; f < face_count_; ++f) parse_face();
  warn_about_rest(in_, true, mesh_);
  return std::move(mesh_).finish();
}

void OffParser::parse_keyword() {
  const std::string_view token = in_.next_token();
  const auto keyword = parse_off_keyword(token);
  if (!keyword) in_.fail("an OFF file begins with OFF, not with " + quoted(token) + "; export the mesh again");
  if (keyword->has_other_dimension)
    in_.fail("OFF in other than three dimensions, " + quoted(token) + ", is not read; project it, and save it as OFF");
  keyword_ = *keyword;
}

void OffParser::parse_counts() {
  const std::string token = keyword_.first_count.empty() ? std::string(in_.next_token()) : keyword_.first_count;
  if (token == "BINARY") in_.fail("OFF in binary is not read; save it as OFF in text, or as PLY");
  vertex_count_ = count_of(in_, token, "vertices");
  face_count_ = count_of(in_, in_.next_token(), "faces");
  pass_over_numbers("the line of counts", {0, 1});
  mesh_.expect(vertex_count_, face_count_);
}

// Passes over the rest of a line, which may have so many words.
void OffParser::pass_over_numbers(const char* what, std::initializer_list<std::size_t> allowed) {
  std::size_t count = 0;
  while (!in_.next_token_of_line().empty()) ++count;
  if (std::ranges::find(allowed, count) != allowed.end()) return;
  in_.fail(std::string(what) + " is followed by " + counted(count, "more number") +
           " on its line; give vertices and faces lines of their own, and write COFF where vertices have colours");
}

Vector3 OffParser::next_vector() {
  std::array<double, 3> numbers{};
  for (double& x : numbers) x = coordinate_of(in_, in_.next_token());
  return {numbers[0], numbers[1], numbers[2]};
}

void OffParser::parse_vertex() {
  const Point3 position = next_vector();
  mesh_.add_vertex(position, keyword_.has_normals ? next_vector() : Vector3::Zero());
  const std::size_t of_texture = keyword_.has_texture ? 2 : 0;
  if (keyword_.has_colours) {
    pass_over_numbers("a vertex", {of_texture + 1, of_texture + 3, of_texture + 4});
  } else {
    pass_over_numbers("a vertex", {of_texture});
  }
}

void OffParser::parse_face() {
  const std::uint64_t corners = count_of(in_, in_.next_token(), "corners");
  for (std::uint64_t i = 0; i < corners; ++i) {
    const std::string_view token = in_.next_token();
    if (token.empty()) in_.fail_at_end();
    const auto index = parse_integer(token);
    if (!index) in_.fail("corner " + quoted(token) + " is no index of a vertex; export the mesh again");
    mesh_.add_corner(*index, vertex_count_);
  }
  mesh_.end_face();
  pass_over_numbers("a face", {0, 1, 3, 4});
}

}  // namespace

bool is_off_keyword(std::string_view token) { return parse_off_keyword(token).has_value(); }

MeshFile read_off(InputBytes& in, const ReadLimits& limits, Normals normals) {
  return OffParser(in, limits, normals).parse();
}

}  // namespace sightline::inline formats
