// XML, element by element, while its text comes: Expat, with exceptions let through.
//
// Errors: std::runtime_error with the cause and line: text that is no XML, a DTD (entities), a tag of more than 1 MiB; and
//         whatever the functions throw that are called.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace sightline::inline formats {

// The attributes of an element, as Expat gives them.
class XmlAttributes {
 public:
  explicit XmlAttributes(const char** names_and_values) : names_and_values_(names_and_values) {}
  [[nodiscard]] std::optional<std::string_view> find(std::string_view name) const;

 private:
  const char** names_and_values_;
};

// Names of elements, and of attributes that have a prefix, are NAMESPACE|NAME.
struct XmlEvents {
  std::function<void(std::string_view element, const XmlAttributes& attributes)> start;
  std::function<void(std::string_view element)> end;
  std::function<void(std::string_view prefix, std::string_view name_space)> name_space;
};

class XmlText {
 public:
  explicit XmlText(XmlEvents events);
  XmlText(const XmlText&) = delete;
  XmlText& operator=(const XmlText&) = delete;
  ~XmlText();

  void take(std::string_view portion);
  void end();
  // Returns the line of the event, from 1.
  [[nodiscard]] std::size_t line() const;

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
};

}  // namespace sightline::inline formats
