#include "formats/importing/gltf_document.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "formats/importing/packed_bytes.h"
#include "formats/reading/input_bytes.h"
#include "formats/reading/printable.h"

namespace sightline::inline formats {

using Json = nlohmann::json;

namespace {

std::size_t component_size(GltfRows::Component component) {
  using Component = GltfRows::Component;
  if (component == Component::int8 || component == Component::uint8) return 1;
  return component == Component::int16 || component == Component::uint16 ? 2 : 4;
}

GltfRows::Component component_of(const Json& accessor) {
  const std::uint64_t type = whole_number(member(accessor, "componentType"));
  constexpr std::array<std::uint64_t, 6> known{5120, 5121, 5122, 5123, 5125, 5126};
  if (std::ranges::find(known, type) == known.end())
    throw GltfError("an accessor has the unknown componentType " + std::to_string(type));
  return static_cast<GltfRows::Component>(type);
}

// The extensions that a file needs but that say nothing of where its surface is.
bool is_harmless(const std::string& extension) {
  constexpr std::array<std::string_view, 5> starts{"KHR_materials_", "KHR_texture_", "EXT_texture_", "KHR_lights_",
                                                   "KHR_mesh_quantization"};
  return std::ranges::any_of(starts, [&](std::string_view start) { return extension.starts_with(start); });
}

std::string in_quotes(const std::string& text) { return '"' + printable(text) + '"'; }

// Returns what %XX stands for.
std::string without_escapes(const std::string& uri) {
  constexpr std::string_view digits = "0123456789abcdef";
  const auto digit = [&](char c) { return digits.find(static_cast<char>(c >= 'A' && c <= 'F' ? c | 0x20 : c)); };
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool escaped = uri[i] == '%' && i + 2 < uri.size() && digit(uri[i + 1]) < 16 && digit(uri[i + 2]) < 16;
    text += escaped ? static_cast<char>(16 * digit(uri[i + 1]) + digit(uri[i + 2])) : uri[i];
    if (escaped) i += 2;
  }
  return text;
}

bool is_plain_name(const std::string& name) {
  return !name.empty() && name != "." && name != ".." &&
         name.find_first_of(std::string_view("/\\:\0", 4)) == std::string::npos;
}

}  // namespace

const Json& member(const Json& object, const char* name) {
  if (!object.is_object() || !object.contains(name)) throw GltfError("the member " + std::string(name) + " is missing");
  return object.at(name);
}

const Json& list(const Json& object, const char* name) {
  const Json& found = member(object, name);
  if (!found.is_array()) throw GltfError(std::string(name) + " is no list");
  return found;
}

const Json& item(const Json& document, const char* list_name, std::uint64_t index) {
  const Json& items = list(document, list_name);
  if (index >= items.size())
    throw GltfError("number " + std::to_string(index) + " of " + std::to_string(items.size()) + " " + list_name +
                    " is asked for, counted from 0");
  return items[index];
}

std::uint64_t whole_number(const Json& number) {
  if (!number.is_number_unsigned()) throw GltfError(printable(number.dump(-1, ' ', true)) + " is no count or index");
  return number.get<std::uint64_t>();
}

std::uint64_t whole_number(const Json& object, const char* name, std::uint64_t otherwise) {
  return object.is_object() && object.contains(name) ? whole_number(object.at(name)) : otherwise;
}

std::vector<double> numbers(const Json& array, std::size_t count) {
  if (!array.is_array() || array.size() != count)
    throw GltfError("a list of " + std::to_string(count) + " numbers is needed");
  std::vector<double> values;
  for (const Json& number : array) {
    if (!number.is_number() || !std::isfinite(number.get<double>())) throw GltfError("a list has what is no number");
    values.push_back(number.get<double>());
  }
  return values;
}

std::string_view GltfRows::bytes(std::uint64_t row, std::size_t column) const {
  const std::size_t size = component_size(component_);
  return bytes_.substr(row * stride_ + column * size, size);
}

double GltfRows::number(std::uint64_t row, std::size_t column) const {
  const std::string_view at = bytes(row, column);
  constexpr auto little = std::endian::little;
  // As KHR_mesh_quantization says.
  const auto scaled = [&](double value, double most) { return normalized_ ? std::max(value / most, -1.0) : value; };
  switch (component_) {
    case Component::int8:
      return scaled(static_cast<std::int8_t>(unsigned_of<std::uint8_t>(at, little)), 127);
    case Component::uint8:
      return scaled(unsigned_of<std::uint8_t>(at, little), 255);
    case Component::int16:
      return scaled(static_cast<std::int16_t>(unsigned_of<std::uint16_t>(at, little)), 32767);
    case Component::uint16:
      return scaled(unsigned_of<std::uint16_t>(at, little), 65535);
    case Component::uint32:
      return unsigned_of<std::uint32_t>(at, little);
    default:
      return double{float_of(at, little)};
  }
}

std::uint32_t GltfRows::index(std::uint64_t row) const {
  const std::string_view at = bytes(row, 0);
  if (component_ == Component::uint8) return unsigned_of<std::uint8_t>(at, std::endian::little);
  if (component_ == Component::uint16) return unsigned_of<std::uint16_t>(at, std::endian::little);
  return unsigned_of<std::uint32_t>(at, std::endian::little);
}

GltfDocument::GltfDocument(std::string_view bytes, FileBeside file_beside) : file_beside_(std::move(file_beside)) {
  if (bytes.starts_with("glTF")) {
    parse_container(bytes);
  } else {
    parse_json(bytes);
  }
  check_version();
  if (json_.contains("buffers")) buffers_.resize(list(json_, "buffers").size());
}

// A container has a header of 12 bytes, and chunks: JSON, and a buffer that may be missing.
void GltfDocument::parse_container(std::string_view bytes) {
  const auto number = [&](std::size_t place) {
    if (place + 4 > bytes.size()) throw GltfError("the file ends before its JSON does");
    return std::size_t{unsigned_of<std::uint32_t>(bytes.substr(place, 4), std::endian::little)};
  };
  if (number(4) != 2) throw GltfError("binary glTF is read in version 2, not " + std::to_string(number(4)));
  if (number(8) > bytes.size()) throw GltfError("the file ends before its chunks do");
  const std::size_t json_size = number(12);
  if (number(16) != 0x4E4F534A || json_size > bytes.size() - 20) throw GltfError("the first chunk is no JSON");
  parse_json(bytes.substr(20, json_size));
  const std::size_t next = 20 + json_size;
  if (next + 8 > bytes.size() || number(next + 4) != 0x004E4942) return;
  if (number(next) > bytes.size() - next - 8) throw GltfError("the file ends before its buffer does");
  chunk_ = bytes.substr(next + 8, number(next));
}

void GltfDocument::parse_json(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  json_ = Json::parse(text, nullptr, false);
  if (json_.is_discarded() || !json_.is_object()) throw GltfError("the JSON is none");
}

void GltfDocument::check_version() const {
  const Json& version = member(member(json_, "asset"), "version");
  if (!version.is_string() || !version.get<std::string>().starts_with("2."))
    throw GltfError("glTF is read in version 2.0, not " + printable(version.dump(-1, ' ', true)));
  if (!json_.contains("extensionsRequired")) return;
  for (const Json& extension : list(json_, "extensionsRequired")) {
    if (!extension.is_string() || !is_harmless(extension.get<std::string>()))
      throw GltfError("it needs the extension " + printable(extension.dump(-1, ' ', true)) + ", which is not read");
  }
}

std::string GltfDocument::load(const std::string& uri) const {
  if (uri.starts_with("data:")) {
    const std::size_t comma = std::min(uri.find(','), uri.size());
    const auto bytes = uri.substr(0, comma).ends_with(";base64")
                           ? from_base64(uri.substr(std::min(comma + 1, uri.size())))
                           : std::nullopt;
    if (!bytes) throw GltfError("a buffer in the JSON is not in base64");
    return *bytes;
  }
  const std::string name = without_escapes(uri);
  if (!is_plain_name(name))
    throw GltfError("the buffer " + in_quotes(name) +
                    " is elsewhere; only files beside the mesh are opened, by their plain name");
  if (!file_beside_) throw GltfError("the buffer " + in_quotes(name) + " is in another file");
  return file_beside_(name);
}

std::string_view GltfDocument::buffer(std::uint64_t index) {
  const Json& description = item(json_, "buffers", index);
  if (!description.is_object() || !description.contains("uri")) {
    if (index != 0 || !chunk_) throw GltfError("buffer " + std::to_string(index) + " has no bytes");
    return *chunk_;
  }
  const Json& uri = description.at("uri");
  if (!uri.is_string()) throw GltfError("buffer " + std::to_string(index) + " has no uri");
  if (!buffers_[index]) buffers_[index] = load(uri.get<std::string>());
  return *buffers_[index];
}

// Returns the bytes of an accessor's view from its first row on; 0 stands for rows without a gap.
std::string_view GltfDocument::view(const Json& accessor, std::uint64_t& stride) {
  if (!accessor.contains("bufferView") || accessor.contains("sparse"))
    throw GltfError("an accessor is sparse, or has no bufferView, which is not read");
  const Json& description = item(json_, "bufferViews", whole_number(accessor.at("bufferView")));
  const std::string_view all = buffer(whole_number(member(description, "buffer")));
  const std::uint64_t begin = whole_number(description, "byteOffset", 0);
  const std::uint64_t size = whole_number(member(description, "byteLength"));
  if (begin > all.size() || size > all.size() - begin) throw GltfError("a bufferView goes beyond its buffer");
  stride = whole_number(description, "byteStride", 0);
  const std::uint64_t offset = whole_number(accessor, "byteOffset", 0);
  if (offset > size) throw GltfError("an accessor goes beyond its bufferView");
  return all.substr(begin, size).substr(offset);
}

GltfRows GltfDocument::rows(const Json& accessor, std::size_t columns) {
  GltfRows rows;
  rows.component_ = component_of(accessor);
  rows.normalized_ = accessor.contains("normalized") && accessor.at("normalized") == true;
  rows.count_ = whole_number(member(accessor, "count"));
  rows.bytes_ = view(accessor, rows.stride_);
  const std::uint64_t row_size = columns * component_size(rows.component_);
  if (rows.stride_ == 0) rows.stride_ = row_size;
  if (rows.stride_ < row_size || rows.stride_ > 252) throw GltfError("a byteStride is no stride of its rows");
  const std::uint64_t size = rows.bytes_.size();
  if (rows.count_ > 0 && (row_size > size || rows.count_ - 1 > (size - row_size) / rows.stride_))
    throw GltfError("an accessor goes beyond its bufferView");
  return rows;
}

GltfRows GltfDocument::vectors(std::uint64_t accessor) {
  const Json& description = item(json_, "accessors", accessor);
  if (member(description, "type") != "VEC3") throw GltfError("an accessor of positions or normals is no VEC3");
  return rows(description, 3);
}

GltfRows GltfDocument::indices(std::uint64_t accessor) {
  const Json& description = item(json_, "accessors", accessor);
  const GltfRows found = rows(description, 1);
  using Component = GltfRows::Component;
  const bool is_index = found.component_ == Component::uint8 || found.component_ == Component::uint16 ||
                        found.component_ == Component::uint32;
  if (member(description, "type") != "SCALAR" || !is_index) throw GltfError("an accessor of indices has another type");
  return found;
}

}  // namespace sightline::inline formats
