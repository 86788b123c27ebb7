// This is a strict reader for the small part of XML that the SVG writer may use.
//
// It throws std::runtime_error where the text is not well-formed: tags that do not match, attributes without quotes or
// twice, a bare '<' or '&', no or several root elements.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace sightline::tests {

struct XmlElement {
  std::string name;
  std::map<std::string, std::string> attributes;
};

// Returns all elements in document order.
[[nodiscard]] std::vector<XmlElement> read_xml(const std::string& text);

}  // namespace sightline::tests
