#include "cli/scene/panel_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "cli/scene/result_names.h"
#include "geometry/numbers/errors.h"

namespace sightline::cli {

namespace {

// A panel's name is a word in column names, group names and property names.
std::string read_panel_name(const TomlReader& table) {
  const std::string name = table.text("name");
  if (const auto defect = name_defect(name)) table.fail("name", "the panel's name " + *defect + "; choose another");
  const auto is_part_of_word = [](char c) { return c != ' ' && c != ',' && c != ';' && c != '#'; };
  if (!std::ranges::all_of(name, is_part_of_word))
    table.fail("name",
               "the panel's name has a space or one of , ; #, and it becomes a part of column names; choose another");
  return name;
}

Emits read_emits(const TomlReader& table) {
  if (!table.has("emits")) return Emits::both;
  const std::string emits = table.text("emits");
  if (emits != "front" && emits != "both") table.fail("emits", "'emits' must be \"front\" or \"both\"");
  return emits == "front" ? Emits::front : Emits::both;
}

double read_planarity(const TomlReader& table) {
  const double planarity = table.optional_number("planarity").value_or(default_planarity);
  if (!(planarity >= 0 && planarity < 1)) table.fail("planarity", "'planarity' must be at least 0 and below 1");
  return planarity;
}

// The key that makes a panel one of the three forms.
std::string form_of_panel(const TomlReader& table) {
  std::vector<std::string> found;
  for (const char* key : {"corners", "size", "radius"}) {
    if (table.has(key)) found.emplace_back(key);
  }
  if (found.empty()) table.fail("the panel has none of corners, size, radius; give exactly one");
  if (found.size() > 1)
    table.fail(found[1], fmt::format("the panel has both '{}' and '{}'; give exactly one", found[0], found[1]));
  return found[0];
}

double read_length(const TomlReader& table, const char* key, double length) {
  if (!(length > 0)) table.fail(key, fmt::format("'{}' must be above 0", key));
  return length;
}

// Where the panel is, and where its front looks.
struct Placed {
  Point3 center = Point3::Zero();
  Vector3 normal = Vector3::Zero();
};

Placed read_panel_place(const TomlReader& table) {
  if (table.has("normal") == table.has("target"))
    table.fail("the panel needs either 'normal' or 'target', which say where its front looks; give exactly one");
  const Point3 center = table.vector("center");
  const char* const key = table.has("normal") ? "normal" : "target";
  const Vector3 given = table.vector(key);
  const Vector3 normal = unit(table.has("normal") ? given : Vector3(given - center));
  if (normal.isZero(0))
    table.fail(key, "the panel's front looks nowhere: 'normal' must not be zero, nor 'target' be its 'center'");
  return {center, normal};
}

// The axes of a plane, seen from its front: to the right, and up.
struct Axes {
  Vector3 right = Vector3::Zero();
  Vector3 up = Vector3::Zero();
};

Axes axes_across(const Vector3& normal, const Vector3& up) {
  const Vector3 right = unit(with_moderate_exponent(up).cross(normal));
  return {right, normal.cross(right)};
}

std::vector<Point3> read_rectangle(const TomlReader& table) {
  const Placed place = read_panel_place(table);
  const auto [width, height] = table.pair("size");
  for (const double length : {width, height}) static_cast<void>(read_length(table, "size", length));
  const Axes axes = axes_across(place.normal, table.has("up") ? table.vector("up") : Vector3(0, 1, 0));
  if (axes.right.isZero(0)) table.fail("up", "the panel's 'up' is along its normal; choose another 'up'");
  const Vector3 across = width / 2 * axes.right;
  const Vector3 upwards = height / 2 * axes.up;
  const Point3& center = place.center;
  return {center - across - upwards, center + across - upwards, center + across + upwards, center - across + upwards};
}

// A polygon of n equal sides has the area of the circle of radius 1 where its corners are so far from the centre.
double corner_distance() {
  const double angle = 2 * std::numbers::pi / disc_corners;
  return std::sqrt(angle / std::sin(angle));
}

std::vector<Point3> read_disc(const TomlReader& table) {
  const Placed place = read_panel_place(table);
  const double radius = read_length(table, "radius", table.number("radius")) * corner_distance();
  const Vector3& n = place.normal;
  const bool is_upright = std::fabs(n.y()) > std::fabs(n.x()) && std::fabs(n.y()) > std::fabs(n.z());
  const Axes axes = axes_across(n, is_upright ? Vector3(0, 0, 1) : Vector3(0, 1, 0));
  std::vector<Point3> corners;
  for (int i = 0; i < disc_corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / disc_corners;
    corners.emplace_back(place.center + radius * (std::cos(angle) * axes.right + std::sin(angle) * axes.up));
  }
  return corners;
}

std::vector<Point3> read_corners(const TomlReader& table, const std::string& form) {
  if (form == "size") {
    table.allow_only({"name", "center", "normal", "target", "up", "size", "emits", "planarity"});
    return read_rectangle(table);
  }
  if (form == "radius") {
    table.allow_only({"name", "center", "normal", "target", "radius", "emits", "planarity"});
    return read_disc(table);
  }
  table.allow_only({"name", "corners", "emits", "planarity"});
  return table.points("corners");
}

}  // namespace

Panel read_panel(const TomlReader& table) {
  table.allow_only({"name", "corners", "center", "normal", "target", "up", "size", "radius", "emits", "planarity"});
  const std::string name = read_panel_name(table);
  const std::string form = form_of_panel(table);
  std::vector<Point3> corners = read_corners(table, form);
  const bool is_finite = std::ranges::all_of(corners, [](const Point3& p) { return p.allFinite(); });
  if (!is_finite) table.fail(form, "the panel's numbers are too large for double arithmetic; choose smaller ones");
  const Emits emits = read_emits(table);
  Panel panel{name, std::move(corners), emits, read_planarity(table)};
  try {
    static_cast<void>(panel_mesh(panel));
  } catch (const PanelError& error) {
    table.fail(form, error.what());
  }
  return panel;
}

}  // namespace sightline::cli
