#include <expat.h>
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <new>
#include <optional>

#include "cli/cameras/document.h"
#include "geometry/numbers/errors.h"

namespace sightline::cli {

namespace {

struct XmlElement {
  std::string name;
  std::size_t line = 0;
  std::string text;
  std::vector<DocumentMember> children;
};

bool is_blank_text(std::string_view text) { return text.find_first_not_of(" \t\r\n") == std::string_view::npos; }

std::string_view trimmed_text(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  return text.substr(0, text.find_last_not_of(" \t\r\n") + 1);
}

bool is_xml_list(const XmlElement& element) {
  return std::ranges::all_of(element.children, [](const DocumentMember& child) { return child.key == "_"; });
}

std::optional<std::string> repeated_child(const XmlElement& element) {
  std::vector<std::string> names;
  for (const DocumentMember& child : element.children) names.push_back(child.key);
  std::ranges::sort(names);
  const auto same = std::ranges::adjacent_find(names);
  return same == names.end() ? std::nullopt : std::optional(*same);
}

// What expat meets. Its functions are C, which no exception may leave: the first refusal is kept, and parsing stops.
class XmlEvents {
 public:
  XmlEvents(XML_Parser parser, const std::string& file) : parser_(parser), file_(&file) {
    XML_SetUserData(parser, this);
    XML_SetElementHandler(
        parser, [](void* self, const char* name, const char** /*attributes*/) { at(self).start(name); },
        [](void* self, const char* /*name*/) { at(self).end(); });
    XML_SetCharacterDataHandler(parser, [](void* self, const char* text, int size) {
      at(self).append({text, static_cast<std::size_t>(size)});
    });
    XML_SetStartDoctypeDeclHandler(parser, [](void* self, const char*, const char*, const char*, int) {
      at(self).refuse("a document type; remove the line <!DOCTYPE ...>");
    });
  }

  [[nodiscard]] std::size_t line() const { return XML_GetCurrentLineNumber(parser_); }
  [[nodiscard]] const std::optional<InputError>& refusal() const { return refusal_; }
  [[nodiscard]] DocumentMember& root() { return roots_.front(); }

 private:
  static XmlEvents& at(void* self) { return *static_cast<XmlEvents*>(self); }

  void refuse(const std::string& cause) {
    if (!refusal_) refusal_.emplace(*file_, line(), cause);
    XML_StopParser(parser_, XML_FALSE);
  }

  void start(const char* name) {
    if (refusal_) return;
    if (open_.size() >= deepest)
      return refuse(fmt::format("more than {} levels, and no camera file is so deep; export it again", deepest));
    if (++nodes_ > most_nodes) return refuse(fmt::format("more than {} values; divide the file", most_nodes));
    open_.push_back({name, line(), {}, {}});
  }

  void append(std::string_view text) {
    if (!refusal_ && !open_.empty()) open_.back().text += text;
  }

  void end() {
    if (refusal_) return;
    XmlElement element = std::move(open_.back());
    open_.pop_back();
    DocumentNode node;
    node.line = element.line;
    if (element.children.empty()) {
      node.text = trimmed_text(element.text);
    } else if (!is_blank_text(element.text)) {
      return refuse("text beside elements; remove it");
    } else if (is_xml_list(element)) {
      node.kind = DocumentNode::Kind::list;
      for (DocumentMember& child : element.children) node.items.push_back(std::move(child.value));
    } else if (repeated_child(element)) {
      return refuse("an element has two children of one name; remove one of them");
    } else {
      node.kind = DocumentNode::Kind::table;
      node.members = std::move(element.children);
    }
    auto& siblings = open_.empty() ? roots_ : open_.back().children;
    siblings.push_back({std::move(element.name), std::move(node)});
  }

  XML_Parser parser_;
  const std::string* file_;
  std::vector<XmlElement> open_;
  std::vector<DocumentMember> roots_;
  std::optional<InputError> refusal_;
  std::size_t nodes_ = 0;
};

// expat takes a length as an int: a longer text in pieces.
bool parse_in_pieces(XML_Parser parser, std::string_view text) {
  constexpr std::size_t piece = std::size_t{1} << 20;
  for (;;) {
    const std::string_view next = text.substr(0, piece);
    text.remove_prefix(next.size());
    if (XML_Parse(parser, next.data(), static_cast<int>(next.size()), text.empty() ? 1 : 0) != XML_STATUS_OK)
      return false;
    if (text.empty()) return true;
  }
}

}  // namespace

DocumentNode parse_xml(std::string_view text, const std::string& file) {
  const std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser(XML_ParserCreate(nullptr), &XML_ParserFree);
  if (!parser) throw std::bad_alloc();
  XmlEvents events(parser.get(), file);
  const bool is_well_formed = parse_in_pieces(parser.get(), text);
  if (events.refusal()) throw InputError(*events.refusal());
  if (!is_well_formed) {
    const char* const cause = XML_ErrorString(XML_GetErrorCode(parser.get()));
    throw InputError(file, events.line(), fmt::format("not valid XML: {}; correct it", cause));
  }
  DocumentMember& root = events.root();
  if (root.key != "opencv_storage" || root.value.kind != DocumentNode::Kind::table) {
    throw InputError(file, root.value.line,
                     "XML that is not OpenCV's: its outer element is <opencv_storage>, with a camera in it; export the "
                     "camera with cv::FileStorage");
  }
  return std::move(root.value);
}

}  // namespace sightline::cli
