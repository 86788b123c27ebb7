#include "cli/pages/array_block.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace sightline::cli {

namespace {

constexpr std::size_t alignment = 8;

std::size_t aligned(std::size_t size) { return (size + alignment - 1) / alignment * alignment; }

// Little endian, whatever the machine is.
template <class Number>
void append_bytes(std::string& out, const std::vector<Number>& values) {
  const std::size_t begin = out.size();
  out.resize(begin + values.size() * sizeof(Number));
  if (!values.empty()) std::memcpy(out.data() + begin, values.data(), values.size() * sizeof(Number));
  if constexpr (std::endian::native == std::endian::big) {
    for (char* at = out.data() + begin; at != out.data() + out.size(); at += sizeof(Number))
      std::reverse(at, at + sizeof(Number));
  }
}

}  // namespace

template <class Number>
void ArrayBlock::append(const char* name, const char* type, const std::vector<Number>& values) {
  head_.push_back({{"name", name}, {"type", type}, {"count", values.size()}});
  append_bytes(body_, values);
  body_.resize(aligned(body_.size()), '\0');
}

template void ArrayBlock::append(const char*, const char*, const std::vector<std::uint8_t>&);
template void ArrayBlock::append(const char*, const char*, const std::vector<std::uint32_t>&);
template void ArrayBlock::append(const char*, const char*, const std::vector<std::uint64_t>&);
template void ArrayBlock::append(const char*, const char*, const std::vector<float>&);
template void ArrayBlock::append(const char*, const char*, const std::vector<double>&);

std::string ArrayBlock::bytes() const {
  std::string head = head_.dump();
  const std::size_t begin = sizeof(std::uint32_t);
  head.resize(aligned(begin + head.size()) - begin, ' ');
  std::string out;
  append_bytes(out, std::vector{static_cast<std::uint32_t>(head.size())});
  return out + head + body_;
}

}  // namespace sightline::cli
