#include "formats/reading/ply_reader.h"

#include <array>

#include "formats/reading/mesh_collector.h"
#include "formats/reading/mesh_warnings.h"
#include "formats/reading/ply_header.h"

namespace sightline::inline formats {

namespace {

// The numbers after the header, one after the other.
class PlyNumbers {
 public:
  PlyNumbers(InputBytes& in, PlyEncoding encoding)
      : in_(in),
        is_text_(encoding == PlyEncoding::text),
        endian_(encoding == PlyEncoding::big_endian ? std::endian::big : std::endian::little) {}

  double next_coordinate(PlyType type);
  std::int64_t next_integer(PlyType type, const char* what);
  void pass_over(PlyType type, std::uint64_t count);
  // In text an element ends with its line; some programs write more numbers on it than they declare.
  void end_of_element();
  void warn_about_more(MeshCollector& mesh) const;

 private:
  std::int64_t binary_integer(PlyType type);

  InputBytes& in_;
  bool is_text_;
  std::endian endian_;
  std::size_t lines_with_more_ = 0;
  std::size_t first_line_with_more_ = 0;
};

std::int64_t PlyNumbers::binary_integer(PlyType type) {
  const std::string_view bytes = in_.take(size_of(type));
  switch (type) {
    case PlyType::int8:
      return static_cast<std::int8_t>(unsigned_of<std::uint8_t>(bytes, endian_));
    case PlyType::uint8:
      return unsigned_of<std::uint8_t>(bytes, endian_);
    case PlyType::int16:
      return static_cast<std::int16_t>(unsigned_of<std::uint16_t>(bytes, endian_));
    case PlyType::uint16:
      return unsigned_of<std::uint16_t>(bytes, endian_);
    case PlyType::int32:
      return static_cast<std::int32_t>(unsigned_of<std::uint32_t>(bytes, endian_));
    default:
      return unsigned_of<std::uint32_t>(bytes, endian_);
  }
}

double PlyNumbers::next_coordinate(PlyType type) {
  if (is_text_) return coordinate_of(in_, in_.next_token());
  if (type == PlyType::float32) return double{float_of(in_.take(4), endian_)};
  if (type == PlyType::float64) return double_of(in_.take(8), endian_);
  return static_cast<double>(binary_integer(type));
}

std::int64_t PlyNumbers::next_integer(PlyType type, const char* what) {
  if (!is_text_) return binary_integer(type);
  const std::string_view token = in_.next_token();
  if (token.empty()) in_.fail_at_end();
  const auto value = parse_integer(token);
  if (!value) in_.fail(quoted(token) + " is no " + what + "; export the mesh again");
  return *value;
}

void PlyNumbers::pass_over(PlyType type, std::uint64_t count) {
  if (!is_text_) return in_.pass_over(count * size_of(type));
  for (std::uint64_t i = 0; i < count; ++i) {
    if (in_.next_token().empty()) in_.fail_at_end();
  }
}

void PlyNumbers::end_of_element() {
  if (!is_text_ || in_.next_token_of_line().empty()) return;
  if (lines_with_more_++ == 0) first_line_with_more_ = in_.line();
  while (!in_.next_token_of_line().empty()) {
  }
}

void PlyNumbers::warn_about_more(MeshCollector& mesh) const {
  if (lines_with_more_ == 0) return;
  mesh.warn(counted(lines_with_more_, "line") +
            " with more numbers than the header declares, which are not read, from line " +
            std::to_string(first_line_with_more_) + " on");
}

class PlyParser {
 public:
  PlyParser(InputBytes& in, const ReadLimits& limits, Normals normals)
      : in_(in),
        header_(parse_ply_header(in)),
        numbers_(in, header_.encoding),
        mesh_(in, limits, normals),
        reads_normals_(normals == Normals::read) {}

  MeshFile parse();

 private:
  void parse_elements(const PlyElement& element);
  void parse_vertex(const PlyElement& element);
  void parse_face(const PlyElement& element);
  void pass_over(const PlyElement& element);
  void parse_corners(const PlyProperty& property);
  void pass_over(const PlyProperty& property);
  std::uint64_t next_length(const PlyProperty& property);

  InputBytes& in_;
  const PlyHeader header_;
  PlyNumbers numbers_;
  MeshCollector mesh_;
  const bool reads_normals_;
};

MeshFile PlyParser::parse() {
  mesh_.expect(header_.count(PlyElement::Kind::vertex), header_.count(PlyElement::Kind::face));
  const bool is_text = header_.encoding == PlyEncoding::text;
  if (!is_text) in_.begin_binary();
  for (const PlyElement& element : header_.elements) {
    // Nothing is there to be read, however often.
    if (!element.properties.empty()) parse_elements(element);
  }
  numbers_.warn_about_more(mesh_);
  warn_about_rest(in_, is_text, mesh_);
  return std::move(mesh_).finish();
}

void PlyParser::parse_elements(const PlyElement& element) {
  for (std::uint64_t i = 0; i < element.count; ++i) {
    if (element.kind == PlyElement::Kind::vertex) {
      parse_vertex(element);
    } else if (element.kind == PlyElement::Kind::face) {
      parse_face(element);
    } else {
      pass_over(element);
    }
    numbers_.end_of_element();
  }
}

std::uint64_t PlyParser::next_length(const PlyProperty& property) {
  const std::int64_t length = numbers_.next_integer(*property.count_type, "length of a list");
  if (length < 0) in_.fail("a list of length " + std::to_string(length) + "; export the mesh again");
  return static_cast<std::uint64_t>(length);
}

void PlyParser::pass_over(const PlyProperty& property) {
  numbers_.pass_over(property.type, property.count_type ? next_length(property) : 1);
}

void PlyParser::pass_over(const PlyElement& element) {
  for (const PlyProperty& property : element.properties) pass_over(property);
}

void PlyParser::parse_vertex(const PlyElement& element) {
  std::array<double, 3> position{};
  std::array<double, 3> normal{};
  for (const PlyProperty& property : element.properties) {
    if (property.role >= PlyRole::x && property.role <= PlyRole::z) {
      position[static_cast<std::size_t>(property.role) - static_cast<std::size_t>(PlyRole::x)] =
          numbers_.next_coordinate(property.type);
    } else if (reads_normals_ && property.role >= PlyRole::nx && property.role <= PlyRole::nz) {
      normal[static_cast<std::size_t>(property.role) - static_cast<std::size_t>(PlyRole::nx)] =
          numbers_.next_coordinate(property.type);
    } else {
      pass_over(property);
    }
  }
  mesh_.add_vertex({position[0], position[1], position[2]}, {normal[0], normal[1], normal[2]});
}

void PlyParser::parse_corners(const PlyProperty& property) {
  const std::uint64_t length = next_length(property);
  for (std::uint64_t i = 0; i < length; ++i)
    mesh_.add_corner(numbers_.next_integer(property.type, "index of a vertex"),
                     header_.count(PlyElement::Kind::vertex));
  mesh_.end_face();
}

void PlyParser::parse_face(const PlyElement& element) {
  for (const PlyProperty& property : element.properties) {
    if (property.role == PlyRole::corners) {
      parse_corners(property);
    } else {
      pass_over(property);
    }
  }
}

}  // namespace

MeshFile read_ply(InputBytes& in, const ReadLimits& limits, Normals normals) {
  return PlyParser(in, limits, normals).parse();
}

}  // namespace sightline::inline formats
