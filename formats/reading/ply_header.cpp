#include "formats/reading/ply_header.h"

#include <algorithm>
#include <array>

#include "formats/reading/mesh_collector.h"

namespace sightline::inline formats {

namespace {

// More of them are no mesh, but would have to be held.
constexpr std::size_t most_elements = 1000;
constexpr std::size_t most_properties = 10000;

// There are larger numbers of things of which nothing is held, but none that a file has room for.
constexpr std::uint64_t most_of_an_element = std::uint64_t{1} << 48;

struct PlyTypeName {
  std::string_view name;
  PlyType type;
};
constexpr std::array type_names{
    PlyTypeName{"char", PlyType::int8},      PlyTypeName{"int8", PlyType::int8},
    PlyTypeName{"uchar", PlyType::uint8},    PlyTypeName{"uint8", PlyType::uint8},
    PlyTypeName{"short", PlyType::int16},    PlyTypeName{"int16", PlyType::int16},
    PlyTypeName{"ushort", PlyType::uint16},  PlyTypeName{"uint16", PlyType::uint16},
    PlyTypeName{"int", PlyType::int32},      PlyTypeName{"int32", PlyType::int32},
    PlyTypeName{"uint", PlyType::uint32},    PlyTypeName{"uint32", PlyType::uint32},
    PlyTypeName{"float", PlyType::float32},  PlyTypeName{"float32", PlyType::float32},
    PlyTypeName{"double", PlyType::float64}, PlyTypeName{"float64", PlyType::float64},
};

PlyRole role_of_number(std::string_view name) {
  constexpr std::array<std::string_view, 6> names{"x", "y", "z", "nx", "ny", "nz"};
  constexpr std::array roles{PlyRole::x, PlyRole::y, PlyRole::z, PlyRole::nx, PlyRole::ny, PlyRole::nz};
  const auto* const found = std::ranges::find(names, name);
  return found == names.end() ? PlyRole::none : roles[static_cast<std::size_t>(found - names.begin())];
}

class PlyHeaderParser {
 public:
  explicit PlyHeaderParser(InputBytes& in) : in_(in) {}

  PlyHeader parse();

 private:
  void parse_format();
  void parse_element();
  void parse_property();
  PlyProperty parse_list();
  PlyType type_of(std::string_view token) const;
  void set_role(PlyProperty& property, std::string_view name);
  void check_elements();
  void check_element(const PlyElement& element);

  InputBytes& in_;
  PlyHeader header_;
  bool has_format_ = false;
  std::size_t property_count_ = 0;
};

PlyHeader PlyHeaderParser::parse() {
  (void)in_.skip("\xEF\xBB\xBF");
  (void)in_.next_token_of_line();
  in_.leave_line();
  for (std::string_view keyword = in_.next_token(); keyword != "end_header"; keyword = in_.next_token()) {
    if (keyword.empty()) in_.fail_at_end();
    if (keyword == "format") {
      parse_format();
    } else if (keyword == "element") {
      parse_element();
    } else if (keyword == "property") {
      parse_property();
    } else if (keyword != "comment" && keyword != "obj_info") {
      in_.fail(quoted(keyword) + " is no word of a PLY header; export the mesh again");
    }
    in_.leave_line();
  }
  check_elements();
  in_.leave_line();
  return std::move(header_);
}

void PlyHeaderParser::parse_format() {
  const std::string_view format = in_.next_token_of_line();
  constexpr std::array<std::string_view, 3> formats{"ascii", "binary_little_endian", "binary_big_endian"};
  const auto* const found = std::ranges::find(formats, format);
  if (found == formats.end())
    in_.fail("PLY is ascii, binary_little_endian or binary_big_endian, not " + quoted(format) +
             "; export the mesh again");
  header_.encoding = static_cast<PlyEncoding>(found - formats.begin());
  has_format_ = true;
  const std::string_view version = in_.next_token_of_line();
  if (version != "1.0") in_.fail("PLY is read in version 1.0, not " + quoted(version) + "; export the mesh again");
}

void PlyHeaderParser::parse_element() {
  if (header_.elements.size() == most_elements)
    in_.fail("more than " + std::to_string(most_elements) + " elements; export the mesh without what is not geometry");
  PlyElement element;
  const std::string name(in_.next_token_of_line());
  if (name == "tristrips") in_.fail("triangle strips (tristrips) are not read; export the mesh with faces");
  if (name == "vertex") element.kind = PlyElement::Kind::vertex;
  if (name == "face") element.kind = PlyElement::Kind::face;
  element.count = count_of(in_, in_.next_token_of_line(), "elements");
  if (element.count > most_of_an_element)
    in_.fail(std::to_string(element.count) + " are more elements than any file has; export the mesh again");
  const auto is_same = [&](const PlyElement& other) { return other.kind == element.kind; };
  if (element.kind != PlyElement::Kind::other && std::ranges::any_of(header_.elements, is_same))
    in_.fail("a second element " + quoted(std::string_view(name)) + "; export the mesh again");
  header_.elements.push_back(element);
}

PlyType PlyHeaderParser::type_of(std::string_view token) const {
  const auto* const found = std::ranges::find(type_names, token, &PlyTypeName::name);
  if (found == type_names.end())
    in_.fail(quoted(token) +
             " is no type of PLY (char, uchar, short, ushort, int, uint, float, double); export the "
             "mesh again");
  return found->type;
}

PlyProperty PlyHeaderParser::parse_list() {
  PlyProperty property;
  property.count_type = type_of(in_.next_token_of_line());
  property.type = type_of(in_.next_token_of_line());
  if (!is_integer(*property.count_type)) in_.fail("a list needs an integer for its length; export the mesh again");
  return property;
}

void PlyHeaderParser::parse_property() {
  if (header_.elements.empty()) in_.fail("a property before the first element; export the mesh again");
  if (++property_count_ > most_properties)
    in_.fail("more than " + std::to_string(most_properties) +
             " properties; export the mesh without what is not geometry");
  PlyProperty property;
  const std::string_view first = in_.next_token_of_line();
  if (first == "list") {
    property = parse_list();
  } else {
    property.type = type_of(first);
  }
  const std::string_view name = in_.next_token_of_line();
  if (name.empty()) in_.fail("a property needs a name; export the mesh again");
  set_role(property, name);
  header_.elements.back().properties.push_back(property);
}

void PlyHeaderParser::set_role(PlyProperty& property, std::string_view name) {
  const PlyElement& element = header_.elements.back();
  if (element.kind == PlyElement::Kind::vertex && !property.count_type) property.role = role_of_number(name);
  const bool names_corners = name == "vertex_indices" || name == "vertex_index";
  if (element.kind == PlyElement::Kind::face && property.count_type && names_corners) {
    property.role = PlyRole::corners;
    if (!is_integer(property.type)) in_.fail("corners need integers, not fractions; export the mesh again");
  }
  if (property.role != PlyRole::none && element.has(property.role))
    in_.fail("a second property " + quoted(name) + "; export the mesh again");
}

void PlyHeaderParser::check_element(const PlyElement& element) {
  if (element.kind == PlyElement::Kind::vertex) {
    for (const PlyRole role : {PlyRole::x, PlyRole::y, PlyRole::z}) {
      if (!element.has(role)) in_.fail("vertices need the properties x, y and z; export the mesh again");
    }
  }
  if (element.kind == PlyElement::Kind::face && element.count > 0 && !element.has(PlyRole::corners))
    in_.fail("faces need the property list vertex_indices; export the mesh again");
}

void PlyHeaderParser::check_elements() {
  if (!has_format_) in_.fail("the header has no format; export the mesh again");
  const auto is_vertex = [](const PlyElement& e) { return e.kind == PlyElement::Kind::vertex; };
  if (std::ranges::none_of(header_.elements, is_vertex))
    in_.fail("the header has no element vertex; export the mesh again");
  for (const PlyElement& element : header_.elements) check_element(element);
}

}  // namespace

std::size_t size_of(PlyType type) {
  constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

bool is_integer(PlyType type) { return type != PlyType::float32 && type != PlyType::float64; }

bool PlyElement::has(PlyRole role) const {
  return std::ranges::any_of(properties, [role](const PlyProperty& p) { return p.role == role; });
}

std::uint64_t PlyHeader::count(PlyElement::Kind kind) const {
  const auto found = std::ranges::find(elements, kind, &PlyElement::kind);
  return found == elements.end() ? 0 : found->count;
}

PlyHeader parse_ply_header(InputBytes& in) { return PlyHeaderParser(in).parse(); }

}  // namespace sightline::inline formats
