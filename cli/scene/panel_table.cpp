#include "cli/scene/panel_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/scene/camera_name.h"

namespace sightline::cli {

namespace {

// A panel's name is a word in column names, group names and property names.
std::string read_panel_name(const TomlReader& table) {
  const std::string name = table.text("name");
  if (const auto defect = camera_name_defect(name)) table.fail("name", "the panel's name " + *defect);
  const auto is_part_of_word = [](char c) { return c != ' ' && c != ',' && c != ';' && c != '#'; };
  if (!std::ranges::all_of(name, is_part_of_word))
    table.fail("name", "the panel's name has a space or one of , ; #; it becomes a part of column names");
  return name;
}

Emits read_emits(const TomlReader& table) {
  if (!table.has("emits")) return Emits::both;
  const std::string emits = table.text("emits");
  if (emits != "front" && emits != "both") table.fail("emits", "'emits' must be \"front\" or \"both\"");
  return emits == "front" ? Emits::front : Emits::both;
}

}  // namespace

Panel read_panel(const TomlReader& table) {
  table.allow_only({"name", "corners", "emits"});
  Panel panel{read_panel_name(table), table.points("corners"), read_emits(table)};
  try {
    static_cast<void>(panel_mesh(panel));
  } catch (const PanelError& error) {
    table.fail("corners", error.what());
  }
  return panel;
}

}  // namespace sightline::cli
