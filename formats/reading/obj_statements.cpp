#include "formats/reading/obj_statements.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <stdexcept>

#include "formats/reading/obj_scanner.h"
#include "formats/reading/region_recorder.h"
#include "geometry/numbers/errors.h"

namespace sightline::inline formats {

namespace {

// These keywords add nothing to the surface: they are for attributes, rendering, points and lines.
constexpr std::array passed_over{"vt",     "vn",    "vp",  "p",        "l",        "mg",         "usemap",
                                 "maplib", "bevel", "lod", "c_interp", "d_interp", "shadow_obj", "trace_obj"};

// More libraries are not looked for.
constexpr std::size_t most_libraries = 100;

class StatementParser {
 public:
  StatementParser(ObjScanner& scanner, const std::string& file_name, const ReadLimits& limits, Normals normals)
      : scanner_(scanner), file_name_(file_name), limits_(limits), reads_normals_(normals == Normals::read) {}

  ObjStatements parse();

 private:
  // Only the last part of a file can show where an index that is too large now leads. What is noted are the highest so
  // far: of several that lead nowhere, the first is one of these.
  struct ForwardReference {
    std::int64_t index;
    std::size_t line;
  };

  [[noreturn]] void fail(const std::string& cause) const { throw InputError(file_name_, scanner_.line(), cause); }
  void parse_statement(std::string_view keyword);
  void parse_vertex();
  void parse_normal();
  Vector3 next_coordinates(const char* needed);
  double next_coordinate(const char* needed);
  void parse_face();
  bool parse_region(std::string_view keyword);
  void parse_libraries();
  std::string rest_of_statement();
  std::vector<std::string> tokens_of_statement(std::size_t most);
  VertexId parse_corner(std::string_view token);
  VertexId resolve(std::int64_t index, std::string_view token);
  // This is the attribute, counted from 0, that an optional index into `count` of them names; it is nothing where the
  // index is empty.
  struct Attribute {
    bool missing = false;  // the index names nothing
    std::optional<std::size_t> number;
  };
  Attribute attribute(std::string_view token, std::size_t count, std::string_view index_text) const;
  Vector3 parse_attributes(std::string_view token, std::string_view attributes);
  void note_unknown(std::string_view keyword);
  void check_forward_references() const;
  void check_memory() const;

  ObjScanner& scanner_;
  const std::string& file_name_;
  const ReadLimits limits_;
  const bool reads_normals_;
  ObjStatements result_;
  RegionRecorder regions_;
  std::vector<VertexId> corners_;
  std::vector<ForwardReference> forward_;
  std::size_t known_count_ = 0;
  std::size_t texture_count_ = 0;
  std::size_t normal_count_ = 0;
  std::vector<Vector3> normals_;
  bool attributes_missing_ = false;
};

ObjStatements StatementParser::parse() {
  for (auto keyword = scanner_.next_statement(); !keyword.empty(); keyword = scanner_.next_statement()) {
    parse_statement(keyword);
    check_memory();
  }
  if (known_count_ == 0 && result_.unknown_count > 0) {
    throw InputError(file_name_, result_.unknown_line,
                     "no OBJ file: no statement has an OBJ keyword, the first has " + result_.unknown_keyword +
                         "; name a file of a mesh");
  }
  check_forward_references();
  result_.region_limits = regions_.limits_met();
  result_.regions = regions_.take();
  return std::move(result_);
}

void StatementParser::parse_statement(std::string_view keyword) {
  ++known_count_;
  if (keyword == "v") return parse_vertex();
  if (keyword == "f") return parse_face();
  if (keyword == "vt") ++texture_count_;
  if (keyword == "vn") return parse_normal();
  if (parse_region(keyword)) return;
  if (std::ranges::find(passed_over, keyword) != passed_over.end()) return;
  --known_count_;
  note_unknown(keyword);
}

// What is read of a name's tokens: more than the name keeps, so that it is seen to be cut.
std::string StatementParser::rest_of_statement() {
  std::string rest;
  for (auto token = scanner_.next_token(); !token.empty(); token = scanner_.next_token()) {
    if (rest.size() <= longest_region_name) rest += (rest.empty() ? "" : " ") + std::string(token);
  }
  return rest;
}

std::vector<std::string> StatementParser::tokens_of_statement(std::size_t most) {
  std::vector<std::string> tokens;
  for (auto token = scanner_.next_token(); !token.empty(); token = scanner_.next_token()) {
    if (tokens.size() < most) tokens.emplace_back(token.substr(0, longest_region_name + 1));
  }
  return tokens;
}

// Returns whether the keyword is one of those that say which region faces are in.
bool StatementParser::parse_region(std::string_view keyword) {
  if (keyword == "g") {
    regions_.set_groups(tokens_of_statement(most_groups_of_face + 1));
  } else if (keyword == "o") {
    regions_.set(RegionKind::object, rest_of_statement());
  } else if (keyword == "usemtl") {
    regions_.set(RegionKind::material, rest_of_statement());
  } else if (keyword == "s") {
    const std::string number = rest_of_statement();
    regions_.set(RegionKind::smoothing, number == "off" || number == "0" ? "" : number);
  } else if (keyword == "mtllib") {
    parse_libraries();
  } else {
    return false;
  }
  return true;
}

void StatementParser::parse_libraries() {
  const std::size_t line = scanner_.line();
  std::vector<std::string> names = tokens_of_statement(most_libraries);
  if (!names.empty() && result_.libraries.size() < most_libraries)
    result_.libraries.push_back({std::move(names), line});
}

void StatementParser::note_unknown(std::string_view keyword) {
  if (result_.unknown_count++ > 0) return;
  result_.unknown_line = scanner_.line();
  result_.unknown_keyword = quoted(keyword);
}

double StatementParser::next_coordinate(const char* needed) {
  const std::string_view token = scanner_.next_token();
  if (token.empty()) fail(needed);
  try {
    return parse_coordinate(token);
  } catch (const std::invalid_argument& error) {
    fail(std::string(error.what()) + "; correct it, or export the mesh again");
  }
}

Vector3 StatementParser::next_coordinates(const char* needed) {
  const double x = next_coordinate(needed);
  const double y = next_coordinate(needed);
  const double z = next_coordinate(needed);
  return {x, y, z};
}

void StatementParser::parse_vertex() {
  if (result_.vertices.size() == std::numeric_limits<std::uint32_t>::max())
    fail("more than 4294967295 vertices; divide the mesh");
  result_.vertices.push_back(next_coordinates("a vertex needs three coordinates; write them"));
}

// Where nobody asks for normals, whatever a file says of them is no reason to refuse it.
void StatementParser::parse_normal() {
  ++normal_count_;
  if (reads_normals_) normals_.push_back(next_coordinates("a normal needs three coordinates; write them"));
}

void StatementParser::parse_face() {
  corners_.clear();
  attributes_missing_ = false;
  for (auto token = scanner_.next_token(); !token.empty(); token = scanner_.next_token()) {
    if (corners_.size() == most_corners)
      fail("a face of more than " + std::to_string(most_corners) + " corners; divide it");
    corners_.push_back(parse_corner(token));
  }
  if (attributes_missing_) result_.faces_with_missing_attributes.emplace_back(result_.faces.size());
  if (result_.faces.corners.size() + corners_.size() > std::numeric_limits<std::uint32_t>::max())
    fail("more than 4294967295 corners; divide the mesh");
  result_.faces.push_back(corners_);
  regions_.add_face();
}

VertexId StatementParser::parse_corner(std::string_view token) {
  const std::size_t slash = std::min(token.find('/'), token.size());
  const auto index = parse_integer(token.substr(0, slash));
  if (!index) fail("corner " + quoted(token) + " has no vertex index; write one");
  const Vector3 normal = slash < token.size() ? parse_attributes(token, token.substr(slash + 1)) : Vector3::Zero();
  if (reads_normals_) result_.corner_normals.push_back(normal);
  return resolve(*index, token);
}

VertexId StatementParser::resolve(std::int64_t index, std::string_view token) {
  const auto count = static_cast<std::int64_t>(result_.vertices.size());
  if (index == 0) fail("corner " + quoted(token) + ": vertices count from 1; correct it");
  if (index < -count || index > std::numeric_limits<std::uint32_t>::max())
    fail("corner " + quoted(token) + " names no vertex; correct it");
  if (index > count && (forward_.empty() || index > forward_.back().index))
    forward_.push_back({index, scanner_.line()});
  return VertexId(static_cast<std::size_t>(index < 0 ? count + index : index - 1));
}

StatementParser::Attribute StatementParser::attribute(std::string_view token, std::size_t count,
                                                      std::string_view index_text) const {
  if (index_text.empty()) return {};
  const auto index = parse_integer(index_text);
  if (!index) fail("corner " + quoted(token) + " has an index that is no integer; correct it");
  const auto end = static_cast<std::int64_t>(count);
  if (*index == 0 || *index > end || *index < -end) return {true, {}};
  return {false, static_cast<std::size_t>(*index > 0 ? *index - 1 : end + *index)};
}

// Parses what follows the vertex: VT or VT/VN. Returns the normal where it is given and asked for, else zero.
Vector3 StatementParser::parse_attributes(std::string_view token, std::string_view attributes) {
  const std::size_t slash = std::min(attributes.find('/'), attributes.size());
  const Attribute texture = attribute(token, texture_count_, attributes.substr(0, slash));
  const Attribute normal =
      slash == attributes.size() ? Attribute{} : attribute(token, normal_count_, attributes.substr(slash + 1));
  attributes_missing_ = attributes_missing_ || texture.missing || normal.missing;
  return reads_normals_ && normal.number ? normals_[*normal.number] : Vector3::Zero();
}

void StatementParser::check_memory() const {
  const PolygonList& faces = result_.faces;
  // Normals count twice: so many are held while a list grows.
  const std::uint64_t needed = memory_for_mesh(result_.vertices.size(), faces.corners.size(), faces.size()) +
                               2 * sizeof(Vector3) * (normals_.size() + result_.corner_normals.size()) +
                               regions_.memory();
  if (needed <= limits_.memory) return;
  fail("the mesh up to here needs about " + std::to_string(needed) + " bytes of memory, and the limit is " +
       std::to_string(limits_.memory) + "; raise it with --max-memory");
}

void StatementParser::check_forward_references() const {
  const auto count = static_cast<std::int64_t>(result_.vertices.size());
  for (const auto& [index, line] : forward_) {
    if (index <= count) continue;
    throw InputError(file_name_, line,
                     "a corner names vertex " + std::to_string(index) + " of " + std::to_string(count) +
                         "; correct it, or add the vertex");
  }
}

[[noreturn]] void refuse_utf16(const std::string& file_name, const std::string& endian) {
  throw InputError(file_name, 1, "the text is UTF-16 (" + endian + " endian); save it as UTF-8");
}

}  // namespace

// Measured with sightline_memory (bench/memory_bench.cpp) on generated surfaces of 10^4 and 10^5 triangles and on
// meshes of public collections: what reading, building, looking for contacts and projecting held at once was at most
// 130 bytes per corner of a facet, vertices included, where facets share vertices, and 260 where none do. A face of k
// corners makes at most k - 2 triangles. The rest are upper bounds from what is kept: per vertex its position twice
// over while the list grows, its sorting and welding; per face its bookkeeping.
std::uint64_t memory_for_mesh(std::uint64_t vertices, std::uint64_t corners, std::uint64_t faces) {
  const std::uint64_t of_triangles = 3 * (corners - std::min(corners, 2 * faces));
  return (std::uint64_t{8} << 20) + 96 * vertices + 160 * std::max(corners, of_triangles) + 64 * faces;
}

ObjStatements parse_obj_statements(ObjScanner& scanner, const std::string& file_name, const ReadLimits& limits,
                                   Normals normals) {
  if (scanner.skip("\xFF\xFE")) refuse_utf16(file_name, "little");
  if (scanner.skip("\xFE\xFF")) refuse_utf16(file_name, "big");
  (void)scanner.skip("\xEF\xBB\xBF");
  try {
    return StatementParser(scanner, file_name, limits, normals).parse();
  } catch (const TokenTooLong& error) {
    throw InputError(file_name, scanner.line(), error.what());
  }
}

}  // namespace sightline::inline formats
