#include "cli/scene/reflection_table.h"

#include <fmt/format.h>

#include <string>

namespace sightline::cli {

namespace {

ReflectionMode read_mode(const TomlReader& table) {
  if (!table.has("mode")) return ReflectionMode::exact;
  const std::string word = table.text("mode");
  for (const ReflectionMode mode : {ReflectionMode::exact, ReflectionMode::triangles, ReflectionMode::smooth}) {
    if (word == to_string(mode)) return mode;
  }
  table.fail("mode", "'mode' must be \"exact\", \"triangles\" or \"smooth\"");
}

MirrorNormals read_normals(const TomlReader& table) {
  const std::string word = table.text("normals");
  for (const MirrorNormals normals : {MirrorNormals::face, MirrorNormals::vertex}) {
    if (word == to_string(normals)) return normals;
  }
  table.fail("normals", "'normals' must be \"face\" or \"vertex\"");
}

double read_tolerance(const TomlReader& table) {
  const double tolerance = table.number("tolerance");
  if (!(tolerance > 0 && tolerance < 1)) table.fail("tolerance", "'tolerance' must be between 0 and 1");
  return tolerance;
}

NormalMeans read_means(const TomlReader& table) {
  const std::string word = table.text("means");
  for (const NormalMeans means : {NormalMeans::area, NormalMeans::plain}) {
    if (word == to_string(means)) return means;
  }
  table.fail("means", "'means' must be \"area\" or \"plain\"");
}

double read_crease_angle(const TomlReader& table) {
  const double angle = table.number("crease_angle_deg");
  if (!(angle >= 0 && angle <= 180)) table.fail("crease_angle_deg", "'crease_angle_deg' must be from 0 to 180");
  return angle;
}

}  // namespace

ReflectionOptions read_reflection(const TomlReader& table) {
  table.allow_only({"mode", "normals", "tolerance", "means", "crease_angle_deg", "mirrors", "mirrors_material"});
  ReflectionOptions options;
  options.mode = read_mode(table);
  const auto only_for = [&](const char* key, ReflectionMode mode) {
    if (!table.has(key)) return false;
    if (options.mode != mode)
      table.fail(key,
                 fmt::format("'{}' is for mode \"{}\" only; leave it out, or set that mode", key, to_string(mode)));
    return true;
  };
  if (only_for("normals", ReflectionMode::triangles)) options.normals = read_normals(table);
  if (only_for("tolerance", ReflectionMode::smooth)) options.tolerance = read_tolerance(table);
  for (const char* key : {"means", "crease_angle_deg"}) {
    if (table.has(key) && !options.needs_vertex_normals())
      table.fail(
          key, fmt::format(
                   "'{}' is for modes that have vertex normals: \"smooth\" and \"triangles\"; leave it out, or set one",
                   key));
  }
  if (table.has("means")) options.means = read_means(table);
  if (table.has("crease_angle_deg")) options.crease_angle_degrees = read_crease_angle(table);
  return options;
}

}  // namespace sightline::cli
