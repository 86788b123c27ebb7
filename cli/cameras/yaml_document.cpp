#include <fmt/format.h>
#include <yaml.h>

#include <algorithm>
#include <new>

#include "cli/cameras/document.h"
#include "cli/cameras/document_builder.h"
#include "formats/reading/printable.h"
#include "geometry/numbers/errors.h"

namespace sightline::cli {

namespace {

// Parser and event are structures of C that have to be freed.
struct YamlParser {
  YamlParser() {
    if (yaml_parser_initialize(&parser) == 0) throw std::bad_alloc();
  }
  YamlParser(const YamlParser&) = delete;
  YamlParser& operator=(const YamlParser&) = delete;
  ~YamlParser() { yaml_parser_delete(&parser); }
  yaml_parser_t parser{};
};

struct YamlEvent {
  YamlEvent() = default;
  YamlEvent(const YamlEvent&) = delete;
  YamlEvent& operator=(const YamlEvent&) = delete;
  ~YamlEvent() { yaml_event_delete(&event); }
  yaml_event_t event{};
};

// Returns the text with the first line's characters gone where it is a directive of the version; its end stays, so that
// lines keep their numbers.
std::string_view without_version(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  if (text.starts_with("%YAML")) text.remove_prefix(std::min(text.find_first_of("\r\n"), text.size()));
  return text;
}

// libyaml counts line ends that no editor counts, too (U+0085, U+2028): no line is past the last one.
std::size_t line_of_mark(const yaml_mark_t& mark, std::size_t lines) { return std::min(mark.line + 1, lines); }

[[noreturn]] void refuse_yaml(const yaml_parser_t& parser, const std::string& file, std::size_t lines) {
  if (parser.error == YAML_MEMORY_ERROR) throw std::bad_alloc();
  const bool has_mark = parser.error != YAML_READER_ERROR;
  throw InputError(
      file, has_mark ? line_of_mark(parser.problem_mark, lines) : 0,
      fmt::format("not valid YAML: {}; correct it", printable(parser.problem == nullptr ? "" : parser.problem, 200)));
}

[[noreturn]] void refuse_line_of_yaml(const std::string& file, std::size_t line, const char* cause) {
  throw InputError(file, line, cause);
}

// Hands one event over; a text where a table expects a key is one.
void pass_on(const yaml_event_t& event, DocumentBuilder& builder, const std::string& file, std::size_t lines) {
  const std::size_t line = line_of_mark(event.start_mark, lines);
  if (builder.expects_key() && event.type != YAML_SCALAR_EVENT && event.type != YAML_MAPPING_END_EVENT)
    refuse_line_of_yaml(file, line, "a key is no text; write a word");
  switch (event.type) {
    case YAML_SCALAR_EVENT: {
      std::string text(reinterpret_cast<const char*>(event.data.scalar.value), event.data.scalar.length);
      if (builder.expects_key()) return builder.key(std::move(text), line);
      return builder.scalar(std::move(text), line);
    }
    case YAML_SEQUENCE_START_EVENT:
      return builder.begin(DocumentNode::Kind::list, line);
    case YAML_MAPPING_START_EVENT:
      return builder.begin(DocumentNode::Kind::table, line);
    case YAML_SEQUENCE_END_EVENT:
    case YAML_MAPPING_END_EVENT:
      return builder.end();
    case YAML_ALIAS_EVENT:
      refuse_line_of_yaml(file, line, "an alias (*); write out what it stands for");
    default:
      return;
  }
}

}  // namespace

DocumentNode parse_yaml(std::string_view text, const std::string& file) {
  YamlParser yaml;
  const std::string_view rest = without_version(text);
  const auto lines = static_cast<std::size_t>(std::ranges::count(text, '\n')) + 1;
  yaml_parser_set_input_string(&yaml.parser, reinterpret_cast<const unsigned char*>(rest.data()), rest.size());
  yaml_parser_set_encoding(&yaml.parser, YAML_UTF8_ENCODING);
  DocumentBuilder builder(file);
  for (bool ends = false; !ends;) {
    YamlEvent next;
    if (yaml_parser_parse(&yaml.parser, &next.event) == 0) refuse_yaml(yaml.parser, file, lines);
    ends = next.event.type == YAML_STREAM_END_EVENT;
    pass_on(next.event, builder, file, lines);
  }
  return builder.finished();
}

}  // namespace sightline::cli
