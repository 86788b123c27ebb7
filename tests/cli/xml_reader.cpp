#include "tests/cli/xml_reader.h"

#include <cctype>
#include <stdexcept>

namespace sightline::tests {

namespace {

class XmlReader {
 public:
  explicit XmlReader(const std::string& text) : text_(text) {}

  std::vector<XmlElement> read() {
    while (at_ < text_.size()) {
      if (text_[at_] == '<') {
        read_tag();
      } else {
        read_character();
      }
    }
    require(open_.empty() && !elements_.empty(), "an element is not closed");
    return elements_;
  }

 private:
  void require(bool holds, const char* what) const {
    if (!holds) throw std::runtime_error("not well-formed XML at byte " + std::to_string(at_) + ": " + what);
  }

  char next() {
    require(at_ < text_.size(), "the text ends too early");
    return text_[at_++];
  }

  bool skip(char c) {
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }

  void skip_blanks() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  }

  std::string read_name() {
    std::string name;
    while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 ||
                                  std::string("-_:.").find(text_[at_]) != std::string::npos)) {
      name += next();
    }
    require(!name.empty(), "a name is missing");
    return name;
  }

  // Outside of tags there may be text only within the root, and references where '&' stands.
  void read_character() {
    const char c = next();
    require(!open_.empty() || std::isspace(static_cast<unsigned char>(c)) != 0, "text outside of the root");
    if (c == '&') read_reference();
  }

  void read_reference() {
    const std::string name = read_name();
    require((name == "amp" || name == "lt" || name == "gt" || name == "quot") && skip(';'), "a bare '&'");
  }

  void read_tag() {
    require(skip('<'), "no tag");
    if (skip('/')) {
      const std::string name = read_name();
      require(!open_.empty() && open_.back() == name && skip('>'), "the end tag does not match");
      open_.pop_back();
      return;
    }
    require(!open_.empty() || elements_.empty(), "a second root");
    elements_.push_back({read_name(), {}});
    open_.push_back(elements_.back().name);
    read_attributes(elements_.back());
  }

  void read_attributes(XmlElement& element) {
    for (skip_blanks(); !skip('>'); skip_blanks()) {
      if (skip('/')) {
        open_.pop_back();
        require(skip('>'), "'/' inside a tag");
        return;
      }
      const std::string name = read_name();
      require(skip('=') && skip('"'), "an attribute without a quoted value");
      require(element.attributes.emplace(name, read_value()).second, "an attribute twice");
    }
  }

  std::string read_value() {
    std::string value;
    for (char c = next(); c != '"'; c = next()) {
      require(c != '<', "a bare '<' in a value");
      if (c == '&') read_reference();
      value += c;
    }
    return value;
  }

  const std::string& text_;
  std::size_t at_ = 0;
  std::vector<std::string> open_;
  std::vector<XmlElement> elements_;
};

}  // namespace

std::vector<XmlElement> read_xml(const std::string& text) { return XmlReader(text).read(); }

}  // namespace sightline::tests
