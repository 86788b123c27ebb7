#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "cli/cameras/document.h"
#include "cli/cameras/document_builder.h"
#include "formats/reading/printable.h"
#include "geometry/numbers/errors.h"

namespace sightline::cli {

namespace {

struct TextPlace {
  std::size_t line = 1;
  char last = ' ';
};

// Characters one after the other; `place` knows how many lines have gone by.
class LineCountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  LineCountingIterator(const char* at, TextPlace* place) : at_(at), place_(place) {}
  const char& operator*() const { return *at_; }
  LineCountingIterator& operator++() {
    place_->last = *at_++;
    if (place_->last == '\n') ++place_->line;
    return *this;
  }
  LineCountingIterator operator++(int) {
    const LineCountingIterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const LineCountingIterator& other) const { return at_ == other.at_; }
  bool operator!=(const LineCountingIterator& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  TextPlace* place_;
};

// What the parser meets, as its interface has it: each returns whether to go on.
class JsonEvents {
 public:
  JsonEvents(DocumentBuilder& builder, const TextPlace& place, const std::string& file)
      : builder_(&builder), place_(&place), file_(&file) {}

  bool null() { return scalar("null"); }
  bool boolean(bool value) { return scalar(value ? "true" : "false"); }
  bool number_integer(std::int64_t value) { return number(std::to_string(value)); }
  bool number_unsigned(std::uint64_t value) { return number(std::to_string(value)); }
  bool number_float(double /*value*/, const std::string& text) { return number(text); }
  bool string(std::string& value) { return scalar(value); }
  static bool binary(nlohmann::json::binary_t& /*value*/) { return false; }
  bool start_object(std::size_t /*size*/) { return begin(DocumentNode::Kind::table); }
  bool start_array(std::size_t /*size*/) { return begin(DocumentNode::Kind::list); }
  bool end_object() { return end(); }
  bool end_array() { return end(); }
  bool key(std::string& text) {
    builder_->key(text, place_->line);
    return true;
  }
  [[noreturn]] bool parse_error(std::size_t /*position*/, const std::string& /*token*/,
                                const nlohmann::json::exception& error) {
    throw InputError(*file_, line(),
                     fmt::format("not valid JSON: {}; correct it", printable(cause_of(error.what()), 200)));
  }

 private:
  // What the library says of where an error is, and of how it calls the error, is left out.
  [[nodiscard]] static std::string_view cause_of(std::string_view message) {
    message.remove_prefix(std::min(message.find("] "), message.size() - 2) + 2);
    const std::size_t place = message.find(": ");
    return message.starts_with("parse error at") && place < message.size() ? message.substr(place + 2) : message;
  }

  // The parser knows that a number ends once it has read the character after it.
  [[nodiscard]] std::size_t line() const { return place_->line - (place_->last == '\n' ? 1 : 0); }
  bool number(std::string text) {
    builder_->scalar(std::move(text), line());
    return true;
  }
  bool scalar(std::string text) {
    builder_->scalar(std::move(text), place_->line);
    return true;
  }
  bool begin(DocumentNode::Kind kind) {
    builder_->begin(kind, place_->line);
    return true;
  }
  bool end() {
    builder_->end();
    return true;
  }

  DocumentBuilder* builder_;
  const TextPlace* place_;
  const std::string* file_;
};

}  // namespace

DocumentNode parse_json(std::string_view text, const std::string& file) {
  TextPlace place;
  DocumentBuilder builder(file);
  JsonEvents events(builder, place, file);
  nlohmann::json::sax_parse(LineCountingIterator(text.data(), &place),
                            LineCountingIterator(text.data() + text.size(), &place), &events);
  return builder.finished();
}

}  // namespace sightline::cli
