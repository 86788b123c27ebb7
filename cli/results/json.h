// JSON as the command writes it, and what values are in it.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "geometry/numbers/ids.h"
#include "geometry/numbers/vector3.h"
#include "reflect/world/panel.h"

namespace sightline::cli {

using Json = nlohmann::ordered_json;  // members keep the order in which they are written

[[nodiscard]] inline Json as_json(const Vector3& v) { return {v.x(), v.y(), v.z()}; }

[[nodiscard]] inline Json as_json(Emits emits) { return emits == Emits::front ? "front" : "both"; }

template <class Value>
[[nodiscard]] Json as_json(const std::optional<Value>& value) {
  return value ? Json(*value) : Json(nullptr);
}

template <class Tag>
[[nodiscard]] Json as_json(Id<Tag> id) {
  return id.valid() ? Json(id.value) : Json(nullptr);
}

// A list of what `convert` makes of each item.
template <class Items, class Convert>
[[nodiscard]] Json list_json(const Items& items, Convert convert) {
  Json list = Json::array();
  for (const auto& item : items) list.push_back(convert(item));
  return list;
}

template <class Tag>
[[nodiscard]] Json as_json(const std::vector<Id<Tag>>& ids) {
  return list_json(ids, [](Id<Tag> id) { return as_json(id); });
}

// Indented, with a line end; bytes that are not UTF-8 (in file names) are replaced.
[[nodiscard]] inline std::string json_text(const Json& json, int indent = 2) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace sightline::cli
