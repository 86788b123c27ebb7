#include "formats/importing/xml_events.h"

#ifdef SIGHTLINE_HAS_EXPAT

#include <expat.h>

#include <exception>
#include <new>
#include <stdexcept>

namespace sightline::inline formats {

// Expat is C: what is thrown is kept until it has returned.
struct XmlText::Parser {
  XML_Parser expat = nullptr;
  XmlEvents events;
  std::exception_ptr thrown;
  std::size_t since_event = 0;

  template <class Function>
  void guarded(const Function& function) {
    since_event = 0;
    if (thrown) return;
    try {
      function();
    } catch (...) {
      thrown = std::current_exception();
      XML_StopParser(expat, XML_FALSE);
    }
  }

  void parse(std::string_view portion, bool is_last) const {
    const auto status = XML_Parse(expat, portion.data(), static_cast<int>(portion.size()), is_last ? 1 : 0);
    if (thrown) std::rethrow_exception(thrown);
    if (status != XML_STATUS_OK) throw std::runtime_error(XML_ErrorString(XML_GetErrorCode(expat)));
  }
};

namespace {

constexpr std::size_t longest_tag = std::size_t{1} << 20;
constexpr std::size_t longest_portion = std::size_t{1} << 16;

}  // namespace

std::optional<std::string_view> XmlAttributes::find(std::string_view name) const {
  for (const char** at = names_and_values_; *at != nullptr; at += 2) {
    if (*at == name) return at[1];
  }
  return std::nullopt;
}

XmlText::XmlText(XmlEvents events) : parser_(std::make_unique<Parser>()) {
  parser_->events = std::move(events);
  parser_->expat = XML_ParserCreateNS(nullptr, '|');
  if (parser_->expat == nullptr) throw std::bad_alloc();
  XML_SetUserData(parser_->expat, parser_.get());
  XML_SetElementHandler(
      parser_->expat,
      [](void* parser, const char* element, const char** attributes) {
        auto& p = *static_cast<Parser*>(parser);
        p.guarded([&] { p.events.start(element, XmlAttributes(attributes)); });
      },
      [](void* parser, const char* element) {
        auto& p = *static_cast<Parser*>(parser);
        p.guarded([&] { p.events.end(element); });
      });
  XML_SetStartNamespaceDeclHandler(parser_->expat, [](void* parser, const char* prefix, const char* uri) {
    auto& p = *static_cast<Parser*>(parser);
    p.guarded([&] { p.events.name_space(prefix == nullptr ? "" : prefix, uri == nullptr ? "" : uri); });
  });
  XML_SetStartDoctypeDeclHandler(parser_->expat, [](void* parser, const char*, const char*, const char*, int) {
    static_cast<Parser*>(parser)->guarded([] { throw std::runtime_error("a DTD, which is not read"); });
  });
  XML_SetDefaultHandler(parser_->expat,
                        [](void* parser, const char*, int) { static_cast<Parser*>(parser)->since_event = 0; });
}

XmlText::~XmlText() { XML_ParserFree(parser_->expat); }

void XmlText::take(std::string_view portion) {
  while (!portion.empty()) {
    const std::string_view part = portion.substr(0, longest_portion);
    portion.remove_prefix(part.size());
    parser_->since_event += part.size();
    if (parser_->since_event > longest_tag) throw std::runtime_error("a tag of more than 1 MiB");
    parser_->parse(part, false);
  }
}

void XmlText::end() { parser_->parse({}, true); }

std::size_t XmlText::line() const { return XML_GetCurrentLineNumber(parser_->expat); }

}  // namespace sightline::inline formats

#endif
