// The parts of a glTF 2.0 file: its JSON, its buffers, and numbers in them. gltf_reader.h says what is read and refused.
//
// Errors: GltfError with the cause.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace sightline::inline formats {

class GltfError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Returns the bytes of a file beside the mesh, by its plain name.
using FileBeside = std::function<std::string(const std::string& name)>;

// Returns the member; it is an error if it is missing, or no list.
[[nodiscard]] const nlohmann::json& member(const nlohmann::json& object, const char* name);
[[nodiscard]] const nlohmann::json& list(const nlohmann::json& object, const char* name);
// Returns the item of a list of the document that an index names.
[[nodiscard]] const nlohmann::json& item(const nlohmann::json& document, const char* list_name, std::uint64_t index);
// Returns a number that counts or is an index; `otherwise` where it is missing.
[[nodiscard]] std::uint64_t whole_number(const nlohmann::json& number);
[[nodiscard]] std::uint64_t whole_number(const nlohmann::json& object, const char* name, std::uint64_t otherwise);
// Returns finite numbers, as many as are asked for.
[[nodiscard]] std::vector<double> numbers(const nlohmann::json& array, std::size_t count);

// What an accessor leads to: rows of numbers of one type in a buffer.
class GltfRows {
 public:
  enum class Component : std::uint16_t { int8 = 5120, uint8, int16, uint16, uint32 = 5125, float32 = 5126 };

  [[nodiscard]] std::uint64_t count() const { return count_; }
  // Precondition: row < count(), column < the columns that were asked for.
  [[nodiscard]] double number(std::uint64_t row, std::size_t column) const;
  [[nodiscard]] std::uint32_t index(std::uint64_t row) const;

 private:
  friend class GltfDocument;
  [[nodiscard]] std::string_view bytes(std::uint64_t row, std::size_t column) const;

  std::string_view bytes_;  // from the first row on
  Component component_ = Component::float32;
  bool normalized_ = false;
  std::uint64_t stride_ = 0;
  std::uint64_t count_ = 0;
};

class GltfDocument {
 public:
  // The bytes are a GLB container, or JSON; they outlive the document.
  GltfDocument(std::string_view bytes, FileBeside file_beside);

  [[nodiscard]] const nlohmann::json& json() const { return json_; }
  [[nodiscard]] GltfRows vectors(std::uint64_t accessor);
  [[nodiscard]] GltfRows indices(std::uint64_t accessor);

 private:
  void parse_container(std::string_view bytes);
  void parse_json(std::string_view text);
  void check_version() const;
  std::string_view buffer(std::uint64_t index);
  std::string load(const std::string& uri) const;
  std::string_view view(const nlohmann::json& accessor, std::uint64_t& stride);
  GltfRows rows(const nlohmann::json& accessor, std::size_t columns);

  nlohmann::json json_;
  std::optional<std::string_view> chunk_;            // the container's own buffer
  std::vector<std::optional<std::string>> buffers_;  // those that were loaded
  FileBeside file_beside_;
};

}  // namespace sightline::inline formats
