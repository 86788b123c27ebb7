// The bytes of an input are choices, one byte each: what a fuzzer changes in one place changes one choice.
#pragma once

#include <string_view>

namespace sightline::fuzz {

class Choices {
 public:
  explicit Choices(std::string_view bytes) : rest_(bytes) {}

  [[nodiscard]] bool any_left() const { return !rest_.empty(); }

  // Returns a number in [low, high], which are at most 256 numbers; low where no bytes are left.
  int between(int low, int high) {
    if (rest_.empty()) return low;
    const int byte = static_cast<unsigned char>(rest_.front());
    rest_.remove_prefix(1);
    return low + byte % (high - low + 1);
  }

  template <class Container>
  const auto& any_of(const Container& items) {
    return items[static_cast<std::size_t>(between(0, static_cast<int>(items.size()) - 1))];
  }

 private:
  std::string_view rest_;
};

}  // namespace sightline::fuzz
