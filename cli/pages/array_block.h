// Named arrays of numbers as bytes, for a page: what JavaScript opens as typed arrays without a copy.
//
// Out: the length of the head (u32), the head (JSON: [{"name", "type", "count"}, ...], filled up with spaces), then the
//      arrays one after the other, each filled up with zeros; every array begins at a multiple of 8. Little endian. The
//      types are u8, u32, u64, f32 and f64.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace sightline::cli {

class ArrayBlock {
 public:
  void add(const char* name, const std::vector<std::uint8_t>& values) { append(name, "u8", values); }
  void add(const char* name, const std::vector<std::uint32_t>& values) { append(name, "u32", values); }
  void add(const char* name, const std::vector<std::uint64_t>& values) { append(name, "u64", values); }
  void add(const char* name, const std::vector<float>& values) { append(name, "f32", values); }
  void add(const char* name, const std::vector<double>& values) { append(name, "f64", values); }

  [[nodiscard]] std::string bytes() const;

 private:
  template <class Number>
  void append(const char* name, const char* type, const std::vector<Number>& values);

  nlohmann::ordered_json head_ = nlohmann::ordered_json::array();
  std::string body_;
};

}  // namespace sightline::cli
