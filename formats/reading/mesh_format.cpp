#include "formats/reading/mesh_format.h"

#include <algorithm>
#include <array>
#include <bit>

#include "formats/reading/input_bytes.h"
#include "formats/reading/off_reader.h"
#include "formats/reading/stl_reader.h"

namespace sightline::inline formats {

namespace {

using namespace std::string_view_literals;

constexpr std::string_view save_as = "; save the mesh as PLY, STL or OBJ";
constexpr std::string_view unpack = "; unpack it, and give the mesh that is in it";

// Files with these bytes at this place are known, and not read here.
struct Mark {
  std::size_t place;
  std::string_view bytes;
  std::string_view what;
  std::string_view remedy = save_as;
};
constexpr std::array marks{
    Mark{0, "\x1F\x8B"sv, "a gzip archive", unpack},
    Mark{0, "BZh"sv, "a bzip2 archive", unpack},
    Mark{0,
         "\xFD"
         "7zXZ\0"sv,
         "an xz archive", unpack},
    Mark{0, "\x28\xB5\x2F\xFD"sv, "a zstd archive", unpack},
    Mark{0, "7z\xBC\xAF\x27\x1C"sv, "a 7z archive", unpack},
    Mark{0, "Rar!\x1A\x07"sv, "a RAR archive", unpack},
    Mark{257, "ustar"sv, "a tar archive", unpack},
    Mark{0, "PK\x03\x04"sv, "a ZIP archive", unpack},
    Mark{0, "%PDF-"sv, "a PDF document", "; give the mesh, not a document of it"},
    Mark{0, "\x89PNG\r\n\x1A\n"sv, "a PNG image", "; give the mesh, not a picture of it"},
    Mark{0, "\xFF\xD8\xFF"sv, "a JPEG image", "; give the mesh, not a picture of it"},
    Mark{0, "GIF8"sv, "a GIF image", "; give the mesh, not a picture of it"},
    Mark{0, "II*\0"sv, "a TIFF image", "; give a mesh; heights must be made one first"},
    Mark{0, "MM\0*"sv, "a TIFF image", "; give a mesh; heights must be made one first"},
    Mark{0, "ISO-10303-21"sv, "a STEP file (curved surfaces)", "; save it as STL or OBJ from a CAD program"},
    Mark{72, "S      1"sv, "an IGES file (curved surfaces)", "; save it as STL or OBJ from a CAD program"},
    Mark{0, "**ABCDEFGHIJKLMNOPQRSTUVWXYZ"sv, "a Parasolid file (curved surfaces)",
         "; save it as STL or OBJ from a CAD program"},
    Mark{0, "\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1"sv, "a compound document (of a CAD program, perhaps)",
         "; save it as STL or OBJ from that program"},
    Mark{0, "Kaydara FBX Binary"sv, "an FBX file"},
    Mark{0, "; FBX"sv, "an FBX file"},
    Mark{0, "BLENDER"sv, "a Blender file"},
    Mark{0, "#VRML"sv, "a VRML file"},
    Mark{0, "#X3D"sv, "an X3D file"},
    Mark{0, "# vtk DataFile"sv, "a VTK file"},
    Mark{0, "#usda"sv, "a USD file"},
    Mark{0, "PXR-USDC"sv, "a USD file"},
    Mark{0, "Ogawa"sv, "an Alembic file"},
    Mark{0, "\x89HDF\r\n"sv, "an HDF5 file"},
    Mark{0, "DRACO"sv, "a Draco file"},
    Mark{0, "3D Geometry File Format"sv, "a Rhino file"},
    Mark{0, "FORM"sv, "an IFF file (LightWave, Maya)"},
    Mark{0, "AutoCAD Binary DXF"sv, "a DXF file"},
    Mark{0, "AC10"sv, "a DWG file"},
};

// XML, told by an element that is in the first bytes.
struct XmlKind {
  std::string_view element;
  std::string_view what;
};
constexpr std::array xml_kinds{XmlKind{"<COLLADA", "a COLLADA file (DAE)"},
                               XmlKind{"<X3D", "an X3D file"},
                               XmlKind{"<amf", "an AMF file"},
                               XmlKind{"<VTKFile", "a VTK file"},
                               XmlKind{"<model", "the model of a 3MF package"},
                               XmlKind{"<svg", "an SVG drawing"}};

constexpr std::string_view blanks = " \t\v\f\r\n";

std::string_view without_mark(std::string_view text) {
  return text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text;
}

std::string_view without_blanks(std::string_view text) {
  const std::size_t first = std::min(text.find_first_not_of(blanks), text.size());
  return text.substr(first);
}

// Returns whether the text begins with this word, in upper or lower case.
bool begins_with_word(std::string_view text, std::string_view word) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  if (text.size() < word.size() || !std::ranges::equal(text.substr(0, word.size()), word, {}, lower)) return false;
  return text.size() == word.size() || blanks.find(text[word.size()]) != std::string_view::npos;
}

// Returns the first word that is not in a comment.
std::string_view first_word(std::string_view text) {
  text = without_blanks(text);
  while (text.starts_with('#')) text = without_blanks(text.substr(std::min(text.find_first_of("\r\n"), text.size())));
  return text.substr(0, std::min(text.find_first_of(blanks), text.size()));
}

FoundFormat other(std::string_view what, std::string_view remedy) {
  return {MeshFormat::other, std::string(what) + " is not read here" + std::string(remedy)};
}

// Returns how many triangles a binary STL file of these first bytes has; nothing if it is too short for one.
std::optional<std::uint64_t> stl_triangles(std::string_view head) {
  if (head.size() < stl_header_size) return std::nullopt;
  return unsigned_of<std::uint32_t>(head.substr(stl_header_size - 4, 4), std::endian::little);
}

std::uint64_t stl_size(std::uint64_t triangles) { return stl_header_size + stl_facet_size * triangles; }

bool is_solid(std::string_view head) { return begins_with_word(without_blanks(without_mark(head)), "solid"); }

bool has_zero_byte(std::string_view bytes) { return bytes.find('\0') != std::string_view::npos; }

// Text of "solid" has no zero bytes; a header of 80 bytes that is filled up, and numbers after it, do.
std::optional<MeshFormat> stl_of(std::string_view head, std::optional<std::uint64_t> size) {
  const auto triangles = stl_triangles(head);
  if (triangles && size && *size == stl_size(*triangles)) return MeshFormat::stl_binary;
  if (!is_solid(head)) return std::nullopt;
  return has_zero_byte(head) && (!size || !triangles) ? MeshFormat::stl_binary : MeshFormat::stl_text;
}

// Returns a refusal for binary data that can only be STL of the wrong size; a text of so many bytes has line ends.
std::optional<FoundFormat> binary_of_wrong_size(std::string_view head, std::optional<std::uint64_t> size) {
  const auto triangles = stl_triangles(head);
  const std::string_view header = head.substr(0, stl_header_size);
  if (!triangles || !size || !has_zero_byte(header) || (!is_solid(head) && header.find('\n') != std::string_view::npos))
    return std::nullopt;
  return FoundFormat{MeshFormat::other, "binary data of no format that is known here; as STL it would be " +
                                            std::to_string(*triangles) + " triangles in " +
                                            std::to_string(stl_size(*triangles)) + " bytes, and it has " +
                                            std::to_string(*size) + "; export or copy the mesh again"};
}

bool is_three_mf(std::string_view head) {
  constexpr std::array parts{"3D/"sv, "[Content_Types].xml"sv, "_rels/"sv, "Metadata/"sv};
  constexpr std::size_t name_place = 30;
  if (!head.starts_with("PK\x03\x04") || head.size() < name_place) return false;
  const std::string_view name = head.substr(name_place);
  return std::ranges::any_of(parts, [&](std::string_view part) { return name.starts_with(part); });
}

std::optional<FoundFormat> marked(std::string_view head) {
  for (const Mark& mark : marks) {
    if (head.size() >= mark.place && head.substr(mark.place).starts_with(mark.bytes))
      return other(mark.what, mark.remedy);
  }
  return std::nullopt;
}

std::optional<FoundFormat> xml_of(std::string_view head) {
  if (!without_blanks(without_mark(head)).starts_with('<')) return std::nullopt;
  for (const XmlKind& kind : xml_kinds) {
    if (head.find(kind.element) != std::string_view::npos) return other(kind.what, save_as);
  }
  return other("XML of a kind that is not known here", save_as);
}

// The members of JSON come in any order.
bool is_gltf(std::string_view text) {
  constexpr std::array members{"\"asset\""sv, "\"accessors\""sv, "\"bufferViews\""sv, "\"buffers\""sv};
  const auto has = [&](std::string_view member) { return text.find(member) != std::string_view::npos; };
  return text.starts_with('{') && std::ranges::any_of(members, has);
}

std::optional<FoundFormat> text_of(std::string_view head) {
  const std::string_view text = without_blanks(without_mark(head));
  if (is_gltf(text)) return FoundFormat{MeshFormat::gltf, ""};
  const std::string_view word = first_word(without_mark(head));
  if (is_off_keyword(word)) return FoundFormat{MeshFormat::off, ""};
  if (word == "[mesh]" || word == "[[cameras]]")
    return other("a scene file", "; give a mesh, or let the name of the scene file end with .toml");
  if (word == "0" && first_word(text.substr(std::min(text.find('0') + 1, text.size()))) == "SECTION")
    return other("a DXF file", save_as);
  return std::nullopt;
}

}  // namespace

FoundFormat format_of(std::string_view head, std::optional<std::uint64_t> size) {
  if (head.starts_with("glTF")) return {MeshFormat::gltf_binary, ""};
  if (is_three_mf(head)) return {MeshFormat::three_mf, ""};
  if (begins_with_word(without_mark(head), "ply")) return {MeshFormat::ply, ""};
  if (const auto stl = stl_of(head, size)) {
    const auto wrong =
        *stl == MeshFormat::stl_text && has_zero_byte(head) ? binary_of_wrong_size(head, size) : std::nullopt;
    return wrong ? *wrong : FoundFormat{*stl, ""};
  }
  for (const auto& found : {marked(head), xml_of(head), text_of(head), binary_of_wrong_size(head, size)}) {
    if (found) return *found;
  }
  return {};
}

bool is_imported(MeshFormat format) {
  return format == MeshFormat::gltf || format == MeshFormat::gltf_binary || format == MeshFormat::three_mf;
}

}  // namespace sightline::inline formats
