// Files of meshes as bytes in memory, and what reading them gives.
#pragma once

#include <doctest/doctest.h>

#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "formats/importing/mesh_import.h"
#include "geometry/numbers/errors.h"
#include "tests/tools/obj_case.h"
#include "tests/tools/says_what_to_do.h"

namespace sightline::tests {

inline std::string bytes_in(const std::filesystem::path& file) {
  const std::ifstream in(file, std::ios::binary);
  std::ostringstream content;
  content << in.rdbuf();
  return content.str();
}

inline MeshFile imported(std::string_view bytes, Normals normals = Normals::passed_over) {
  MeshFile read = import_mesh(bytes, "it", {}, normals);
  CHECK(validate(read.mesh) == std::vector<std::string>{});
  CHECK(std::ranges::all_of(read.warnings, is_one_line));
  return read;
}

// Returns the message of a refusal; "read" if there is none. A message is one line, names the file, and says what to do.
inline std::string refusal_of(std::string_view bytes, const ReadLimits& limits = {}) {
  try {
    (void)import_mesh(bytes, "it", limits, Normals::passed_over);
    return "read";
  } catch (const InputError& error) {
    const std::string message = error.what();
    CHECK(is_one_line(message));
    CHECK(says_what_to_do(message));
    CHECK(message.starts_with(error.line() == 0 ? "it: " : "it:" + std::to_string(error.line()) + ": "));
    return message;
  }
}

inline void check_refused(std::string_view bytes, const std::string& part, const ReadLimits& limits = {}) {
  const std::string message = refusal_of(bytes, limits);
  INFO(message);
  CHECK(message.find(part) != std::string::npos);
}

inline void check_warned(const MeshFile& read, const std::string& part) {
  const auto has = [&](const std::string& warning) { return warning.find(part) != std::string::npos; };
  CHECK(std::ranges::any_of(read.warnings, has));
}

// The bytes of a number, in one order or the other.
template <class Number>
std::string raw(Number number, std::endian endian = std::endian::little) {
  std::string bytes(reinterpret_cast<const char*>(&number), sizeof number);
  if (endian != std::endian::native) std::ranges::reverse(bytes);
  return bytes;
}

inline std::vector<double> random_finite_doubles(std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::vector<double> values;
  while (values.size() < count) {
    const double value = std::bit_cast<double>(random() & (random() % 16 == 0 ? 0x800fffffffffffffULL : ~0ULL));
    if (std::isfinite(value)) values.push_back(value);
  }
  return values;
}

inline std::string with_17_digits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

inline void check_vertices_are(const Mesh& mesh, const std::vector<double>& values) {
  REQUIRE(3 * mesh.vertices.size() == values.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double read = mesh.vertices[i / 3][static_cast<Eigen::Index>(i % 3)];
    different += std::bit_cast<std::uint64_t>(read) != std::bit_cast<std::uint64_t>(values[i]) ? 1 : 0;
  }
  CHECK(different == 0);
}

}  // namespace sightline::tests
